// Objects that come and go without reports: what has dispersed is packed again, and the tree remains sound.

#include <gtest/gtest.h>

#include "base/repeatable_choice.h"
#include "index/tpr_tree/search/window_walk.h"
#include "tests/index/tpr_tree/tree_model.h"

namespace foresee {
namespace {

using testing::boats;
using testing::name_of;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::TreeModel;
using testing::varied_layouts;

constexpr std::size_t always = 1 << 30;  ///< so many changes that nodes are examined
constexpr double side = 400;

/// The ids in the order of leaves.
std::vector<std::int64_t> order_of(TreeModel& model) {
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  collect_objects(model.pages, ids, records, model.never);
  return ids;
}

std::vector<double> boat(Random& random, double t, double x, double y) {
  return {t, x, y, random.in(-3, 3), random.in(-3, 3), 0.5};
}

/// Counts the leaves that a walk reads.
class CountedLeaves final : public NodeSource {
 public:
  explicit CountedLeaves(NodeSource& nodes) : nodes_(nodes) {}

  const Layout& layout() const override { return nodes_.layout(); }
  NodeNumber find_root() override { return nodes_.find_root(); }
  std::shared_ptr<const Node> read(NodeNumber number) override {
    auto node = nodes_.read(number);
    count += node->is_leaf();
    return node;
  }

  std::size_t count = 0;

 private:
  NodeSource& nodes_;
};

/// The number of leaves that windows of a twentieth of the side read.
double leaves_read(TreeModel& model, double now) {
  Random random(8);
  CountedLeaves leaves(model.pages);
  for (int i = 0; i < 100; ++i) {
    const Vec<2> lower(random.in(0, side), random.in(0, side)), still = Vec<2>::Zero();
    const Horizon horizon{now, 0};
    WindowWalk<2> walk(leaves, moving_window<2>(lower, lower + side / 20, still, horizon), horizon, still,
                       model.never);
    for (LeafHits hits; walk.next(hits);) {
    }
  }
  return static_cast<double>(leaves.count);
}

/// The same as a multiple of that of a packed tree.
double visits(TreeModel& model, double now) {
  const double before = leaves_read(model, now);
  model.tree->rebuild(model.never);
  return before / leaves_read(model, now);
}

TEST(DispersedObjects, ArePackedSoundInEveryLayout) {
  std::size_t packed = 0;
  for (const Layout& layout : varied_layouts())
    for (const std::size_t count : {4, 150, 400}) {
      SCOPED_TRACE(name_of(layout) + ", " + std::to_string(count));
      const RandomScene scene = random_scene({.layout = layout, .count = count, .seed = 3});
      TreeModel model(layout, 3);
      model.load(scene);
      Random random(9);
      double clock = 0;
      for (std::uint64_t round = 0; round < 4; ++round) {
        model.churn(scene, static_cast<int>(count), random, clock);
        clock += 20;
        const auto before = order_of(model);
        model.tree->repack_dispersed(always, round);
        packed += order_of(model) != before;
        model.expect_sound();
      }
    }
  EXPECT_GT(packed, 10u);
}

/// Each object lives for 60 seconds; in every batch the oldest ones go. Returns visits() after two lives.
double visits_after_lives(std::size_t batch, bool packs) {
  constexpr std::size_t count = 8000;
  constexpr double life = 60;
  TreeModel model(boats, 10, 40);
  Random random(6);
  std::vector<std::int64_t> ids, gone;
  std::vector<double> records;
  std::int64_t next = 0;
  const auto add = [&](double t) {
    const auto& record = model.objects[next] = boat(random, t, random.in(0, side), random.in(0, side));
    ids.push_back(next++), records.insert(records.end(), record.begin(), record.end());
  };
  const auto born = [&](std::size_t i) { return life * static_cast<double>(i) / count; };
  for (std::size_t i = 0; i < count; ++i) add(born(i));
  model.tree->bulk_load(ids, records, model.never);
  std::size_t done = count;
  for (; done < 3 * count; done += batch) {
    ids.clear(), records.clear(), gone.clear();
    for (std::size_t i = 0; i < batch; ++i) {
      gone.push_back(model.objects.begin()->first);
      model.objects.erase(gone.back());
      add(born(done + i));
    }
    model.tree->erase_all(gone, always, model.never);
    model.tree->merge(ids, records, model.never);
    if (packs) model.tree->repack_dispersed(2 * batch, hash_of(done));
  }
  model.expect_sound();
  return visits(model, born(done));
}

TEST(DispersedObjects, ArePackedWhileObjectsComeAndGo) {
  for (const std::size_t batch : {1, 20, 50}) {
    const double dispersed = visits_after_lives(batch, false);
    EXPECT_GT(dispersed, 10) << batch;
    EXPECT_LT(visits_after_lives(batch, true), 0.4 * dispersed) << batch;
  }
}

TEST(DispersedObjects, AreNotPackedWhereTheyRest) {
  TreeModel model(boats, 60);
  const RandomScene scene = random_scene({.layout = boats, .count = 500, .seed = 4});
  model.load(scene);
  const auto before = order_of(model);
  for (std::uint64_t draw = 0; draw < 20; ++draw) model.tree->repack_dispersed(always, draw);
  EXPECT_EQ(order_of(model), before);
  TreeModel empty(boats, 60);
  empty.tree->repack_dispersed(always, 1);
  empty.insert(1, {0, 1, 2, 3, 4, 5});
  empty.tree->repack_dispersed(always, 1);
  empty.expect_sound();
}

TEST(DispersedObjects, OfADamagedTreeAreLeftAlone) {
  TreeModel model(boats, 60);
  Random random(7);
  for (std::int64_t id = 0; id < 200; ++id)
    model.insert(id, boat(random, 0, random.in(0, side), random.in(0, side)));
  for (std::int64_t id = 200; id < 240; ++id)
    model.insert(id, boat(random, 500, random.in(0, side), random.in(0, side)));
  NodeNumber number = model.pages.find_root();
  while (model.pages.read(number)->level > 1) number = model.pages.read(number)->keys[0];
  Node& parent = model.pages.modify(number);
  const auto entry = std::vector<double>(parent.values.begin(), parent.values.begin() + entry_size(2));
  parent.keys.push_back(parent.keys[0]);
  parent.values.insert(parent.values.end(), entry.begin(), entry.end());
  const auto before = order_of(model);
  for (std::uint64_t draw = 0; draw < 100; ++draw) model.tree->repack_dispersed(always, draw);
  EXPECT_EQ(order_of(model), before);
}

// The clock is that of the last reports, not of ships that have been silent for long.
TEST(Loads, ShapeTheTreeForTheTimeThatMostObjectsHaveReached) {
  TreeModel model(boats, 60, 20);
  Random random(3);
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  for (std::int64_t id = 0; id < 4000; ++id) {
    const auto& record = model.objects[id] =
        boat(random, random.in(0, 200), random.in(0, side), random.in(0, side));
    ids.push_back(id), records.insert(records.end(), record.begin(), record.end());
  }
  model.tree->bulk_load(ids, records, model.never);
  model.tree->insert(4000, boat(random, 200, 1, 1));
  for (int i = 0; i < 20; ++i) model.tree->update(4000, boat(random, 200, 1, 1));
  EXPECT_LT(visits(model, 200), 5);
}

// A process that erases knows no time but that of what is stored.
TEST(Erasing, KeepsTheTreeTightInAProcessThatWritesNothing) {
  constexpr double now = 1.7e9;
  TreeModel model(boats, 60, 20);
  Random random(3);
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  for (std::int64_t id = 0; id < 4000; ++id) {
    const auto& record = model.objects[id] = boat(random, now, random.in(0, side), random.in(0, side));
    ids.push_back(id), records.insert(records.end(), record.begin(), record.end());
  }
  model.tree->bulk_load(ids, records, model.never);
  const double before = leaves_read(model, now);
  model.tree = make_tpr_tree(model.pages, 60);
  for (std::int64_t id = 0; id < 2000; id += 2) model.erase(id);
  model.erase_share(0.2, always, random);
  model.expect_sound();
  EXPECT_LT(leaves_read(model, now), 1.2 * before);
}

}  // namespace
}  // namespace foresee
