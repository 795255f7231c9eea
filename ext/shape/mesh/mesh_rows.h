// Who knows what the rows of a table look like that have meshes?
#pragma once

#include "shape/mesh/triangle_tree.h"
#include "shape/scratch_pieces.h"

namespace foresee {

/// Who knows the meshes of a table's rows. Asked by several threads at a time.
class MeshRows {
 public:
  virtual ~MeshRows() = default;
  /// The triangles of this row's mesh as it lies, which live as long as this, or are in `own`; null: it has
  /// none, and is the point or ball that its radius says.
  virtual const TriangleTree* triangles(std::size_t row, ScratchPieces<TriangleTree>& own) const = 0;
};

}  // namespace foresee
