#include "contact/outline/object_pieces.h"

namespace foresee {
namespace {

/// The directions of a box's edges, also of a box without width.
constexpr Corner unit_square[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

}  // namespace

void ObjectPieces::take_row(const Bodies& bodies, const OutlineRows* outlines, std::size_t i) {
  const ConvexPieces* const known = outlines ? outlines->pieces(i, own_) : nullptr;
  if (known) return take(*known);
  const double* const row = bodies.row(i);
  const Offsets& at = bodies.at;
  if (!outlines && at.bounds != Offsets::absent) {
    const double* const bounds = row + at.bounds;
    return take_box({Vec<2>(bounds[0], bounds[1]), Vec<2>(bounds[2], bounds[3])});
  }
  if (at.half == Offsets::absent) return take_point();
  take_box(row[at.half], row[at.half + 1]);
}

void ObjectPieces::take_box(const Box<2>& box) {
  pieces_ = nullptr, is_point_ = false;
  box_ = box;
  for (std::size_t i = 0; i < corners_.size(); ++i)
    corners_[i] = {unit_square[i].x < 0 ? box.lower[0] : box.upper[0],
                   unit_square[i].y < 0 ? box.lower[1] : box.upper[1]};
}

ConvexPiece ObjectPieces::piece(std::size_t i) const {
  if (!pieces_) return {std::span(corners_).first(is_point_ ? 1 : 4), unit_square, nullptr};
  const std::span<const Corner> corners = pieces_->corners(i);
  return {corners, corners.data(), pieces_->inner(i).data()};
}

}  // namespace foresee
