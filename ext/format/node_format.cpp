#include "format/node_format.h"

#include <algorithm>

#include "format/crc32c.h"
#include "shape/kinds.h"

namespace foresee {
namespace {

constexpr std::size_t number_size = 8;

std::size_t record_bytes(const Layout& layout) {
  return number_size * static_cast<std::size_t>(record_offsets(layout).size);
}

// Child, smallest t, largest t, largest until; then two bounds per axis for position, velocity and
// acceleration, as far as the declaration has them. Last are the kinds, if it has category or mask.
std::size_t inner_entry_bytes(const Layout& layout) {
  const std::size_t bounded = !bounds_move(layout) ? 1 : degree_of(layout.law) < 2 ? 2 : 3;
  return number_size * (4 + 2 * bounded * static_cast<std::size_t>(layout.axes) + has_kinds(layout));
}

}  // namespace

NodeFormat::NodeFormat(const Layout& layout, std::size_t node_size)
    : layout(layout),
      at(record_offsets(layout)),
      node_size(node_size),
      record_size(record_bytes(layout)),
      leaf_capacity((node_size - ids_at - checksum_size) / (number_size + record_size)),
      records_at(ids_at + number_size * leaf_capacity),
      inner_entry_size(inner_entry_bytes(layout)),
      inner_capacity((node_size - entries_at - checksum_size) / inner_entry_size) {}

std::size_t NodeFormat::node_size_for(const Layout& layout, std::size_t page_size) {
  const std::size_t leaf = ids_at + min_capacity * (number_size + record_bytes(layout));
  const std::size_t inner = entries_at + min_capacity * inner_entry_bytes(layout);
  const std::size_t min_size = std::max(leaf, inner) + number_size;  // the checksum; a multiple of 8
  return std::max(page_size - page_reserve, min_size);
}

std::optional<std::size_t> NodeFormat::page_size_for(const Layout& layout, std::size_t node_size) {
  constexpr std::size_t smallest = 512, largest = 65536;
  for (std::size_t page = smallest; page <= largest; page *= 2)
    if (node_size_for(layout, page) == node_size) return page;
  return std::nullopt;
}

std::uint32_t node_checksum(std::span<const std::byte> node, std::int64_t number) {
  const std::uint32_t contents = crc32c(node.data(), node.size() - NodeFormat::checksum_size);
  return crc32c(&number, sizeof number, contents);
}

void seal_node(std::span<std::byte> node, std::int64_t number) {
  store_number(node.data() + node.size() - NodeFormat::checksum_size, node_checksum(node, number));
}

const char* node_fault(const NodeFormat& format, std::span<const std::byte> node, std::int64_t number) {
  if (node.size() != format.node_size) return "it does not have the size of a node";
  const auto* end = node.data() + node.size() - NodeFormat::checksum_size;
  if (load_number<std::uint32_t>(end) != node_checksum(node, number)) return "its checksum does not match";
  if (load_number<std::uint8_t>(node.data() + NodeFormat::format_at) != NodeFormat::version)
    return "its format is unknown";
  if (load_number<std::int64_t>(node.data() + NodeFormat::parent_at) < 0) return "its parent is not a node";
  return nullptr;
}

}  // namespace foresee
