// Window and nearest-neighbour searches in a TPR-tree, compared with sampled positions of every object.
#include <gtest/gtest.h>

#include <set>

#include "index/tpr_tree/search/nearest_walk.h"
#include "index/tpr_tree/search/window_walk.h"
#include "tests/index/tpr_tree/tree_model.h"

namespace foresee {
namespace {

using testing::all_scene_kinds;
using testing::box_at;
using testing::name_of;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::TreeModel;
using testing::varied_layouts;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int instants = 24;

template <int D>
Vec<D> random_vec(Random& random, double lower, double upper) {
  Vec<D> v;
  for (double& x : v) x = random.in(lower, upper);
  return v;
}

/// Every object that is in the window at a sampled time must be found, and none twice.
template <int D>
void expect_window_complete(TreeModel& model, const Horizon& horizon, const Vec<D>& lower,
                            const Vec<D>& upper, const Vec<D>& velocity) {
  std::set<std::int64_t> found;
  WindowWalk<D> walk(model.pages, moving_window<D>(lower, upper, velocity, horizon), horizon, Vec<D>::zero(),
                     model.never);
  for (LeafHits hits; walk.next(hits);)
    for (const std::uint32_t slot : hits.slots) EXPECT_TRUE(found.insert(hits.leaf->keys[slot]).second);
  for (const auto& [id, record] : model.objects) {
    bool inside_once = false;
    for (int i = 0; i <= instants && !inside_once; ++i) {
      const long double tau = static_cast<long double>(horizon.h) * i / instants;
      long double from[D], to[D];
      inside_once = box_at<D>(model.pages.layout(), record, horizon.now + tau, from, to);
      for (int axis = 0; axis < D && inside_once; ++axis)
        inside_once = from[axis] <= upper[axis] + velocity[axis] * tau &&
                      to[axis] >= lower[axis] + velocity[axis] * tau;
    }
    EXPECT_TRUE(!inside_once || found.contains(id)) << "object " << id;
  }
}

/// No object that the walk omits is nearer, at a sampled time, than the k-th best that it returned.
template <int D>
void expect_nearest_complete(TreeModel& model, const Horizon& horizon, const Vec<D>& point,
                             const Vec<D>& velocity, std::size_t k) {
  auto sampled_distance = [&](const std::vector<double>& record) {
    long double nearest = infinity;
    for (int i = 0; i <= instants; ++i) {
      const long double tau = static_cast<long double>(horizon.h) * i / instants;
      long double from[D], to[D], squared = 0;
      if (!box_at<D>(model.pages.layout(), record, horizon.now + tau, from, to)) continue;
      for (int axis = 0; axis < D; ++axis) {
        const long double gap = (from[axis] + to[axis]) / 2 - point[axis] - velocity[axis] * tau;
        squared += gap * gap;
      }
      nearest = std::min(nearest, std::sqrt(squared));
    }
    return static_cast<double>(nearest);
  };
  std::multiset<double> best;
  std::set<std::int64_t> found;
  double reach = infinity;
  NearestWalk<D> walk(model.pages, point, velocity, horizon, model.never);
  for (LeafHits hits; walk.next(reach, hits);)
    for (const std::uint32_t slot : hits.slots) {
      EXPECT_TRUE(found.insert(hits.leaf->keys[slot]).second);
      best.insert(sampled_distance(model.objects[hits.leaf->keys[slot]]));
      if (best.size() > k) best.erase(std::prev(best.end()));
      if (best.size() == k) reach = *best.rbegin();
    }
  for (const auto& [id, record] : model.objects) {
    const double distance = found.contains(id) ? infinity : sampled_distance(record);
    EXPECT_TRUE(distance == infinity || distance >= reach * (1 - 1e-12)) << "object " << id;
  }
}

template <int D>
void expect_walks_complete(TreeModel& model, const RandomScene& scene, Random& random, double now,
                           int questions) {
  for (int i = 0; i < questions; ++i) {
    const Horizon horizon{now + random.in(-1, 1), i % 4 == 0 ? 0.0 : random.in(0, 10)};
    const Vec<D> lower = random_vec<D>(random, -5, scene.side), velocity = random_vec<D>(random, -4, 4);
    Vec<D> upper = lower + random_vec<D>(random, 0, scene.side / 3);
    if (i % 7 == 0) upper[0] = infinity;
    expect_window_complete<D>(model, horizon, lower, upper, i % 2 ? velocity : Vec<D>::zero());
    expect_nearest_complete<D>(model, horizon, lower, velocity, 1 + random.below(12));
  }
}

template <int D>
void expect_walks_complete_in(const Layout& layout, testing::SceneKind kind, std::size_t count, int churned) {
  SCOPED_TRACE(name_of(layout) + ", " + name_of(kind));
  const RandomScene scene = random_scene({.layout = layout, .kind = kind, .count = count, .seed = 8});
  TreeModel model(layout, 5, 8);
  Random random(6);
  double clock = 0;
  model.load(scene);
  expect_walks_complete<D>(model, scene, random, clock, 6);
  model.churn(scene, churned, random, clock);
  expect_walks_complete<D>(model, scene, random, clock, 6);
}

TEST(TreeWalks, LoseNothingInAnyLayout) {
  for (const Layout& layout : varied_layouts()) {
    const auto kind = testing::SceneKind::uniform;
    if (layout.axes == 1) expect_walks_complete_in<1>(layout, kind, 80, 100);
    if (layout.axes == 2) expect_walks_complete_in<2>(layout, kind, 80, 100);
    if (layout.axes == 3) expect_walks_complete_in<3>(layout, kind, 80, 100);
  }
}

TEST(TreeWalks, LoseNothingInAnyKindOfSceneAfterThousandsOfChanges) {
  for (auto kind : all_scene_kinds)
    expect_walks_complete_in<2>({.axes = 2, .law = Law::accelerated, .shape = Shape::box, .has_t = true},
                                kind, 500, testing::sanitized ? 2000 : 5000);
}

TEST(TreeWalks, LoseNothingFarFromTheEpochAndTheOrigin) {
  const Layout layout{.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true};
  const RandomScene scene = random_scene({.layout = layout, .count = 300, .seed = 1});
  for (double offset : {1e6, 1e15}) {
    TreeModel model(layout, 60, 8);
    for (std::size_t i = 0; i < scene.size(); ++i) {
      std::vector<double> record(scene.records.begin() + static_cast<std::ptrdiff_t>(6 * i),
                                 scene.records.begin() + static_cast<std::ptrdiff_t>(6 * i + 6));
      record[0] += 1.7e9, record[1] += offset, record[2] -= offset;
      model.insert(scene.ids[i], record);
    }
    model.expect_sound();
    for (double now : {1.7e9, 1.7e9 + 1e5, 1.7e9 - 1e5})
      for (int i = 0; i < 10; ++i) {
        const Vec<2> lower(offset + 6 * i, -offset), upper = lower + 10.0, still = Vec<2>::zero();
        expect_window_complete<2>(model, {now, 30}, lower, upper, still);
        expect_nearest_complete<2>(model, {now, 30}, lower, still, 5);
      }
  }
}

TEST(TreeWalks, FindFewWhereFewAre) {
  const Layout layout{.axes = 2, .law = Law::uniform, .shape = Shape::point, .has_t = false};
  const RandomScene scene = random_scene({.layout = layout, .count = 4000, .seed = 1});
  TreeModel model(layout, 3, 20);
  model.load(scene);
  const Horizon horizon{0, 3};
  const Vec<2> lower(40, 40), upper(60, 60), still = Vec<2>::zero();
  WindowWalk<2> walk(model.pages, moving_window<2>(lower, upper, still, horizon), horizon, still,
                     model.never);
  std::size_t leaves = 0, objects = 0;
  for (LeafHits hits; walk.next(hits); ++leaves) objects += hits.slots.size();
  EXPECT_LT(leaves, 20u);
  EXPECT_LT(objects, 100u);
  EXPECT_GT(objects, 10u);
}

TEST(MinDistance, IsNeverAboveASampledDistance) {
  Random random(11);
  for (int i = 0; i < 20000; ++i) {
    auto box = [&] {
      const Vec<2> lower = random_vec<2>(random, -10, 10), v = random_vec<2>(random, -3, 3);
      return MovingBox<2>{lower, lower + random.unit(), v, v + (i % 2 ? 0 : random.unit()), {0, 5}};
    };
    const MovingBox<2> a = box(), b = box();
    const double bound = min_distance(a, b, {0, 5});
    double sampled = infinity;
    for (int step = 0; step <= 100; ++step) {
      const double tau = step * 0.05;
      const Vec<2> gap = (a.lower + a.v_lower * tau - b.upper - b.v_upper * tau)
                             .max(b.lower + b.v_lower * tau - a.upper - a.v_upper * tau)
                             .max(0.0);
      sampled = std::min(sampled, std::sqrt(gap.square().sum()));
    }
    ASSERT_LE(bound, sampled);
    ASSERT_GE(bound, sampled - 1.0);  // the bound is not much smaller
  }
}

/// The gap closes so slowly that the slope of its square underflows, over a span as long.
TEST(MinDistance, IsNoneWhereTheSlopeOfASquareVanishes) {
  for (double gap : {1e-120, 1e-130, 1e-139})
    for (double pace : {1e-180, 1e-200, 1e-220}) {
      const Vec<2> none = Vec<2>::zero(), place(0, gap), speed(0, -pace);
      const SharedInterval span{0, 1e105};
      EXPECT_EQ(min_distance<2>({none, none, none, none, span}, {place, place, speed, speed, span}, span), 0)
          << gap << " " << pace;
    }
}

TEST(MinDistance, OfPointsHoldsAtEverySizeOfNumbers) {
  Random random(12);
  for (double size : {1e-300, 2e-161, 1e-150, 1e-20, 1.0, 1e15, 1e150, 1e290})
    for (double h : {0.0, 1e-9, 5.0, 1e9})
      for (int i = 0; i < 300; ++i) {
        const Horizon horizon{0, h};
        const double slow = h > 0 ? size / h * random.unit() : size;
        const Motion<2> motion{random.in(-2, 0), random_vec<2>(random, -size, size),
                               random_vec<2>(random, -slow, slow), random_vec<2>(random, -slow, slow) * 0.1,
                               infinity};
        const Vec<2> point = random_vec<2>(random, -size, size), speed = random_vec<2>(random, -slow, slow);
        const double bound =
            min_point_distance(moving_box<2>(motion, Extents<2>::none(), horizon, Vec<2>::zero()),
                               moving_window<2>(point, point, speed, horizon));
        long double sampled = infinity;
        for (int step = 0; step <= 100; ++step) {
          const long double tau = step * 0.01L * h, s = tau - motion.t;
          long double squared = 0;
          for (int axis = 0; axis < 2; ++axis) {
            const long double gap = motion.x[axis] + motion.v[axis] * s + motion.a[axis] * s * s / 2 -
                                    point[axis] - speed[axis] * tau;
            squared += gap * gap;
          }
          sampled = std::min(sampled, std::sqrt(squared));
        }
        ASSERT_LE(bound, sampled) << size << " " << h;
        const bool everyday = size <= 1e15 && size >= 1e-20 && h < 1e8;
        EXPECT_TRUE(!everyday || bound >= sampled - 2 * size);
      }
}

}  // namespace
}  // namespace foresee
