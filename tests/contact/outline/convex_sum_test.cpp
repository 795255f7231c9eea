// The sum of two pieces against its definition: it holds every difference of their corners, and no edge could
// be moved inward.

#include <gtest/gtest.h>

#include "contact/outline/flat_constraint.h"
#include "contact/outline/object_pieces.h"
#include "contact/outline/outline_scenes.h"
#include "numbers/dyadic.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

/// How far p - q is beyond an edge, exactly.
int side_of(const SumEdge& edge, const Corner& p, const Corner& q) {
  const std::array<Coefficients<Dyadic, 0>, 2> place{Coefficients<Dyadic, 0>{Dyadic(p.x) - Dyadic(q.x)},
                                                     Coefficients<Dyadic, 0>{Dyadic(p.y) - Dyadic(q.y)}};
  return beyond<0>(FlatConstraint{.feature = {.edge = edge}}, place)[0].sign();
}

void expect_sum(const ConvexPiece& a, const ConvexPiece& b) {
  SumEdge edge, last{};
  int edges = 0;
  for (ConvexSum sum(a, b); sum.next(edge); last = edge, ++edges) {
    if (edges > 0) {
      ASSERT_EQ(edge.p, last.p_end);
      ASSERT_EQ(edge.q, last.q_end);
    }
    ASSERT_EQ(side_of(edge, *edge.p, *edge.q), 0);
    ASSERT_EQ(side_of(edge, *edge.p_end, *edge.q_end), 0);
    for (const Corner& p : a.corners)
      for (const Corner& q : b.corners) ASSERT_LE(side_of(edge, p, q), 0);
  }
  ASSERT_EQ(edges, a.edges() + b.edges());
}

TEST(ConvexSum, HoldsAllDifferencesOfCorners) {
  for (const OutlineFamily& family : outline_families())
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const OutlineScene scene = draw_scene(family, OutlinePairing::outlines, seed);
      const ConvexPieces cut_a = convex_pieces(scene.a.outline), cut_b = convex_pieces(scene.b.outline);
      ObjectPieces a, b;
      a.take(cut_a);
      b.take(cut_b);
      for (std::size_t i = 0; i < cut_a.count(); ++i)
        for (std::size_t j = 0; j < cut_b.count(); ++j)
          ASSERT_NO_FATAL_FAILURE(expect_sum(a.piece(i), b.piece(j))) << family.name << ' ' << seed;
    }
}

TEST(ConvexSum, TakesBoxesOfAnySizeAndPoints) {
  const Outline hull = outline_of({{{-1, -2, 1, -2, 0, 2}}});
  const ConvexPieces cut = convex_pieces(hull);
  ObjectPieces a, b;
  a.take(cut);
  for (const auto& [hx, hy] : {std::pair(1.0, 2.0), {0.0, 2.0}, {1.0, 0.0}, {0.0, 0.0}}) {
    b.take_box(hx, hy);
    expect_sum(a.piece(0), b.piece(0));
    expect_sum(b.piece(0), a.piece(0));
    expect_sum(b.piece(0), b.piece(0));
  }
  b.take_point();
  expect_sum(a.piece(0), b.piece(0));
  expect_sum(b.piece(0), a.piece(0));
}

}  // namespace
}  // namespace foresee
