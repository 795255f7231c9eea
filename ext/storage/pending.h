// What a write transaction has changed but not written yet: leaves in memory and the ids that moved.
//
// Only bytes live here; the store reads and writes them. References to leaves stay valid until erase() or
// clear().
#pragma once

#include <cstdint>
#include <map>

#include "storage/id_changes.h"
#include "storage/leaf_node.h"

namespace foresee {

struct PendingLeaf {
  std::int64_t number;
  LeafNode leaf;
  bool changed;  ///< since it was read or last written
  bool stored;   ///< _node has a row of this number
};

class Pending {
 public:
  /// Null if leaf `number` is not in memory.
  PendingLeaf* find(std::int64_t number);
  /// The first leaf in memory after number `after`, empty ones left out; null if there is none.
  const PendingLeaf* next_after(std::int64_t after) const;
  PendingLeaf& add(PendingLeaf leaf);
  void clear() noexcept;

  /// Bytes that wait, roughly.
  std::size_t memory(const NodeFormat& format) const;

  std::map<std::int64_t, PendingLeaf> leaves;
  IdChanges ids;
  std::int64_t more = 0;          ///< objects inserted less objects erased since the map was last written
  bool map_half_written = false;  ///< a flush failed: some of `ids` are in the stored map already
};

}  // namespace foresee
