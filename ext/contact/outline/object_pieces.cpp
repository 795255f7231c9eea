#include "contact/outline/object_pieces.h"

namespace foresee {
namespace {

/// The directions of a box's edges, also of a box without width.
constexpr Corner unit_square[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

/// The number of the corner that `comes_before` every other.
template <class Before>
int first_of(const ConvexPiece& piece, Before&& comes_before) {
  int first = 0;
  for (int i = 1; i < static_cast<int>(piece.corners.size()); ++i)
    if (comes_before(piece.along[i], piece.along[first])) first = i;
  return first;
}

bool is_lower(const Corner& a, const Corner& b) {
  return a.y < b.y || (a.y == b.y && a.x < b.x);
}

}  // namespace

void ObjectPieces::take_box(const Box<2>& box) {
  form_ = nullptr, is_point_ = false;
  box_ = box;
  for (std::size_t i = 0; i < corners_.size(); ++i)
    corners_[i] = {unit_square[i].x < 0 ? box.lower[0] : box.upper[0],
                   unit_square[i].y < 0 ? box.lower[1] : box.upper[1]};
}

ConvexPiece ObjectPieces::piece(std::size_t i) const {
  if (!form_) return {std::span(corners_).first(is_point_ ? 1 : 4), unit_square, nullptr};
  const std::span<const Corner> corners = form_->corners(i);
  return {corners, corners.data(), form_->inner(i).data()};
}

ConvexSum::ConvexSum(const ConvexPiece& a, const ConvexPiece& b)
    : a_{a, first_of(a, is_lower), a.edges()},
      b_{b, first_of(b, [](const Corner& c, const Corner& d) { return is_lower(d, c); }), b.edges()} {}

/// Neither walk is ever half a turn ahead of the other, so the sign of a cross product decides which
/// direction comes first.
bool ConvexSum::a_turns_first() const {
  if (a_.left == 0 || b_.left == 0) return b_.left == 0;
  return turn_sign(*a_.along(a_.corner), *a_.along(a_.next()), *b_.along(b_.next()), *b_.along(b_.corner)) >=
         0;
}

bool ConvexSum::next(SumEdge& edge) {
  if (a_.left == 0 && b_.left == 0) return false;
  const bool of_a = a_turns_first();
  Walk& walk = of_a ? a_ : b_;
  const int i = walk.corner, j = walk.next();
  edge.from = walk.along(of_a ? i : j), edge.to = walk.along(of_a ? j : i);
  edge.inner = walk.piece.inner && walk.piece.inner[i] != 0;
  edge.p = a_.at(a_.corner), edge.q = b_.at(b_.corner);
  walk.step();
  edge.p_end = a_.at(a_.corner), edge.q_end = b_.at(b_.corner);
  return true;
}

}  // namespace foresee
