// The rule of the distance: which metric each pair of shapes has, and which numbers of the rows add up for it.
#include "contact/pair_rule.h"

#include <gtest/gtest.h>

namespace foresee {
namespace {

Layout layout_of(Shape shape, int axes) {
  return {.axes = axes, .law = Law::uniform, .shape = shape, .has_t = true, .has_radius = true};
}

Distance distance(Shape a, Shape b, int axes, std::optional<double> within_z = {}) {
  const Distance one = PairRule(layout_of(a, axes), layout_of(b, axes), 1, within_z).distance;
  EXPECT_EQ(one, PairRule(layout_of(b, axes), layout_of(a, axes), 1, within_z).distance);
  return one;
}

TEST(PairRule, EachPairOfShapesHasADistance) {
  using enum Shape;
  for (const Shape shape : {point, box, ball}) EXPECT_EQ(distance(shape, ball, 1), Distance::per_axis);
  EXPECT_EQ(distance(box, box, 3), Distance::per_axis);
  for (const Shape shape : {point, box, ball}) {
    EXPECT_EQ(distance(shape, ball, 2), Distance::euclidean);
    EXPECT_EQ(distance(shape, point, 3), Distance::euclidean);
    EXPECT_EQ(distance(shape, outline, 2), Distance::euclidean);
    EXPECT_EQ(distance(shape, mesh, 3), Distance::euclidean);
  }
  for (const Shape shape : {point, box, cylinder, outline}) {
    EXPECT_EQ(distance(shape, cylinder, 3), Distance::upright);
    EXPECT_EQ(distance(shape, outline, 3), Distance::upright);
    EXPECT_EQ(distance(shape, point, 3, 2.0), Distance::upright);
  }
}

TEST(PairRule, OutlinesAndMeshesConsistOfPieces) {
  EXPECT_EQ(PairRule(layout_of(Shape::box, 2), layout_of(Shape::outline, 2)).pieces, PieceKind::planar);
  EXPECT_EQ(PairRule(layout_of(Shape::mesh, 3), layout_of(Shape::ball, 3)).pieces, PieceKind::spatial);
  EXPECT_EQ(PairRule(layout_of(Shape::box, 3), layout_of(Shape::ball, 3)).pieces, PieceKind::none);
}

TEST(PairRule, SizesAddUpTheNumbersOfBothRowsAndTheLimit) {
  const Layout box = layout_of(Shape::box, 3), cylinder = layout_of(Shape::cylinder, 3);
  const double box_row[] = {0, 0, 0, 0, 0, 0, 0, 10, 20, 30}, cylinder_row[] = {0, 0, 0, 0, 0, 0, 0, 4, 5};
  const PairRule rule(box, cylinder, 100, 200);
  const auto size = [&](const PairSize& both) { return size_as_of_t<double>(both, box_row, cylinder_row); };
  EXPECT_EQ(size(rule.radius), 104);
  EXPECT_EQ(size(rule.extent[0]), 10);
  EXPECT_EQ(size(rule.extent[1]), 20);
  EXPECT_EQ(size(rule.extent[2]), 235);
  EXPECT_EQ(rule.within(), 100);
  EXPECT_EQ(rule.within_z(), 200);

  const PairRule per_axis(box, box, 7);
  EXPECT_EQ(size_as_of_t<double>(per_axis.extent[1], box_row, box_row), 47);
  EXPECT_EQ(per_axis.within_z(), 7);
}

TEST(PairRule, GrowthIsOnTheAxisAlongWhichAShapeGrows) {
  Layout cylinder = layout_of(Shape::cylinder, 3);
  cylinder.has_growth = cylinder.has_growth_z = true;
  const PairRule rule(cylinder, layout_of(Shape::point, 3));
  const Offsets at = row_offsets(cylinder);
  EXPECT_TRUE(rule.grows);
  EXPECT_EQ(rule.radius.growth_a, at.growth);
  EXPECT_EQ(rule.extent[2].growth_a, at.growth_z);
  EXPECT_EQ(rule.extent[0].growth_a, Offsets::absent);
}

TEST(PairRule, OfAWindowMeasuresPointsAndBoxesPerAxisAndOfAZoneNothing) {
  const auto distance = [](Shape shape, int axes, bool is_zone) {
    return PairRule::of_window(layout_of(Shape::point, axes), layout_of(shape, axes), is_zone).distance;
  };
  EXPECT_EQ(distance(Shape::point, 2, false), Distance::per_axis);
  EXPECT_EQ(distance(Shape::box, 3, false), Distance::per_axis);
  EXPECT_EQ(distance(Shape::ball, 1, false), Distance::per_axis);
  EXPECT_EQ(distance(Shape::ball, 2, false), Distance::euclidean);
  EXPECT_EQ(distance(Shape::cylinder, 3, false), Distance::upright);
  EXPECT_EQ(distance(Shape::point, 2, true), Distance::euclidean);
  EXPECT_EQ(distance(Shape::point, 3, true), Distance::upright);
}

}  // namespace
}  // namespace foresee
