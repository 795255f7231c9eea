#include "format/leaf_node.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "format/chunk_blob.h"
#include "format/form_blob.h"
#include "shape/kinds.h"
#include "shape/shapes.h"

namespace foresee {
namespace {

// Records are checked in place with unaligned loads: SQLite does not align blobs.
double number_at(const std::byte* record, int place) {
  return load_number<double>(record + static_cast<std::size_t>(place) * sizeof(double));
}

bool all_finite(const std::byte* numbers, std::size_t count) {
  constexpr std::uint64_t exponent = 0x7ff0000000000000;
  std::uint64_t found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = load_number<std::uint64_t>(numbers + i * sizeof(std::uint64_t));
    found |= static_cast<std::uint64_t>((bits & exponent) == exponent);
  }
  return found == 0;
}

const char* form_fault(const NodeFormat& format, const std::byte* record) {
  const bool mesh = format.layout.shape == Shape::mesh;
  const int axes = bounded_axes(format.layout.shape);
  const double number = number_at(record, format.at.outline);
  if (!(0 <= number && number <= static_cast<double>(largest_form_number) && number == std::floor(number)))
    return mesh ? "the number of a mesh is out of range" : "the number of an outline is out of range";
  if (format.at.heading != Offsets::absent && std::abs(number_at(record, format.at.heading)) > 360)
    return "a heading is beyond 360 degrees";
  for (int axis = 0; axis < axes; ++axis) {
    const double lower = number_at(record, format.at.bounds + axis);
    const double upper = number_at(record, format.at.bounds + axes + axis);
    if (lower > upper)
      return mesh ? "the bounds of a mesh are reversed" : "the bounds of an outline are reversed";
    if (number == 0 && (lower != 0 || upper != 0))
      return mesh ? "an object without a mesh has bounds" : "an object without an outline has bounds";
  }
  return nullptr;
}

const char* extent_fault(const NodeFormat& format, const std::byte* record) {
  const char* fault = nullptr;
  for_each_size(format.layout, [&](const SizeColumn& column) {
    const int axes = column.on_all_axes ? format.layout.axes : 1;
    for (int axis = 0; axis < axes; ++axis)
      if (number_at(record, format.at.*column.place + axis) < 0) fault = column.when_negative;
  });
  return !fault && is_stored_apart(format.layout.shape) ? form_fault(format, record) : fault;
}

const char* force_fault(const NodeFormat& format, const std::byte* record) {
  const double mass = number_at(record, format.at.mass);
  if (!(mass > 0)) return "a mass is not positive";
  for (int axis = 0; axis < format.layout.axes; ++axis)
    if (!std::isfinite(number_at(record, format.at.force + axis) / mass))
      return "an acceleration F/m overflows";
  return nullptr;
}

const char* until_fault(const NodeFormat& format, const std::byte* record) {
  const double start = format.at.t == Offsets::absent ? 0.0 : number_at(record, format.at.t);
  return number_at(record, format.at.until) >= start ? nullptr : "an object ends before it starts";
}

bool is_kind(double number) {
  return 0 <= number && number <= every_kind && number == std::floor(number);
}

const char* kinds_fault(const NodeFormat& format, const std::byte* record) {
  if (format.layout.has_category && !is_kind(number_at(record, format.at.category)))
    return "a category is not a whole number from 0 to 4294967295";
  if (format.layout.has_mask && !is_kind(number_at(record, format.at.mask)))
    return "a mask is not a whole number from 0 to 4294967295";
  return nullptr;
}

const char* plan_fault(const NodeFormat& format, const std::byte* record) {
  const double first = number_at(record, format.at.plan), chunks = number_at(record, format.at.chunks);
  const auto is_number = [](double number, double upper) {
    return 0 <= number && number <= upper && number == std::floor(number);
  };
  if (!is_number(first, static_cast<double>(largest_chunk_number)) ||
      !is_number(chunks, static_cast<double>(max_plan_legs)) || (first == 0) != (chunks == 0))
    return "the number of a plan is out of range";
  return nullptr;
}

const char* records_fault(const NodeFormat& format, const std::byte* records, std::size_t count) {
  constexpr const char* not_finite = "a number is not finite";
  // `until` may be +infinity; it comes last, but for kinds and plans, which are checked alone.
  const bool ends = format.layout.has_until;
  const auto size = static_cast<std::size_t>(format.at.size);
  if (!ends && !all_finite(records, count * size)) return not_finite;
  const bool extended = format.layout.shape != Shape::point, forced = format.layout.law == Law::forced;
  const bool kinds = has_kinds(format.layout), plans = format.layout.has_plan;
  if (!ends && !extended && !forced && !kinds && !plans) return nullptr;
  for (const std::byte* record = records; record != records + count * format.record_size;
       record += format.record_size) {
    if (ends && !all_finite(record, static_cast<std::size_t>(format.at.until))) return not_finite;
    const char* fault = extended ? extent_fault(format, record) : nullptr;
    if (!fault && ends) fault = until_fault(format, record);
    if (!fault && kinds) fault = kinds_fault(format, record);
    if (!fault && forced) fault = force_fault(format, record);
    if (!fault && plans) fault = plan_fault(format, record);
    if (fault) return fault;
  }
  return nullptr;
}

}  // namespace

const char* record_fault(const NodeFormat& format, const double* record) {
  return records_fault(format, reinterpret_cast<const std::byte*>(record), 1);
}

const char* leaf_fault(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number) {
  if (const char* fault = node_fault(format, blob, number)) return fault;
  if (load_number<std::uint8_t>(blob.data() + NodeFormat::level_at) != 0) return "it is not a leaf";
  const LeafView leaf(format, blob);
  const int count = leaf.count();
  if (count < 1 || static_cast<std::size_t>(count) > format.leaf_capacity) return "its count is wrong";
  for (int i = 1; i < count; ++i)
    if (leaf.id(i - 1) >= leaf.id(i)) return "its ids do not ascend";
  return records_fault(format, blob.data() + format.records_at, static_cast<std::size_t>(count));
}

int LeafView::lower_bound(std::int64_t id) const {
  int low = 0, high = count();
  if (high > 0 && this->id(high - 1) < id) return high;  // ids mostly arrive ascending
  while (low < high) {
    const int middle = (low + high) / 2;
    if (this->id(middle) < id)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

int LeafView::find(std::int64_t id) const {
  const int i = lower_bound(id);
  return i < count() && this->id(i) == id ? i : -1;
}

void LeafView::copy_ids(std::int64_t* ids) const {
  std::memcpy(ids, id_at(0), static_cast<std::size_t>(count()) * sizeof *ids);
}

void LeafView::copy_records(double* records) const {
  std::memcpy(records, record_at(0), static_cast<std::size_t>(count()) * format_->record_size);
}

std::vector<std::byte> encode_leaf(const NodeFormat& format, std::int64_t number, const Node& leaf) {
  if (leaf.size() > format.leaf_capacity) throw BrokenTree("a tree node does not fit into its row");
  std::vector<std::byte> blob(format.node_size);
  store_number<std::uint8_t>(blob.data() + NodeFormat::format_at, NodeFormat::version);
  store_number(blob.data() + NodeFormat::count_at, static_cast<std::uint16_t>(leaf.size()));
  store_number(blob.data() + NodeFormat::parent_at, leaf.parent);
  std::vector<std::uint16_t> order(leaf.size());
  std::iota(order.begin(), order.end(), std::uint16_t{0});
  if (!std::is_sorted(leaf.keys.begin(), leaf.keys.end()))
    std::sort(order.begin(), order.end(),
              [&](std::uint16_t a, std::uint16_t b) { return leaf.keys[a] < leaf.keys[b]; });
  const auto same = [&](std::uint16_t a, std::uint16_t b) { return leaf.keys[a] == leaf.keys[b]; };
  if (std::adjacent_find(order.begin(), order.end(), same) != order.end())
    throw BrokenTree("a leaf has an object twice");
  std::byte* id = blob.data() + NodeFormat::ids_at;
  std::byte* record = blob.data() + format.records_at;
  for (const std::size_t slot : order) {
    store_number(id, leaf.keys[slot]);
    std::memcpy(record, leaf.values.data() + slot * static_cast<std::size_t>(format.at.size),
                format.record_size);
    id += sizeof(std::int64_t);
    record += format.record_size;
  }
  seal_node(blob, number);
  return blob;
}

Node decode_leaf(const NodeFormat& format, std::span<const std::byte> blob) {
  Node leaf;
  decode_leaf(format, blob, leaf);
  return leaf;
}

void decode_leaf(const NodeFormat& format, std::span<const std::byte> blob, Node& leaf) {
  const LeafView view(format, blob);
  const auto count = static_cast<std::size_t>(view.count());
  leaf.parent = load_number<std::int64_t>(blob.data() + NodeFormat::parent_at);
  leaf.keys.reserve(count + 1);  // a node overflows by one entry before the tree splits it
  leaf.values.reserve((count + 1) * static_cast<std::size_t>(format.at.size));
  leaf.keys.resize(count);
  leaf.values.resize(count * static_cast<std::size_t>(format.at.size));
  view.copy_ids(leaf.keys.data());
  view.copy_records(leaf.values.data());
}

}  // namespace foresee
