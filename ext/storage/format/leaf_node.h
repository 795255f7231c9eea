// A leaf: up to leaf_capacity objects, their ids ascending, their records beside them in the same order.
//
//   if (const char* fault = leaf_fault(format, blob, number)) …
//   LeafView leaf(format, blob);
//   int i = leaf.find(42);                 // -1: not here
//   leaf.copy_record(i, record);
//
// LeafView reads bytes that somebody else holds; a leaf that the tree works on is a Node.
#pragma once

#include <vector>

#include "index/pages.h"
#include "storage/format/node_format.h"

namespace foresee {

/// What is wrong with a blob that claims to be leaf `number`; null: nothing. Every record in a leaf without
/// fault is one that the table would accept.
const char* leaf_fault(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number);

/// What is wrong with a record: not finite, a negative extent, … Null: nothing.
const char* record_fault(const NodeFormat& format, const double* record);

class LeafView {
 public:
  /// Requires: `leaf_fault` found nothing.
  LeafView(const NodeFormat& format, std::span<const std::byte> blob) : format_(&format), bytes_(blob) {}

  int count() const { return load_number<std::uint16_t>(bytes_.data() + NodeFormat::count_at); }
  std::int64_t id(int i) const { return load_number<std::int64_t>(id_at(i)); }
  /// The place of `id`, or -1.
  int find(std::int64_t id) const;

  void copy_record(int i, double* record) const { std::memcpy(record, record_at(i), format_->record_size); }
  /// All ids, all records: count() of them.
  void copy_ids(std::int64_t* ids) const;
  void copy_records(double* records) const;

 private:
  const std::byte* id_at(int i) const {
    return bytes_.data() + NodeFormat::ids_at + static_cast<std::size_t>(i) * sizeof(std::int64_t);
  }
  const std::byte* record_at(int i) const {
    return bytes_.data() + format_->records_at + static_cast<std::size_t>(i) * format_->record_size;
  }
  /// The first place whose id is not less than `id`.
  int lower_bound(std::int64_t id) const;

  const NodeFormat* format_;
  std::span<const std::byte> bytes_;
};

/// The bytes to store as leaf `number`: ids ascending, each with its record, whatever their order in the
/// node. Requires: at least one object. Throws BrokenTree if there are more than fit.
std::vector<std::byte> encode_leaf(const NodeFormat& format, std::int64_t number, const Node& leaf);

/// Requires: `leaf_fault` found nothing.
Node decode_leaf(const NodeFormat& format, std::span<const std::byte> blob);

}  // namespace foresee
