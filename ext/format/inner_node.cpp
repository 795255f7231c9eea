#include "format/inner_node.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foresee {
namespace {

enum EntryNumber { t_min, t_max, until_max, first_bound };

std::size_t count_of(std::span<const std::byte> blob) {
  return load_number<std::uint16_t>(blob.data() + NodeFormat::count_at);
}

/// Number of doubles of an entry that are stored: a prefix of the entry in memory.
std::size_t stored_numbers(const NodeFormat& format) {
  // The child's number comes first, the kinds last.
  return format.inner_entry_size / sizeof(double) - 1 - has_kinds(format.layout);
}

/// Where an entry has its kinds: category and mask, of four bytes each.
std::size_t kinds_offset(const NodeFormat& format) {
  return format.inner_entry_size - 2 * sizeof(std::uint32_t);
}

void store_kinds(std::byte* at, Kinds kinds) {
  store_number(at, kinds.category);
  store_number(at + sizeof kinds.category, kinds.mask);
}

Kinds load_kinds(const std::byte* at) {
  return {load_number<std::uint32_t>(at), load_number<std::uint32_t>(at + sizeof(std::uint32_t))};
}

/// False for NaN. A lower bound of -infinity and an upper bound of infinity mean "unbounded".
bool ordered(double lower, double upper) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return lower <= upper && lower < infinity && upper > -infinity;
}

const char* entry_fault(const NodeFormat& format, const std::byte* entry, std::int64_t number) {
  const auto child = load_number<std::int64_t>(entry);
  if (child < 1 || child == number) return "a child is not another node";
  const auto value = [entry](std::size_t i) { return load_number<double>(entry + (i + 1) * sizeof(double)); };
  if (!std::isfinite(value(t_min)) || !std::isfinite(value(t_max)) || value(t_min) > value(t_max))
    return "reference times are out of order";
  if (!(value(until_max) >= value(t_min))) return "a child ends before it starts";
  const auto axes = static_cast<std::size_t>(format.layout.axes);
  for (std::size_t at = first_bound; at < stored_numbers(format); at += 2 * axes)
    for (std::size_t axis = 0; axis < axes; ++axis)
      if (!ordered(value(at + axis), value(at + axes + axis))) return "bounds are out of order";
  return nullptr;
}

bool has_child_twice(const NodeFormat& format, const std::byte* entries, std::size_t count) {
  std::vector<std::int64_t> children(count);
  for (std::size_t i = 0; i < count; ++i)
    children[i] = load_number<std::int64_t>(entries + i * format.inner_entry_size);
  std::sort(children.begin(), children.end());
  return std::adjacent_find(children.begin(), children.end()) != children.end();
}

}  // namespace

std::vector<std::byte> encode_inner(const NodeFormat& format, std::int64_t number, const Node& node) {
  if (node.level > std::numeric_limits<std::uint8_t>::max() || node.size() > format.inner_capacity)
    throw BrokenTree("a tree node does not fit into its row");
  std::vector<std::byte> blob(format.node_size);
  store_number(blob.data() + NodeFormat::level_at, static_cast<std::uint8_t>(node.level));
  store_number<std::uint8_t>(blob.data() + NodeFormat::format_at, NodeFormat::version);
  store_number(blob.data() + NodeFormat::count_at, static_cast<std::uint16_t>(node.size()));
  store_number(blob.data() + NodeFormat::parent_at, node.parent);
  store_number(blob.data() + NodeFormat::epoch_at, node.epoch);
  const auto stride = static_cast<std::size_t>(entry_size(format.layout.axes));
  std::byte* entry = blob.data() + NodeFormat::entries_at;
  for (std::size_t slot = 0; slot < node.size(); ++slot, entry += format.inner_entry_size) {
    store_number(entry, node.keys[slot]);
    std::memcpy(entry + sizeof(std::int64_t), node.values.data() + slot * stride,
                stored_numbers(format) * sizeof(double));
    if (has_kinds(format.layout)) store_kinds(entry + kinds_offset(format), kinds_at(node, slot));
  }
  seal_node(blob, number);
  return blob;
}

const char* inner_fault(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number) {
  if (const char* fault = node_fault(format, blob, number)) return fault;
  if (load_number<std::uint8_t>(blob.data() + NodeFormat::level_at) == 0) return "it is not an inner node";
  const std::size_t count = count_of(blob);
  if (count < 1 || count > format.inner_capacity) return "its count is wrong";
  if (!std::isfinite(load_number<double>(blob.data() + NodeFormat::epoch_at)))
    return "its epoch is not finite";
  for (std::size_t i = 0; i < count; ++i)
    if (const char* fault =
            entry_fault(format, blob.data() + NodeFormat::entries_at + i * format.inner_entry_size, number))
      return fault;
  if (has_child_twice(format, blob.data() + NodeFormat::entries_at, count)) return "a child is named twice";
  return nullptr;
}

bool is_inner(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number) {
  return blob.size() == format.node_size && blob[NodeFormat::level_at] != std::byte{0} &&
         node_fault(format, blob, number) == nullptr;
}

Node decode_inner(const NodeFormat& format, std::span<const std::byte> blob) {
  const auto axes = static_cast<std::size_t>(format.layout.axes);
  const auto stride = static_cast<std::size_t>(entry_size(format.layout.axes));
  Node node;
  node.level = load_number<std::uint8_t>(blob.data() + NodeFormat::level_at);
  node.parent = load_number<std::int64_t>(blob.data() + NodeFormat::parent_at);
  node.epoch = load_number<double>(blob.data() + NodeFormat::epoch_at);
  const std::size_t count = count_of(blob);
  node.keys.reserve(count + 1);  // a node overflows by one entry before the tree splits it
  node.values.reserve((count + 1) * stride);
  node.values.resize(count * stride, 0.0);
  const std::byte* entry = blob.data() + NodeFormat::entries_at;
  for (std::size_t slot = 0; slot < count; ++slot, entry += format.inner_entry_size) {
    node.keys.push_back(load_number<std::int64_t>(entry));
    double* values = node.values.data() + slot * stride;
    std::memcpy(values, entry + sizeof(std::int64_t), stored_numbers(format) * sizeof(double));
    if (has_kinds(format.layout)) set_kinds(node, slot, load_kinds(entry + kinds_offset(format)));
    if (bounds_move(format.layout)) continue;
    std::fill_n(values + first_bound + 2 * axes, axes, -rest_velocity_pad);
    std::fill_n(values + first_bound + 3 * axes, axes, rest_velocity_pad);
  }
  return node;
}

}  // namespace foresee
