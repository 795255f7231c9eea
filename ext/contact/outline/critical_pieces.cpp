#include "contact/outline/critical_pieces.h"

#include "contact/outline/condition.h"

namespace foresee::contact {
namespace {

class Critical {
 public:
  explicit Critical(const Setup& setup) {
    if (setup.a.layout.axes < 3) return;
    const int heights = set.in_both(place_of_half_height(setup.a.at), place_of_half_height(setup.b.at));
    const Size size{set.sum(heights, set.given(setup.within_z))};
    for (const int side : {-1, 1}) along_z_.push_back(set.bound(2, side, size));
  }

  void add(const ConvexPiece& a, const ConvexPiece& b) {
    Conditions piece{.all = along_z_};
    SumEdge edge;
    for (ConvexSum sum(a, b); sum.next(edge);) piece.all.push_back(inside_of(edge));
    set.add_piece(piece);
  }

  ContactSet set;

 private:
  int difference(double a, double b) { return set.difference(set.given(a), set.given(b)); }

  int inside_of(const SumEdge& edge) {
    const AxisPart line[] = {
        {.axis = 0, .at = {difference(edge.p->x, edge.q->x)}, .normal = difference(edge.to->y, edge.from->y)},
        {.axis = 1,
         .sign = -1,
         .at = {difference(edge.p->y, edge.q->y)},
         .normal = difference(edge.to->x, edge.from->x)}};
    return set.half_space(line, {});
  }

  std::vector<int> along_z_;
};

}  // namespace

ContactSet critical_pieces(const Setup& setup, const Pieces& a, const Pieces& b,
                           std::span<const PiecePair> pairs) {
  Critical critical(setup);
  for (const PiecePair& pair : pairs) critical.add(a.piece(pair.a), b.piece(pair.b));
  return std::move(critical.set);
}

}  // namespace foresee::contact
