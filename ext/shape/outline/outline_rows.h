// Interface to the outlines of a table's rows, as contact reads them.
#pragma once

#include <cstddef>

#include "shape/outline/convex_pieces.h"
#include "shape/scratch_pieces.h"

namespace foresee {

/// The convex pieces of rows' rotated outlines. Thread-safe.
class OutlineRows {
 public:
  virtual ~OutlineRows() = default;
  /// The pieces of this row's rotated outline; they live as long as this, or in `own`. Null: the row has no
  /// outline, and is a point, disc or cylinder of its sizes.
  virtual const ConvexPieces* pieces(std::size_t row, ScratchPieces<ConvexPieces>& own) const = 0;
};

}  // namespace foresee
