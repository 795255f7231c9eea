// Interface to the meshes of a table's rows, as contact reads them.
#pragma once

#include "shape/mesh/triangle_tree.h"
#include "shape/scratch_pieces.h"

namespace foresee {

/// The rotated meshes of rows. Thread-safe.
class MeshRows {
 public:
  virtual ~MeshRows() = default;
  /// The triangles of this row's rotated mesh; they live as long as this, or in `own`. Null: the row has no
  /// mesh, and is a point or a ball of its radius.
  virtual const TriangleTree* triangles(std::size_t row, ScratchPieces<TriangleTree>& own) const = 0;
};

}  // namespace foresee
