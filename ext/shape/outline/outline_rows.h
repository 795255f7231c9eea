// Who knows what the rows of a table look like that have outlines?
#pragma once

#include <cstddef>

#include "shape/outline/convex_pieces.h"
#include "shape/scratch_pieces.h"

namespace foresee {

/// Who knows the outlines of a table's rows. Asked by several threads at a time.
class OutlineRows {
 public:
  virtual ~OutlineRows() = default;
  /// The pieces of this row's outline as it lies, which live as long as this, or are in `own`; null: it has
  /// none, and is the point, disc or cylinder that its sizes say.
  virtual const ConvexPieces* pieces(std::size_t row, ScratchPieces<ConvexPieces>& own) const = 0;
};

}  // namespace foresee
