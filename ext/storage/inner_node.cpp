#include "storage/inner_node.h"

#include <cmath>

namespace foresee {
namespace {

// Calls each(number) for everything in an entry in the order of its bytes: the one place that knows it.
template <class Entry, class Each>
void for_each_number(const Layout& layout, Entry& entry, Each each) {
  each(entry.child);
  each(entry.t_least);
  each(entry.t_greatest);
  each(entry.until_greatest);
  const auto on_all_axes = [&](auto& bound) {
    for (int axis = 0; axis < layout.axes; ++axis) each(bound[static_cast<std::size_t>(axis)]);
  };
  on_all_axes(entry.lower);
  on_all_axes(entry.upper);
  if (layout.law == Law::rest) return;
  on_all_axes(entry.v_lower);
  on_all_axes(entry.v_upper);
  if (layout.law == Law::uniform) return;
  on_all_axes(entry.a_lower);
  on_all_axes(entry.a_upper);
}

bool ordered(const std::array<double, 3>& lower, const std::array<double, 3>& upper) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(lower[axis] <= upper[axis])) return false;  // not a number is not ordered
  return true;
}

const char* entry_fault(const InnerEntry& entry, std::int64_t number) {
  if (entry.child < 1 || entry.child == number) return "a child is no other node";
  if (!std::isfinite(entry.t_least) || !std::isfinite(entry.t_greatest) || entry.t_least > entry.t_greatest)
    return "reference times are out of order";
  if (!(entry.until_greatest >= entry.t_least)) return "a child ends before it begins";
  const bool fine = ordered(entry.lower, entry.upper) && ordered(entry.v_lower, entry.v_upper) &&
                    ordered(entry.a_lower, entry.a_upper);
  return fine ? nullptr : "bounds are out of order";
}

std::size_t count_of(std::span<const std::byte> blob) {
  return load_number<std::uint16_t>(blob.data() + NodeFormat::count_at);
}

}  // namespace

std::vector<std::byte> encode_inner(const NodeFormat& format, std::int64_t number, const InnerNode& node) {
  std::vector<std::byte> blob(format.node_size);
  store_number(blob.data() + NodeFormat::level_at, static_cast<std::uint8_t>(node.level));
  store_number<std::uint8_t>(blob.data() + NodeFormat::format_at, NodeFormat::version);
  store_number(blob.data() + NodeFormat::count_at, static_cast<std::uint16_t>(node.entries.size()));
  store_number(blob.data() + NodeFormat::parent_at, node.parent);
  store_number(blob.data() + NodeFormat::epoch_at, node.epoch);
  std::byte* at = blob.data() + NodeFormat::entries_at;
  for (const InnerEntry& entry : node.entries)
    for_each_number(format.layout, entry, [&](auto value) {
      store_number(at, value);
      at += sizeof value;
    });
  seal_node(blob, number);
  return blob;
}

const char* inner_fault(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number) {
  if (const char* fault = node_fault(format, blob, number)) return fault;
  if (load_number<std::uint8_t>(blob.data() + NodeFormat::level_at) == 0) return "it is no inner node";
  if (count_of(blob) < 1 || count_of(blob) > format.inner_capacity) return "its count is wrong";
  const InnerNode node = decode_inner(format, blob);
  if (!std::isfinite(node.epoch)) return "its epoch is not finite";
  for (const InnerEntry& entry : node.entries)
    if (const char* fault = entry_fault(entry, number)) return fault;
  return nullptr;
}

InnerNode decode_inner(const NodeFormat& format, std::span<const std::byte> blob) {
  InnerNode node;
  node.level = load_number<std::uint8_t>(blob.data() + NodeFormat::level_at);
  node.parent = load_number<std::int64_t>(blob.data() + NodeFormat::parent_at);
  node.epoch = load_number<double>(blob.data() + NodeFormat::epoch_at);
  node.entries.resize(count_of(blob));
  const std::byte* at = blob.data() + NodeFormat::entries_at;
  for (InnerEntry& entry : node.entries)
    for_each_number(format.layout, entry, [&](auto& value) {
      value = load_number<std::remove_reference_t<decltype(value)>>(at);
      at += sizeof value;
    });
  return node;
}

}  // namespace foresee
