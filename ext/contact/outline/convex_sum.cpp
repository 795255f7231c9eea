#include "contact/outline/convex_sum.h"

#include "shape/outline/outline.h"

namespace foresee {
namespace {

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
