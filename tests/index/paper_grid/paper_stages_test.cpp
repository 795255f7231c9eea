// The paper's tests b to d: pairs that each must remove, and pairs that none may lose.
#include "index/paper_grid/paper_stages.h"

#include "contact/contact.h"
#include "contact/pair_rule.h"
#include "index/candidate_pairs.h"
#include "index/paper_grid/trajectory.h"

namespace foresee {
namespace {

using testing::all_layouts;
using testing::all_scene_kinds;
using testing::name_of;
using testing::never;
using testing::random_scene;
using testing::RandomScene;
using testing::varied_layouts;

/// Two boxes of equal half extents: x, y, vx, vy, ax, ay each.
struct TwoBoxes {
  double rows[2][8];

  TwoBoxes(std::array<double, 6> a, std::array<double, 6> b, double half = 1) {
    for (std::size_t i = 0; i < 8; ++i) rows[0][i] = i < 6 ? a[i] : half, rows[1][i] = i < 6 ? b[i] : half;
  }
  Bodies bodies() const { return {{2, Law::accelerated, Shape::box}, rows[0], 2}; }
  std::vector<Trajectory<2>> of(double h) const {
    const Vec<2> none = Vec<2>::zero();
    return {trajectory_of<2>(bodies(), 0, {0, h}, none), trajectory_of<2>(bodies(), 1, {0, h}, none)};
  }
  bool swept_boxes_meet(double h) const {
    const auto t = of(h);
    return t[0].swept.meets(t[1].swept);
  }
  bool times_may_overlap(double h) const {
    const auto t = of(h);
    return foresee::times_may_overlap<2>(t[0], t[1]);
  }
  bool regions_may_meet(double h) const {
    const auto t = of(h);
    return foresee::regions_may_meet<2>(t[0], t[1]);
  }
  PaperStages& staged(double h) {
    stages = make_paper_stages<2>(bodies(), bodies(), false, {0, h}, Vec<2>::zero(), never);
    std::vector<Pair> pairs{{0, 1}};
    stages->prune(pairs);
    return *stages;
  }
  std::unique_ptr<PaperStages> stages;
};

TEST(TimeIntervalTest, SeparatesTwoThatCrossTheSameSpotAtDifferentTimes) {
  const TwoBoxes boxes({-20, 0, 4, 0, 0, 0}, {0, -5, 0, 4, 0, 0});  // at the crossing at 5 and at 1.25
  EXPECT_TRUE(boxes.swept_boxes_meet(10));
  EXPECT_TRUE(boxes.regions_may_meet(10));
  EXPECT_FALSE(boxes.times_may_overlap(10));
}

/// Twice the acceleration overflows.
TEST(TimeIntervalTest, KeepsTwoThatTouchWhileOneBrakesAsHardAsDoublesGo) {
  const double hardest = std::numeric_limits<double>::max();
  const TwoBoxes boxes({1e-157, 0, -1e136, 0, hardest, 0}, {0, 0, 0, 0, 0, 0}, 0);
  EXPECT_TRUE(boxes.times_may_overlap(1e-292));  // the crossing is at 1e-293
}

TEST(TimeIntervalTest, KeepsTwoThatTouchAtTheEnd) {
  const TwoBoxes boxes({-10, 0, 4, 0, 0, 0}, {0, 0, 0, 0, 0, 0});  // touch at 2
  EXPECT_TRUE(boxes.times_may_overlap(2));
}

TEST(TimeIntervalTest, KnowsThatOneIsInsideTwice) {
  // Up to y = 8 and down again: beside the wall (y <= 1 there) at the start and at the end, while the other
  // object passes over the path in the middle only.
  const TwoBoxes boxes({0, 0, 0, 4, 0, -1}, {-9, 0, 2.25, 0, 0, 0});  // y(t) = 4 t - t^2 / 2; x = 0 at 4
  EXPECT_TRUE(boxes.swept_boxes_meet(8));
  EXPECT_FALSE(boxes.times_may_overlap(8));
  EXPECT_TRUE(TwoBoxes({0, 0, 0, 4, 0, -1}, {-18, 0, 2.25, 0, 0, 0}).times_may_overlap(8.5));
}

TEST(TrajectoryIntersectionTest, SeparatesParallelDiagonals) {
  const TwoBoxes boxes({0, 0, 1, 1, 0, 0}, {8, 2, 1, 1, 0, 0});
  EXPECT_TRUE(boxes.swept_boxes_meet(10));
  EXPECT_FALSE(boxes.regions_may_meet(10));
  EXPECT_TRUE(TwoBoxes({0, 0, 1, 1, 0, 0}, {3, 0, 1, 1, 0, 0}).regions_may_meet(10));
}

TEST(TrajectoryIntersectionTest, ChecksTheSideToWhichAnArcBends) {
  // From (0, 0) to (10, 0), an arc that reaches y = 6.25 at 5; a resting box above it, and one below.
  EXPECT_TRUE(TwoBoxes({0, 0, 1, 2.5, 0, -0.5}, {5, 7, 0, 0, 0, 0}).regions_may_meet(10));
  EXPECT_FALSE(TwoBoxes({0, 0, 1, 2.5, 0, -0.5}, {5, -2.5, 0, 0, 0, 0}).regions_may_meet(10));
}

TEST(CentrePointTest, IsAHitAtOnce) {
  TwoBoxes meeting({-4, -4, 1, 1, 0, 0}, {4, -4, -1, 1, 0, 0}),
      missing({-4, -4, 1, 1, 0, 0}, {4, -4.5, -1, 1, 0, 0});
  EXPECT_EQ(meeting.staged(10).hits_at_once(), 1u);
  EXPECT_EQ(meeting.staged(3).hits_at_once(), 0u) << "they meet at 4";
  EXPECT_EQ(missing.staged(10).hits_at_once(), 0u);
}

TEST(PaperStages, CountPairsBeforeAndAfterEachTest) {
  TwoBoxes boxes({-20, 0, 4, 0, 0, 0}, {0, -5, 0, 4, 0, 0});
  const auto& counts = boxes.staged(10).counts();
  const std::size_t wanted[paper_stage_count][2] = {{1, 1}, {1, 1}, {1, 0}, {0, 0}};
  for (std::size_t stage = 0; stage < paper_stage_count; ++stage) {
    EXPECT_EQ(counts[stage].before, wanted[stage][0]) << stage;
    EXPECT_EQ(counts[stage].after, wanted[stage][1]) << stage;
  }
}

/// Prunes all pairs of two scenes and expects that no pair that touches is removed.
struct Losses {
  std::size_t candidates = 0, left = 0, hits = 0;

  template <int D>
  void expect_none(const RandomScene& a, const RandomScene& b, double h, const std::string& what) {
    const auto contact = make_contact(a.bodies(), b.bodies(), {{a.now, h}, a.within, {}}, "a", "b");
    const double reach = PairRule(a.layout, b.layout, a.within).within();
    std::vector<Pair> pairs, touching;
    for (std::uint32_t i = 0; i < a.size(); ++i)
      for (std::uint32_t j = 0; j < b.size(); ++j)
        if (&a != &b || i < j) pairs.push_back({i, j});
    candidates += pairs.size();
    contact->decide(pairs, touching);
    const auto stages = make_paper_stages<D>(a.bodies(), b.bodies(), &a != &b, {a.now, h},
                                             Vec<D>::constant(reach * (0.5 + 0x1p-50)), never);
    stages->prune(pairs);
    std::sort(pairs.begin(), pairs.end());
    EXPECT_TRUE(std::includes(pairs.begin(), pairs.end(), touching.begin(), touching.end())) << what;
    left += pairs.size();
    hits += touching.size();
  }
  void expect_none(const RandomScene& a, const RandomScene& b, double h) {
    const std::string what = name_of(a.layout) + " and " + name_of(b.layout) + ", h = " + std::to_string(h);
    if (a.layout.axes == 1) expect_none<1>(a, b, h, what);
    if (a.layout.axes == 2) expect_none<2>(a, b, h, what);
    if (a.layout.axes == 3) expect_none<3>(a, b, h, what);
  }
};

TEST(PaperStages, LoseNoPairThatTouchesInAnyScene) {
  Losses losses;
  for (const Layout& layout : varied_layouts())
    for (auto kind : all_scene_kinds) {
      const auto scene = random_scene({.layout = layout, .kind = kind, .count = 60, .seed = 14});
      for (double h : {0.0, 3.0}) losses.expect_none(scene, scene, h);
    }
  EXPECT_GT(losses.hits, testing::sanitized ? 2500u : 10000u);
  EXPECT_LT(losses.left, losses.candidates / 2);
}

TEST(PaperStages, LoseNoPairOverTheLongestHorizons) {
  Losses losses;
  for (const Layout& layout : varied_layouts()) {
    const auto scene = random_scene({.layout = layout, .count = 20, .seed = 15});
    for (double h : {1e9, 1e100, 1e300}) losses.expect_none(scene, scene, h);
  }
  EXPECT_GT(losses.hits, testing::sanitized ? 250u : 1000u);
}

TEST(PaperStages, LoseNoPairBetweenTablesOfDifferentKinds) {
  Losses losses;
  const std::vector<Layout> all = all_layouts();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i % 5; j < all.size(); j += 5) {
      if (all[i].axes != all[j].axes) continue;
      if (all[i].shape == Shape::cylinder && all[j].shape == Shape::ball) continue;
      if (all[i].shape == Shape::ball && all[j].shape == Shape::cylinder) continue;
      const auto a = random_scene({.layout = all[i], .count = 40, .seed = 8});
      const auto b = random_scene({.layout = all[j], .count = 30, .seed = 9});
      losses.expect_none(a, b, 3);
    }
  EXPECT_GT(losses.hits, 1000u);
}

/// Numbers of every magnitude, so that products overflow, underflow and cancel.
TEST(PaperStages, LoseNoPairHoweverLargeOrSmallTheNumbersAre) {
  testing::Random random(77);
  const double sizes[] = {0, 5e-324, 1e-200, 1e-9, 1, 3, 1e9, 1e16, 1e150, 1e300};
  Losses losses;
  for (int round = 0; round < 400; ++round) {
    const int axes = 1 + round % 3;
    auto scene =
        random_scene({.layout = {axes, Law::accelerated, Shape::box, true, true}, .count = 24, .seed = 5});
    const auto size = static_cast<std::size_t>(scene.bodies().at.size);
    const int half = scene.bodies().at.half, until = scene.bodies().at.until;
    for (std::size_t k = 0; k < scene.rows.size(); ++k) {
      const auto place = static_cast<int>(k % size);
      double number = sizes[random.below(10)] * static_cast<double>(1 + random.below(3));
      if (place < half && random.below(2)) number = -number;
      if (place == until) number = scene.rows[k - size + 1] + number;  // t comes first
      if (random.below(3)) scene.rows[k] = number;
    }
    for (std::size_t i = 0; i < scene.size(); ++i) {
      double& last = scene.rows[i * size + static_cast<std::size_t>(until)];
      last = std::max(last, scene.rows[i * size]);
    }
    scene.now = round % 4 ? 0 : sizes[random.below(10)];
    losses.expect_none(scene, scene, sizes[random.below(10)]);
  }
  EXPECT_GT(losses.hits, 1000u);
}

}  // namespace
}  // namespace foresee
