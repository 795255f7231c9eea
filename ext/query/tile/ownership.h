// Filter of candidates by the tile of a join that owns them: one byte per object, one operation per
// candidate.
//
//   auto candidates = owned_candidates(make_gpcd_grid<2>(boxes, nullptr, interrupt), ownership);
//
// Guarantee: returns exactly the inner candidates that the tile owns, in their order.
#pragma once

#include <memory>
#include <vector>

#include "index/candidates.h"
#include "query/tile/tile.h"

namespace foresee {

/// Marks of the objects of both sides, by row number.
struct Ownership {
  std::vector<TileMarks> a, b;             ///< b: empty where both sides are one scene
  std::size_t needed_a = 0, needed_b = 0;  ///< number of needed objects

  bool owns(const Pair& pair) const {
    const TileMarks other = b.empty() ? a[pair.b] : b[pair.b];
    return (a[pair.a] | other) == Tile::owned;
  }
};

std::unique_ptr<Candidates> owned_candidates(std::unique_ptr<Candidates> all,
                                             std::shared_ptr<const Ownership> ownership);
std::unique_ptr<DividedCandidates> owned_candidates(std::unique_ptr<DividedCandidates> all,
                                                    std::shared_ptr<const Ownership> ownership);

}  // namespace foresee
