#include "contact/outline/critical_pieces.h"

#include "contact/outline/condition.h"
#include "contact/set/minkowski_sum.h"

namespace foresee {
namespace {

/// Builds the set, one pair of pieces after another.
class CriticalSet {
 public:
  ContactSet set;

  CriticalSet(const Setup& setup, bool grown) {
    if (grown) radius_ = size_of_both(set, setup, setup.rule.radius);
    if (setup.a.layout.axes < 3) return;
    const Size heights = size_of_both(set, setup, setup.rule.extent[2]);
    Faces across_z{.axis = 2};
    if (setup.window) across_z = faces_from_origin(*setup.window);
    across_z = grown_faces(set, across_z, heights);
    along_z_ = between(set, {&across_z, 1});
  }

  void add(const ConvexPiece& a, const ConvexPiece& b) {
    Conditions inside{.all = along_z_};
    SumEdge edge;
    for (ConvexSum sum(a, b); sum.next(edge);) {
      inside.all.push_back(set.half_space(line_of(edge), {}));
      if (radius_.value != no_length) add_rounded(edge);
    }
    set.add_piece(inside);
  }

 private:
  using Line = std::array<AxisPart, 2>;

  /// Adds the strip beside an edge and the disc around the corner at its start.
  void add_rounded(const SumEdge& edge) {
    Conditions beside{.all = along_z_}, around{.all = along_z_};
    for (const int sign : {-1, 1}) beside.all.push_back(set.half_space(foot_of(edge, sign), {}));
    beside.ball = set.strip(line_of(edge), radius_);
    beside.all.push_back(beside.ball);
    set.add_piece(beside);
    const Size x{difference(edge.p->x, edge.q->x)}, y{difference(edge.p->y, edge.q->y)};
    around.ball = set.ball(Line{{{.axis = 0, .at = x}, {.axis = 1, .at = y}}}, radius_);
    around.all.push_back(around.ball);
    set.add_piece(around);
  }

  /// The faces across z of a window whose body is at the origin.
  Faces faces_from_origin(const WindowFaces& window) {
    Faces faces{.axis = 2, .has_below = window.has_lower(2), .has_above = window.has_upper(2)};
    if (faces.has_below) faces.below = {set.given(-window.lower[2])};
    if (faces.has_above) faces.above = {set.given(window.upper[2])};
    return faces;
  }
  int difference(double a, double b) { return set.difference(set.given(a), set.given(b)); }
  /// The numbers of both components of an edge's direction.
  std::array<int, 2> run_of(const SumEdge& edge) {
    return {difference(edge.to->x, edge.from->x), difference(edge.to->y, edge.from->y)};
  }

  /// The same lines as beyond() and past() of convex_sum.h.
  Line line_of(const SumEdge& edge) {
    const auto [ex, ey] = run_of(edge);
    return through(edge.p, edge.q, {.axis = 0, .normal = ey}, {.axis = 1, .sign = -1, .normal = ex});
  }
  Line foot_of(const SumEdge& edge, int sign) {
    const auto [ex, ey] = run_of(edge);
    return through(sign > 0 ? edge.p_end : edge.p, sign > 0 ? edge.q_end : edge.q,
                   {.axis = 0, .sign = sign, .normal = ex}, {.axis = 1, .sign = sign, .normal = ey});
  }
  Line through(const Corner* p, const Corner* q, const AxisPart& x, const AxisPart& y) {
    Line line{x, y};
    line[0].at = {difference(p->x, q->x)}, line[1].at = {difference(p->y, q->y)};
    return line;
  }

  Size radius_;
  std::vector<int> along_z_;
};

}  // namespace

CriticalPieces critical_pieces(const Setup& setup, const ObjectPieces& a, const ObjectPieces& b,
                               std::span<const PiecePair> pairs, bool grown) {
  CriticalSet critical(setup, grown);
  std::vector<std::uint32_t> ends;
  for (const PiecePair& pair : pairs) {
    critical.add(a.piece(pair.a), b.piece(pair.b));
    ends.push_back(static_cast<std::uint32_t>(critical.set.pieces().size()));
  }
  return {std::move(critical.set), std::move(ends)};
}

}  // namespace foresee
