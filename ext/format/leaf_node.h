// Leaf node of the TPR-tree as stored bytes: up to leaf_capacity objects, ids ascending, records in the same
// order.
//
//   if (const char* fault = leaf_fault(format, blob, number)) …
//   LeafView leaf(format, blob);
//   int i = leaf.find(42);                 // -1: not in this leaf
//   leaf.copy_record(i, record);
//
// LeafView reads bytes that the caller owns; the tree itself works on a Node (index/pages.h).
#pragma once

#include <vector>

#include "format/node_format.h"
#include "index/pages.h"

namespace foresee {

/// Returns what is wrong with a blob that claims to be leaf `number`; null: nothing. Every record of a sound
/// leaf is one that the table accepts.
const char* leaf_fault(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number);

/// Returns what is wrong with a record: not finite, a negative extent, …; null: nothing.
const char* record_fault(const NodeFormat& format, const double* record);

class LeafView {
 public:
  /// Requires: `leaf_fault` returned null.
  LeafView(const NodeFormat& format, std::span<const std::byte> blob) : format_(&format), bytes_(blob) {}

  int count() const { return load_number<std::uint16_t>(bytes_.data() + NodeFormat::count_at); }
  std::int64_t id(int i) const { return load_number<std::int64_t>(id_at(i)); }
  /// The index of `id`, or -1.
  int find(std::int64_t id) const;

  void copy_record(int i, double* record) const { std::memcpy(record, record_at(i), format_->record_size); }
  /// Copies all count() ids, or all records.
  void copy_ids(std::int64_t* ids) const;
  void copy_records(double* records) const;

 private:
  const std::byte* id_at(int i) const {
    return bytes_.data() + NodeFormat::ids_at + static_cast<std::size_t>(i) * sizeof(std::int64_t);
  }
  const std::byte* record_at(int i) const {
    return bytes_.data() + format_->records_at + static_cast<std::size_t>(i) * format_->record_size;
  }
  /// The first index whose id is not less than `id`.
  int lower_bound(std::int64_t id) const;

  const NodeFormat* format_;
  std::span<const std::byte> bytes_;
};

/// Returns the bytes of leaf `number`: ids ascending, each with its record, whatever the order in the node.
/// Requires: at least one object. Throws BrokenTree if the objects do not fit.
std::vector<std::byte> encode_leaf(const NodeFormat& format, std::int64_t number, const Node& leaf);

/// Requires: `leaf_fault` returned null.
Node decode_leaf(const NodeFormat& format, std::span<const std::byte> blob);
/// The same into an existing node, whose memory is used again.
void decode_leaf(const NodeFormat& format, std::span<const std::byte> blob, Node& leaf);

}  // namespace foresee
