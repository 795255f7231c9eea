// Invariants of the TPR-tree in every layout and kind of scene, at extreme numbers, and on damaged nodes.
#include "index/tpr_tree/tpr_tree.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "index/tpr_tree/search/nearest_walk.h"
#include "index/tpr_tree/search/tree_join.h"
#include "index/tpr_tree/search/window_walk.h"
#include "tests/index/tpr_tree/tree_model.h"

namespace foresee {
namespace {

using testing::all_scene_kinds;
using testing::boats;
using testing::name_of;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::TreeModel;
using testing::varied_layouts;

TEST(TprTree, KeepsItsInvariantsInEveryLayout) {
  for (const Layout& layout : varied_layouts()) {
    SCOPED_TRACE(name_of(layout));
    const RandomScene scene = random_scene({.layout = layout, .count = 60, .seed = 3});
    TreeModel model(layout, 3);
    Random random(9);
    double clock = 0;
    model.churn(scene, 150, random, clock);
    model.expect_sound();
    model.load(scene);
    model.expect_sound();
    model.churn(scene, 100, random, clock);
    model.expect_sound();
  }
}

TEST(TprTree, TakesNewObjectsInThePlaceOfOthers) {
  for (const Layout& layout : varied_layouts()) {
    SCOPED_TRACE(name_of(layout));
    const RandomScene scene = random_scene({.layout = layout, .count = 60, .seed = 3});
    TreeModel model(layout, 3);
    Random random(9);
    double clock = 0;
    model.churn(scene, 150, random, clock);
    EXPECT_FALSE(model.replace(1000, 1001, model.objects.begin()->second)) << "no such object";
    std::int64_t next = 1000;
    for (int step = 0, taken = 0; step < 200 || taken < 10; ++step) {
      ASSERT_LT(step, 5000);
      const auto any = [&] {
        return std::next(model.objects.begin(),
                         static_cast<std::ptrdiff_t>(random.below(model.objects.size())));
      };
      const std::int64_t id = any()->first;
      const bool is_equal = step % 4 == 0;
      const std::vector<double> record = is_equal ? model.objects[id] : any()->second;
      const bool is_taken = model.replace(id, next, record);
      EXPECT_TRUE(is_taken || !is_equal);
      if (!is_taken) continue;
      ++next, taken += !is_equal;
      if (step % 10 == 0) model.expect_sound();
    }
    model.expect_sound();
    model.churn(scene, 100, random, clock);
    model.expect_sound();
  }
}

TEST(TprTree, KeepsItsInvariantsInEveryKindOfScene) {
  for (auto kind : all_scene_kinds) {
    SCOPED_TRACE(name_of(kind));
    const RandomScene scene = random_scene({.layout = boats, .kind = kind, .count = 400, .seed = 5});
    TreeModel model(boats, 60, 10);
    Random random(2);
    double clock = 0;
    for (int round = 0; round < 4; ++round, clock += 500) {
      model.churn(scene, 1000, random, clock);
      model.expect_sound();
    }
  }
}

TEST(TprTree, HoldsMotionsAtTheEdgesOfDouble) {
  Random random(4);
  const double sizes[] = {0, 5e-324, 1e-300, 1, 1e15, 1e154, 1e300, 1.7e308};
  Layout layout{.axes = 2, .law = Law::accelerated, .shape = Shape::box, .has_t = true, .has_until = true};
  for (double horizon : {0.0, 60.0, 1e300}) {
    TreeModel model(layout, horizon);
    auto any = [&] { return (random.below(2) ? 1 : -1) * sizes[random.below(8)]; };
    for (int step = 0; step < 1500; ++step) {
      const auto id = static_cast<std::int64_t>(random.below(200));
      const double t = any();
      std::vector<double> record{t};
      for (int i = 0; i < 6; ++i) record.push_back(any());
      for (int i = 0; i < 2; ++i) record.push_back(std::abs(any()));
      record.push_back(random.below(2) ? std::numeric_limits<double>::infinity() : std::max(t, any()));
      if (model.objects.contains(id))
        random.below(2) ? model.update(id, record) : model.erase(id);
      else
        model.insert(id, record);
    }
    model.expect_sound();
  }
}

TEST(TprTree, IsEmptyAfterEverythingHasGone) {
  const RandomScene scene = random_scene({.layout = boats, .count = 300});
  TreeModel model(boats, 60);
  model.load(scene);
  for (const std::int64_t id : scene.ids) model.erase(id);
  model.expect_sound();
  EXPECT_EQ(model.pages.find_root(), 0);
  EXPECT_EQ(model.pages.node_count(), 0u);
  EXPECT_FALSE(model.tree->erase(1));
  EXPECT_FALSE(model.tree->update(1, std::vector<double>(6)));
}

TEST(TprTree, LoadLeavesATenthOfLeavesFreeAndRebuildKeepsObjects) {
  const RandomScene scene = random_scene({.layout = boats, .count = 1000});
  TreeModel model(boats, 60, 10);
  model.load(scene);
  EXPECT_EQ(model.pages.node_count(), 112u + 12 + 2 + 1);
  Random random(1);
  double clock = 1;
  model.churn(scene, 2000, random, clock);
  model.tree->rebuild(model.never);
  model.expect_sound();
  const std::size_t leaves = (model.objects.size() + 8) / 9;
  EXPECT_LE(model.pages.node_count(), leaves + leaves / 9 + 4);
}

TEST(TprTree, NodesThatContradictOneAnotherAreAnError) {
  const RandomScene scene = random_scene({.layout = boats, .count = 300});
  for (int damage = 0; damage < 7; ++damage) {
    SCOPED_TRACE(damage);
    TreeModel model(boats, 60);
    model.load(scene);
    const NodeNumber leaf = *model.pages.find_leaf(7), parent = model.pages.read(leaf)->parent;
    if (damage == 0) model.pages.modify(leaf).level = 1;
    if (damage == 1) model.pages.modify(parent).keys.assign(model.pages.read(parent)->size(), parent);
    if (damage == 2) model.pages.modify(leaf).parent = leaf;
    if (damage == 3) model.pages.modify(leaf).keys.assign(model.pages.read(leaf)->size(), 8);
    if (damage == 4) model.pages.modify(leaf).parent = 0;
    if (damage == 5) model.pages.modify(model.pages.find_root()).parent = leaf;
    if (damage == 6) model.pages.modify(parent).keys[0] = 7, model.pages.place(std::array{7L}, parent);
    EXPECT_FALSE(check_tree(model.pages, model.never).problems.empty());
    if (damage == 5)  // which only a descent meets
      EXPECT_THROW(model.tree->insert(1000, model.objects[7]), BrokenTree);
    else
      EXPECT_THROW(model.tree->erase(7), BrokenTree);
  }
}

/// Two nodes on each level below the root, each a child of both nodes above: as many paths as a valid tree
/// with so many levels has leaves.
void share_all_children(MemoryPages& pages, int levels) {
  const auto add_node = [&](int level, std::span<const NodeNumber> children, NodeNumber parent) {
    Node node{.level = level, .parent = parent, .keys = {children.begin(), children.end()}, .values = {}};
    for (std::size_t i = 0; i < children.size(); ++i) {
      const double infinity = std::numeric_limits<double>::infinity();
      node.values.insert(node.values.end(), {0, 0, infinity});
      for (int bound = 0; bound < 3; ++bound)
        node.values.insert(node.values.end(), {-infinity, -infinity, infinity, infinity});
    }
    if (level == 0) node.keys = {level + parent}, node.values.assign(6, 1.0);
    const NodeNumber number = pages.allocate();
    pages.put(number, std::move(node));
    return number;
  };
  std::array<NodeNumber, 2> below{add_node(0, {}, 3), add_node(0, {}, 3)};
  for (int level = 1; level < levels; ++level) {
    const NodeNumber above = 2 * level + 3;  // the first of the next two
    below = {add_node(level, below, above), add_node(level, below, above)};
  }
  pages.set_root(add_node(levels, below, 0));
}

TEST(TprTree, SharedChildrenAreAnErrorAtOnce) {
  MemoryPages pages(boats, 6, 6);
  share_all_children(pages, 60);
  NeverInterrupt never;
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  EXPECT_THROW(collect_objects(pages, ids, records, never), BrokenTree);
  EXPECT_THROW(read_tree(pages, never), BrokenTree);
  EXPECT_THROW(make_tpr_tree(pages, 60)->rebuild(never), BrokenTree);
  const Vec<2> origin = Vec<2>::zero();
  const Horizon horizon{0, 60};
  const auto walk_window = [&] {
    WindowWalk<2> walk(pages, moving_window<2>(origin, origin + 9, origin, horizon), horizon, origin, never);
    for (LeafHits hits; walk.next(hits);) continue;
  };
  EXPECT_THROW(walk_window(), BrokenTree);
  const auto walk_nearest = [&] {
    NearestWalk<2> walk(pages, origin, origin, horizon, never);
    for (LeafHits hits; walk.next(1e9, hits);) continue;
  };
  EXPECT_THROW(walk_nearest(), BrokenTree);
}

TEST(TprTree, NodesAreSplitWhateverTheirBoundsSay) {
  const RandomScene scene = random_scene({.layout = boats, .count = 300});
  for (const double bound : {std::numeric_limits<double>::infinity(), 1e300, std::nan("")}) {
    TreeModel model(boats, 60);
    model.load(scene);
    const std::size_t nodes = model.pages.node_count();
    for (NodeNumber number = 1; number <= static_cast<NodeNumber>(nodes); ++number) {
      if (model.pages.read(number)->is_leaf()) continue;
      Node& inner = model.pages.modify(number);
      for (std::size_t i = 3; i < inner.values.size(); ++i)
        if (i % static_cast<std::size_t>(entry_size(2)) >= 3) inner.values[i] = bound;
    }
    for (const auto& [id, record] : model.objects) model.tree->insert(id + 1000, record);
    for (const std::string& problem : check_tree(model.pages, model.never).problems)
      EXPECT_EQ(problem.find("too full"), std::string::npos) << bound << ' ' << problem;
  }
}

}  // namespace
}  // namespace foresee
