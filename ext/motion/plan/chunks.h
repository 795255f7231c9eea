// Chunks of a plan: at most 16 consecutive legs inside one moving box, which is what an index stores of a plan.
// A stored table keeps its plans in them, and a join of plans by the method tree cuts its legs into them.
//
//   const std::vector<ChunkRange> ranges = cut_into_chunks(legs);
//   const ChunkBox box = chunk_box(legs.subspan(ranges[0].first, ranges[0].count), 2);
//
// At time s the box of a chunk is x + v (s - t) ± half, for the real numbers that these doubles are. It contains the
// position of every leg at every time of its life: the half extents are rounded outward, and infinite where no double
// bounds them. The boxes move with the chord of the chunk, from the start of its first leg to the end of its last.
// A run of legs ends before a leg without end, whose box is its path. It also ends before a jump that is farther than
// its last 16 legs are long together, and before a gap that lasts longer than they do. A run is cut into as few chunks
// as possible, of equally many legs: a short last chunk would cost as much as a full one.
// Cost: some 20 ns per leg and axis.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/plan/plan.h"

namespace foresee {

inline constexpr std::size_t legs_per_chunk = 16;

/// Legs first to first + count - 1 of a plan.
struct ChunkRange {
  std::size_t first, count;
};

/// All legs in their order. Requires: check_plan() accepts them.
std::vector<ChunkRange> cut_into_chunks(std::span<const Leg> legs);

struct ChunkBox {
  double t, until;
  std::array<double, 3> x{}, v{}, half{};
};

/// The half extents that the box needs to contain the legs: of chunk_box() its own. Requires: the box starts no later
/// than the legs.
std::array<double, 3> half_extents_around(const ChunkBox& box, std::span<const Leg> legs, int axes);

/// Requires: legs of one chunk, at least one.
ChunkBox chunk_box(std::span<const Leg> legs, int axes);

}  // namespace foresee
