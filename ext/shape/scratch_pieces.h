// Scratch storage of one thread for the pieces of one rotated form that the shared cache does not keep
// (turned_forms.h).
//
//   ScratchPieces<ConvexPieces> own;
//   const ConvexPieces* hull = rows.pieces(7, own);       // perhaps in `own`, until it is used again
#pragma once

#include <memory>

namespace foresee {

template <class Pieces>
struct ScratchPieces {
  std::shared_ptr<const void> form = nullptr;  ///< kept alive, so that no other form gets its address
  double heading = 0;
  std::unique_ptr<const Pieces> pieces = nullptr;

  bool are_of(const void* other, double turned_by) const {
    return pieces && form.get() == other && heading == turned_by;
  }
};

}  // namespace foresee
