// The grid compared with all pairs, on bodies at rest: every pair that meets is reported exactly once.
#include "index/gpcd_grid/gpcd_grid.h"

#include "index/candidate_pairs.h"
#include "index/resting_bodies.h"

namespace foresee::testing {
namespace {

constexpr double far_away = 1.7e308;

template <int D>
Box<D> box_at(Random& random, double side, double largest) {
  Box<D> box;
  for (int axis = 0; axis < D; ++axis) {
    box.lower[axis] = random.in(0, side);
    box.upper[axis] = box.lower[axis] + random.in(0, largest);
  }
  return box;
}

/// Boxes of side about 1 with about `density` neighbours each.
template <int D>
std::vector<Box<D>> uniform_boxes(std::size_t count, std::uint64_t seed, double density = 4) {
  Random random(seed);
  const double side = std::pow(static_cast<double>(count) / density, 1.0 / D) + 1;
  std::vector<Box<D>> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(box_at<D>(random, side, 2));
  return boxes;
}

/// An upper bound of the rounding error at the ends of the grid's boxes (motion/beam.kernel.cpp).
template <int D>
std::vector<Box<D>> rounded_outward(std::vector<Box<D>> boxes) {
  for (Box<D>& box : boxes) {
    if (box.is_empty()) continue;
    const Vec<D> error = 0x1p-49 * box.lower.abs().max(box.upper.abs()) + 0x1p-1019;
    box.lower -= error, box.upper += error;
  }
  return boxes;
}

template <int D>
void expect_grid_agrees(const std::vector<Box<D>>& boxes, std::size_t extra = 0) {
  const RestingBodies<D> all(boxes);
  const std::vector<Box<D>> bounds = all.boxes(never);
  const std::vector<Pair> wanted = pairs_that_meet<D>(bounds);
  const std::size_t near = pairs_that_meet<D>(rounded_outward(bounds)).size();
  expect_all_once(within_order(drain(*make_gpcd_grid<D>(all.side(), nullptr, never))), wanted,
                  near - wanted.size() + extra);
}

template <int D>
void expect_grid_agrees_between(const std::vector<Box<D>>& a, const std::vector<Box<D>>& b,
                                std::size_t extra = 0) {
  const RestingBodies<D> left(a), right(b);
  const std::vector<Box<D>> bounds = left.boxes(never), others = right.boxes(never);
  const MovingBoxes<D> other = right.side();
  const std::vector<Pair> wanted = pairs_that_meet<D>(bounds, others);
  const std::size_t near = pairs_that_meet<D>(rounded_outward(bounds), rounded_outward(others)).size();
  expect_all_once(in_order(drain(*make_gpcd_grid<D>(left.side(), &other, never))), wanted,
                  near - wanted.size() + extra);
}

template <class Axes>
class GpcdGrid : public ::testing::Test {};
using EveryAxes = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                   std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(GpcdGrid, EveryAxes);

TYPED_TEST(GpcdGrid, AgreesOnUniformBoxes) {
  constexpr int D = TypeParam::value;
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
    for (std::size_t count : {3, 10, 100, 1000}) expect_grid_agrees(uniform_boxes<D>(count, seed), 2);
}

TYPED_TEST(GpcdGrid, AgreesBetweenTwoSides) {
  constexpr int D = TypeParam::value;
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
    expect_grid_agrees_between(uniform_boxes<D>(700, seed), uniform_boxes<D>(300, seed + 100, 2), 2);
  expect_grid_agrees_between(uniform_boxes<D>(1000, 3), uniform_boxes<D>(1, 4));
  expect_grid_agrees_between(uniform_boxes<D>(10, 5), {});
  expect_grid_agrees_between({}, uniform_boxes<D>(10, 5));
}

TYPED_TEST(GpcdGrid, AnswersTinyScenes) {
  constexpr int D = TypeParam::value;
  expect_grid_agrees<D>({});
  expect_grid_agrees(uniform_boxes<D>(1, 1));
  const Box<D> unit{Vec<D>::constant(0), Vec<D>::constant(1)}, next{Vec<D>::constant(1), Vec<D>::constant(2)};
  const Box<D> far{Vec<D>::constant(5), Vec<D>::constant(6)};
  const auto count_of = [](const RestingBodies<D>& bodies) {
    return drain(*make_gpcd_grid<D>(bodies.side(), nullptr, never)).size();
  };
  EXPECT_EQ(count_of(RestingBodies<D>({unit, next})), 1u) << "touching counts";
  EXPECT_EQ(count_of(RestingBodies<D>({unit, far})), 0u);
}

TYPED_TEST(GpcdGrid, ReportsGiantsOnce) {
  constexpr int D = TypeParam::value;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    std::vector<Box<D>> boxes = uniform_boxes<D>(1500, seed), others = uniform_boxes<D>(500, seed + 50);
    Random random(seed);
    const double side = boxes.size();
    for (int i = 0; i < 30; ++i) {  // long along some axes, short along others, some beyond the space
      Box<D> giant = box_at<D>(random, 40, 1);
      for (int axis = 0; axis < D; ++axis)
        if (random.below(2)) giant.lower[axis] -= random.in(0, side), giant.upper[axis] += random.in(0, 300);
      (random.below(2) ? boxes : others)[random.below(400)] = giant;
    }
    expect_grid_agrees(boxes, 5);
    expect_grid_agrees_between(boxes, others, 5);
  }
}

TYPED_TEST(GpcdGrid, TakesHugeAndEmptyBoxes) {
  constexpr int D = TypeParam::value;
  std::vector<Box<D>> boxes = uniform_boxes<D>(600, 11);
  Random random(11);
  for (int i = 0; i < 5; ++i) boxes[random.below(600)].lower[0] = -far_away;
  for (int i = 0; i < 5; ++i) boxes[random.below(600)].upper[D - 1] = far_away;
  for (int i = 0; i < 60; ++i) boxes[random.below(600)] = Box<D>::empty();
  boxes[7] = {Vec<D>::constant(-far_away), Vec<D>::constant(far_away)};
  expect_grid_agrees(boxes, 2);
  expect_grid_agrees_between(boxes, uniform_boxes<D>(300, 12), 2);
  expect_grid_agrees(std::vector<Box<D>>(20, Box<D>::empty()));
  expect_grid_agrees(std::vector<Box<D>>(20, boxes[7]));
}

TYPED_TEST(GpcdGrid, AgreesWhenAllAreAtOneSpot) {
  constexpr int D = TypeParam::value;
  std::vector<Box<D>> boxes;
  Random random(3);
  for (int i = 0; i < 300; ++i)
    boxes.push_back({Vec<D>::constant(5 - random.unit()), Vec<D>::constant(5 + random.unit())});
  expect_grid_agrees(boxes);
  expect_grid_agrees(std::vector<Box<D>>(300, boxes[0]));
  expect_grid_agrees_between(boxes, boxes);
}

TYPED_TEST(GpcdGrid, AgreesOnPointsAndLattices) {
  constexpr int D = TypeParam::value;
  for (double extent : {0.0, 1.0}) {  // neighbours on a lattice of step 1 touch exactly, or not at all
    std::vector<Box<D>> boxes;
    Random random(17);
    for (int i = 0; i < 900; ++i) {
      Box<D> box;
      for (int axis = 0; axis < D; ++axis) box.lower[axis] = static_cast<double>(random.below(12));
      box.upper = box.lower + extent;
      boxes.push_back(box);
    }
    expect_grid_agrees(boxes);
  }
}

TYPED_TEST(GpcdGrid, AgreesOnCrowdsOfDifferentSizes) {
  constexpr int D = TypeParam::value;
  std::vector<Box<D>> boxes;
  Random random(23);
  for (int crowd = 0; crowd < 3; ++crowd)
    for (int i = 0; i < 400; ++i) {
      Box<D> box = box_at<D>(random, 20, 2);
      box.lower = (box.lower + 100 * crowd) * std::pow(10, crowd);
      box.upper = (box.upper + 100 * crowd) * std::pow(10, crowd);
      boxes.push_back(box);
    }
  expect_grid_agrees(boxes, 5);
}

/// The scene scaled by 2^exponent and moved: the same pairs, except for the rounding of the move itself.
TYPED_TEST(GpcdGrid, KeepsResolutionAtExtremeCoordinates) {
  constexpr int D = TypeParam::value;
  struct Change {
    double scale, offset;
  };
  for (Change change : {Change{1, 1e15}, Change{8, -1e15}, Change{0x1p-1070, 0}, Change{0x1p-1020, 0},
                        Change{0x1p1017, 0}, Change{0x1p1000, -0x1p1023}, Change{1e-3, 1e9}}) {
    std::vector<Box<D>> boxes = uniform_boxes<D>(500, 31);
    for (Box<D>& box : boxes) {
      box.lower = box.lower * change.scale + change.offset;
      box.upper = box.upper * change.scale + change.offset;
    }
    SCOPED_TRACE(::testing::Message() << "scale " << change.scale << ", offset " << change.offset);
    expect_grid_agrees(boxes, 3);
    expect_grid_agrees_between(boxes, boxes, 6);
  }
}

TYPED_TEST(GpcdGrid, ComesInBatches) {
  constexpr int D = TypeParam::value;
  const RestingBodies<D> bodies(std::vector(2000, Box<D>{Vec<D>::constant(0), Vec<D>::constant(1)}));
  auto candidates = make_gpcd_grid<D>(bodies.side(), nullptr, never);
  std::size_t total = 0;
  for (std::vector<Pair> batch; candidates->next(batch); batch.clear()) {
    ASSERT_LE(batch.size(), 5000u);
    total += batch.size();
  }
  EXPECT_EQ(total, 2000u * 1999u / 2);
  std::vector<Pair> batch;
  EXPECT_FALSE(candidates->next(batch)) << "the end stays the end";
}

}  // namespace
}  // namespace foresee::testing
