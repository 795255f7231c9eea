// Interface to the rotated forms of a table's rows, outlines or meshes, as contact reads them.
//
//   ScratchPieces<ConvexPieces> own;
//   const ConvexPieces* hull = rows.pieces(7, own);       // perhaps in `own`, until it is used again
//
// The pieces of an outline are convex polygons, those of a mesh are triangles.
#pragma once

#include <cstddef>
#include <memory>

namespace foresee {

class ConvexPieces;
class TriangleTree;

/// Scratch storage of one thread for the pieces of one rotated form that the shared cache does not keep
/// (turned_forms.h).
template <class Pieces>
struct ScratchPieces {
  std::shared_ptr<const void> form = nullptr;  ///< kept alive, so that no other form gets its address
  double heading = 0;
  std::unique_ptr<const Pieces> pieces = nullptr;

  bool are_of(const void* other, double turned_by) const {
    return pieces && form.get() == other && heading == turned_by;
  }
};

/// The pieces of rows' rotated forms. Thread-safe.
template <class Pieces>
class FormRows {
 public:
  virtual ~FormRows() = default;
  /// The pieces of this row's rotated form; they live as long as this, or in `own`. Null: the row has no
  /// form. It is a point, or the disc, ball or cylinder of its sizes.
  virtual const Pieces* pieces(std::size_t row, ScratchPieces<Pieces>& own) const = 0;
};

using OutlineRows = FormRows<ConvexPieces>;
using MeshRows = FormRows<TriangleTree>;

}  // namespace foresee
