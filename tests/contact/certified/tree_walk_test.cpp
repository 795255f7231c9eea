// Which pieces a walk gives, and which it leaves out.
#include "contact/certified/tree_walk.h"

#include <gtest/gtest.h>

#include "contact/outline/flat_constraint.h"
#include "contact/outline/object_pieces.h"

namespace foresee {
namespace {

/// How many pairs of pieces there are for two squares over one another, `height` apart along z, that move
/// together along x.
int pairs_of_squares(double apart, double height) {
  ObjectPieces a, b;
  a.take_box(1, 1);
  b.take_box(1, 1);
  CertainMotion<3> relative{};
  relative.axis[2].x = apart;
  NeverInterrupt never;
  Steps steps(never);
  const PairSizes<Bounded> sizes{{}, {{height, 0}}, {{height, 0}}};
  const TreeWalk<3, ObjectPieces> walk(a, b, relative, {0, 10}, sizes, steps);
  int pairs = 0;
  walk.visit(
      Order::earlier_first, [](const Interval<double>&) { return true; },
      [&pairs](std::size_t, std::size_t, const Interval<double>&) { ++pairs; });
  return pairs;
}

TEST(TreeWalk, LeavesOutPrismsAboveEachOther) {
  EXPECT_EQ(pairs_of_squares(0, 3), 1);
  EXPECT_EQ(pairs_of_squares(3, 3), 1);
  EXPECT_EQ(pairs_of_squares(4, 3), 0);
  EXPECT_EQ(pairs_of_squares(-4, 3), 0);
}

}  // namespace
}  // namespace foresee
