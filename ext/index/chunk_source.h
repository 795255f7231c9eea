// Plans of a table as queries read them: a TPR-tree of chunks, the legs of each chunk, and the records of their
// objects.
//
//   Chunk chunk;
//   plans.read_chunk(8, {60, 120}, chunk);               // 8: the key of an item that a walk of plans.tree() has found
//   add(chunk.object, chunk.record, chunk.legs);
//
// The items of the tree have chunk_layout() (shape/chunk_item.h): moving boxes that contain the object with its whole
// shape at every time of the chunk. Their keys are the numbers of the chunks; those of one object are consecutive, in
// order of time. Not a snapshot: it is read to the end before anything is written.
// Errors: as the table's; SQLITE_CORRUPT_VTAB for chunks that contradict their objects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "index/pages.h"
#include "motion/plan/plan.h"

namespace foresee {

/// Consecutive legs of one object's plan (motion/plan/chunks.h).
struct Chunk {
  std::int64_t object = 0;
  std::span<const double> record;  ///< of the object; valid until another chunk is read
  std::vector<Leg> legs;           ///< in order of time; the object's `until` has not cut them
};

/// What reads many chunks prefetches the chunk so many places ahead.
inline constexpr std::size_t chunks_ahead = 6;

class ChunkSource {
 public:
  virtual ~ChunkSource() = default;

  virtual NodeSource& tree() = 0;
  /// Hides the memory latency of a following read_chunk(); reads no row.
  virtual void prefetch_chunk(std::int64_t /*number*/) {}
  /// Replaces `chunk`, with its legs that exist at some of these times. Cost: two look-ups, and some 10 ns per leg.
  virtual void read_chunk(std::int64_t number, const LegTimes& times, Chunk& chunk) = 0;
};

}  // namespace foresee
