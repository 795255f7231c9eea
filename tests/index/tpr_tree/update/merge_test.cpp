// Merges of many objects: the tree is as sound as after single insertions, and its leaves remain full.

#include <gtest/gtest.h>

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

TEST(Merge, KeepsTheTreeSoundInEveryLayout) {
  for (const Layout& layout : varied_layouts()) {
    SCOPED_TRACE(name_of(layout));
    const RandomScene scene = random_scene({.layout = layout, .count = 150, .seed = 3});
    TreeModel model(layout, 3);
    Random random(9);
    double clock = 0;
    for (const std::size_t count : {1, 40, 100, 200, 33, 250}) {
      model.merge(scene, count, random);
      model.expect_sound();
    }
    model.churn(scene, 200, random, clock);
    model.merge(scene, 60, random);
    model.expect_sound();
  }
}

TEST(Merge, KeepsTheTreeSoundInEveryKindOfScene) {
  constexpr int rounds = testing::sanitized ? 5 : 12;
  for (auto kind : all_scene_kinds) {
    SCOPED_TRACE(name_of(kind));
    const RandomScene scene = random_scene({.layout = boats, .kind = kind, .count = 1500, .seed = 5});
    TreeModel model(boats, 60, 10);
    Random random(2);
    double clock = 0;
    for (int round = 0; round < rounds; ++round, clock += 50) {
      model.merge(scene, 1 + random.below(1500), random);
      model.expect_sound();
      model.churn(scene, 300, random, clock);
      model.expect_sound();
    }
  }
}

TEST(Merge, TakesManyMoreObjectsThanTheTreeHas) {
  const RandomScene scene = random_scene({.layout = boats, .count = 3000, .seed = 7});
  TreeModel model(boats, 60, 6);
  Random random(3);
  model.merge(scene, 10, random);
  model.merge(scene, 4000, random);
  model.expect_sound();
}

TEST(Merge, TakesMoreObjectsThanAreMergedAtOnce) {
  const RandomScene scene = random_scene({.layout = boats, .count = 70000, .seed = 6});
  TreeModel model(boats, 60, 60);
  Random random(5);
  model.load(scene);
  model.merge(scene, 80000, random);
  model.expect_sound();
}

TEST(Merge, LeavesRemainThreeQuartersFullWhileTheyGrow) {
  const RandomScene scene = random_scene({.layout = boats, .count = 10000, .seed = 8});
  TreeModel model(boats, 60, 20);
  Random random(4);
  for (int round = 0; round < 40; ++round) model.merge(scene, 800, random);
  model.expect_sound();
  const double full = static_cast<double>(model.objects.size()) / 20;
  EXPECT_LT(static_cast<double>(model.pages.node_count()), full / 0.75 * 1.1);
}

TEST(EraseAll, KeepsTheTreeSoundInEveryLayoutWhateverTheShare) {
  for (const Layout& layout : varied_layouts()) {
    SCOPED_TRACE(name_of(layout));
    const RandomScene scene = random_scene({.layout = layout, .count = 400, .seed = 12});
    for (const std::size_t max_leaves : {1, 7, 1000})
      for (const double share : {0.02, 0.5, 0.9, 0.99, 1.0}) {
        SCOPED_TRACE(std::to_string(share) + " of all, at most " + std::to_string(max_leaves) +
                     " leaves at a time");
        TreeModel model(layout, 3);
        Random random(11);
        model.load(scene);
        model.erase_share(share, max_leaves, random);
        model.expect_sound();
        model.merge(scene, 90, random);
        model.expect_sound();
        model.erase_share(share, max_leaves, random);
        model.expect_sound();
      }
  }
}

TEST(EraseAll, LeavesFullLeaves) {
  const RandomScene scene = random_scene({.layout = boats, .count = 20000, .seed = 13});
  for (const double share : {0.3, 0.6, 0.9}) {
    TreeModel model(boats, 60, 20);
    Random random(8);
    model.load(scene);
    model.erase_share(share, 100, random);
    model.expect_sound();
    EXPECT_LT(model.pages.node_count(), model.objects.size() / 10);  // two thirds full, with the inner nodes
  }
}

TEST(EraseAll, RefusesAnObjectThatTheTreeDoesNotHave) {
  const RandomScene scene = random_scene({.layout = boats, .count = 300, .seed = 14});
  TreeModel model(boats, 60);
  model.load(scene);
  std::vector<std::int64_t> ids(scene.ids.begin(), scene.ids.begin() + 40);
  ids.push_back(9999);
  EXPECT_THROW(model.tree->erase_all(ids, 10, model.never), BrokenTree);
  EXPECT_THROW(model.tree->erase_all({&ids.back(), 1}, 10, model.never), BrokenTree);
}

/// A tree whose objects arrive again, leaf by leaf.
struct ArrivingAgain {
  explicit ArrivingAgain(std::size_t capacity) : model(boats, 60, capacity) {
    model.load(random_scene({.layout = boats, .count = 5000, .seed = 4}));
    collect_objects(model.pages, ids, records, model.never);
  }
  bool in_place(std::size_t count) {
    return model.tree->arrive_in_place(std::span(ids).first(count), std::span(records).first(count * size),
                                       model.never);
  }
  void move(double distance) {
    for (std::size_t i = 0; i < ids.size(); ++i) records[i * size + x] += distance;
  }

  const std::size_t size = static_cast<std::size_t>(record_offsets(boats).size),
                    x = static_cast<std::size_t>(record_offsets(boats).x);
  TreeModel model;
  std::vector<std::int64_t> ids;
  std::vector<double> records;
};

TEST(Merge, KnowsObjectsThatArriveInPlace) {
  ArrivingAgain all(16);
  EXPECT_TRUE(all.in_place(5000));
  const std::vector<double> before = all.records;
  all.move(1e9);
  EXPECT_FALSE(all.in_place(5000)) << "they leave their nodes";
  all.records = before;
  Random random(8);
  const auto record = [&](std::size_t i) {
    return all.records.begin() + static_cast<std::ptrdiff_t>(i * all.size);
  };
  for (std::size_t i = all.ids.size(); i-- > 1;) {
    const std::size_t j = random.below(i + 1);
    std::swap(all.ids[i], all.ids[j]);
    std::swap_ranges(record(i), record(i + 1), record(j));
  }
  EXPECT_FALSE(all.in_place(5000)) << "in no order";
  for (std::int64_t& id : all.ids) id += 1'000'000;
  EXPECT_FALSE(all.in_place(5000)) << "they are new";
}

TEST(Merge, ManyObjectsMayMoveFarInPlace) {
  ArrivingAgain all(6);
  double low = all.records[all.x], high = low;
  for (std::size_t i = all.x; i < all.records.size(); i += all.size) {
    low = std::min(low, all.records[i]);
    high = std::max(high, all.records[i]);
  }
  all.move((high - low) / 13);
  EXPECT_TRUE(all.in_place(5000));
  EXPECT_FALSE(all.in_place(150)) << "they are few, and leave nodes that have an eighth of so many";
}

}  // namespace
}  // namespace foresee
