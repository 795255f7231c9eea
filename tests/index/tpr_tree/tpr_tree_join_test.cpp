// Joins of TPR-trees, compared with sampled positions of every pair.
#include <gtest/gtest.h>

#include <set>

#include "index/tpr_tree/search/tree_join.h"
#include "stopping_interrupt.h"
#include "tests/index/tpr_tree/tree_model.h"

namespace foresee {
namespace {

using testing::all_scene_kinds;
using testing::name_of;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::StopAt;
using testing::TreeModel;
using testing::varied_layouts;

std::vector<double> record_at(const TreeScene& scene, std::size_t row) {
  const Bodies bodies = scene.bodies();
  return {bodies.row(row), bodies.row(row) + bodies.at.size};
}

/// True if two rows' boxes, each grown by margin, meet at a sampled time of the horizon.
template <int D>
bool meet_at_a_sample(const TreeScene& a, std::size_t i, const TreeScene& b, std::size_t j,
                      const Horizon& horizon, double margin) {
  Layout layout_a = a.layout, layout_b = b.layout;  // rows store the acceleration itself
  if (layout_a.law == Law::forced) layout_a.law = Law::accelerated;
  if (layout_b.law == Law::forced) layout_b.law = Law::accelerated;
  const auto record_a = record_at(a, i), record_b = record_at(b, j);
  for (int step = 0; step <= 12; ++step) {
    const long double time = horizon.now + static_cast<long double>(horizon.h) * step / 12;
    long double lower_a[D], upper_a[D], lower_b[D], upper_b[D];
    bool meet = testing::box_at<D>(layout_a, record_a, time, lower_a, upper_a) &&
                testing::box_at<D>(layout_b, record_b, time, lower_b, upper_b);
    for (int axis = 0; axis < D && meet; ++axis)
      meet = lower_a[axis] - upper_b[axis] <= 2 * margin && lower_b[axis] - upper_a[axis] <= 2 * margin;
    if (meet) return true;
  }
  return false;
}

std::set<std::pair<std::uint32_t, std::uint32_t>> all_candidates(Candidates& candidates, bool unordered) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::vector<Pair> batch; candidates.next(batch); batch.clear())
    for (const Pair& pair : batch) {
      const bool swap = unordered && pair.b < pair.a;
      EXPECT_TRUE(pairs.insert(swap ? std::pair(pair.b, pair.a) : std::pair(pair.a, pair.b)).second);
    }
  return pairs;
}

template <int D>
void expect_joins_complete(TreeModel& model, TreeModel& other, const Horizon& horizon, double margin) {
  const TreeScene a = read_tree(model.pages, model.never), b = read_tree(other.pages, other.never);
  const Vec<D> margins = Vec<D>::constant(margin);
  const auto within = make_tree_join<D>(a.bodies(), a.levels, horizon, margins, model.never);
  const auto self = all_candidates(*within, true);
  const auto between =
      make_tree_join<D>(a.bodies(), a.levels, b.bodies(), b.levels, horizon, margins, model.never);
  const auto both = all_candidates(*between, false);
  for (std::uint32_t i = 0; i < a.ids.size(); ++i) {
    EXPECT_FALSE(self.contains({i, i}));
    for (std::uint32_t j = i + 1; j < a.ids.size(); ++j)
      EXPECT_TRUE(self.contains({i, j}) || !meet_at_a_sample<D>(a, i, a, j, horizon, margin));
    for (std::uint32_t j = 0; j < b.ids.size(); ++j)
      EXPECT_TRUE(both.contains({i, j}) || !meet_at_a_sample<D>(a, i, b, j, horizon, margin));
  }
}

template <int D>
void expect_joins_complete_in(const Layout& layout, testing::SceneKind kind, std::size_t count, int churned) {
  SCOPED_TRACE(name_of(layout) + ", " + name_of(kind));
  const RandomScene scene = random_scene({.layout = layout, .kind = kind, .count = count, .seed = 4});
  TreeModel model(layout, 5, 5), other(layout, 60, 12);
  Random random(3);
  double clock = 0;
  model.load(scene);
  other.churn(scene, 40, random, clock);
  expect_joins_complete<D>(model, other, {clock, 3}, scene.within);
  model.churn(scene, churned, random, clock);
  expect_joins_complete<D>(model, other, {clock, 2}, 0.25);
}

TEST(TreeJoin, LosesNothingInAnyLayout) {
  for (const Layout& layout : varied_layouts()) {
    const auto kind = testing::SceneKind::uniform;
    if (layout.axes == 1) expect_joins_complete_in<1>(layout, kind, 30, 60);
    if (layout.axes == 2) expect_joins_complete_in<2>(layout, kind, 30, 60);
    if (layout.axes == 3) expect_joins_complete_in<3>(layout, kind, 30, 60);
  }
}

TEST(TreeJoin, LosesNothingInAnyKindOfSceneAfterThousandsOfChanges) {
  for (auto kind : all_scene_kinds)
    expect_joins_complete_in<2>({.axes = 2, .law = Law::accelerated, .shape = Shape::box, .has_t = true},
                                kind, 150, testing::sanitized ? 1000 : 3000);
}

TEST(TreeJoin, GivesNoMorePairsThanSweptBoxesWould) {
  const Layout layout{.axes = 2, .law = Law::uniform, .shape = Shape::box};
  const RandomScene scene = random_scene({.layout = layout, .count = 2000, .seed = 4});
  TreeModel model(layout, 3, 20);
  model.load(scene);
  const TreeScene tree = read_tree(model.pages, model.never);
  const Horizon horizon{0, 3};
  const auto join = make_tree_join<2>(tree.bodies(), tree.levels, horizon, Vec<2>::zero(), model.never);
  const auto pairs = all_candidates(*join, true);
  const auto boxes = swept_boxes<2>(tree.bodies(), horizon, Vec<2>::constant(1e-9), model.never);
  for (const auto& [i, j] : pairs) EXPECT_TRUE(boxes[i].meets(boxes[j]));
  EXPECT_GT(pairs.size(), 500u);
}

TEST(TreeJoin, OfEmptyTreesHasNoPairs) {
  const Layout layout{.axes = 1};
  TreeModel model(layout, 3), other(layout, 3);
  model.insert(1, {0});
  const TreeScene a = read_tree(model.pages, model.never), none = read_tree(other.pages, other.never);
  std::vector<Pair> out;
  EXPECT_FALSE(make_tree_join<1>(none.bodies(), none.levels, {}, Vec<1>::zero(), model.never)->next(out));
  EXPECT_FALSE(
      make_tree_join<1>(a.bodies(), a.levels, none.bodies(), none.levels, {}, Vec<1>::zero(), model.never)
          ->next(out));
  EXPECT_TRUE(out.empty());
}

TEST(TreeJoin, StopsWhenInterrupted) {
  StopAt stop(3);
  const Layout layout{.axes = 1};
  TreeModel model(layout, 3);
  for (int i = 0; i < 2000; ++i) model.insert(i, {0});
  const TreeScene tree = read_tree(model.pages, model.never);
  const auto join = make_tree_join<1>(tree.bodies(), tree.levels, {}, Vec<1>::zero(), stop);
  std::vector<Pair> out;
  EXPECT_THROW(while (join->next(out)) out.clear(), Interrupted);
}

}  // namespace
}  // namespace foresee
