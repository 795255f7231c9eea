// Updates of objects: the nodes that they change, and the quality of the tree after many of them.
#include <gtest/gtest.h>

#include "index/tpr_tree/tpr_tree.h"
#include "tests/index/tpr_tree/tree_model.h"

namespace foresee {
namespace {

using testing::boats;
using testing::leaves_against_packed;
using testing::leaves_in_windows;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::TreeModel;

/// Counts the nodes whose change the tree announces.
class CountingPages final : public Pages {
 public:
  explicit CountingPages(Pages& pages) : pages_(pages) {}
  const Layout& layout() const override { return pages_.layout(); }
  NodeNumber find_root() override { return pages_.find_root(); }
  std::shared_ptr<const Node> read(NodeNumber number) override { return pages_.read(number); }
  std::size_t leaf_capacity() const override { return pages_.leaf_capacity(); }
  std::size_t inner_capacity() const override { return pages_.inner_capacity(); }
  Node& modify(NodeNumber number) override { return ++changes, pages_.modify(number); }
  NodeNumber allocate() override { return ++changes, pages_.allocate(); }
  NodeNumber reserve(std::size_t count) override { return ++changes, pages_.reserve(count); }
  void put(NodeNumber number, Node node) override { ++changes, pages_.put(number, std::move(node)); }
  void free(NodeNumber number) override { ++changes, pages_.free(number); }
  void set_root(NodeNumber number) override { pages_.set_root(number); }
  std::optional<NodeNumber> find_leaf(std::int64_t id) override { return pages_.find_leaf(id); }
  void place(std::span<const std::int64_t> ids, NodeNumber leaf) override {
    moves += ids.size(), pages_.place(ids, leaf);
  }
  void forget(std::int64_t id) override { pages_.forget(id); }

  int changes = 0;
  std::size_t moves = 0;  ///< of objects to another leaf

 private:
  Pages& pages_;
};

TEST(TprTreeUpdates, AnUpdateWithinTheLeafsBoundsTouchesTheLeafAlone) {
  const RandomScene scene = random_scene({.layout = boats, .count = 1000});
  TreeModel model(boats, 60, 10);
  model.load(scene);
  CountingPages counting(model.pages);
  for (const auto& [id, record] : model.objects) {
    if (record[0] == read_newest_t(counting)) continue;
    const auto tree = make_tpr_tree(counting, 60);  // a new tree, whose first updates repack no leaves
    counting.changes = counting.moves = 0;
    EXPECT_TRUE(tree->update(id, record));
    EXPECT_EQ(counting.changes, 1);
    EXPECT_EQ(counting.moves, 0u);
  }
}

// Each object that moves to another leaf may change another page of a small commit.
TEST(TprTreeUpdates, AnUpdateMovesNoMoreObjectsThanTwoLeavesMayShare) {
  constexpr std::size_t capacity = 64, max_moved = 100;
  constexpr double side = 250;
  TreeModel model(boats, 60, capacity);
  CountingPages counting(model.pages);
  const auto tree = make_tpr_tree(counting, 60);
  Random random(5);
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  for (std::int64_t id = 0; id < 4000; ++id) {
    ids.push_back(id);
    for (const double number :
         {0.0, random.in(0, side), random.in(0, side), random.in(-1, 1), random.in(-1, 1), 0.5})
      records.push_back(number);
  }
  tree->bulk_load(ids, records, model.never);
  for (double now = 0; now < 60; now += 0.003) {
    const std::size_t id = random.below(ids.size());
    double* const record = records.data() + 6 * id;
    record[1] += record[3] * (now - record[0]), record[2] += record[4] * (now - record[0]), record[0] = now;
    counting.moves = 0;
    EXPECT_TRUE(tree->update(ids[id], {record, 6}));
    ASSERT_LE(counting.moves, max_moved);
  }
}

TEST(TprTreeUpdates, ALeafWhoseSiblingsAreFullChangesAloneWhenItIsHalfEmpty) {
  TreeModel model(boats, 60, 10);
  RandomScene alike = random_scene({.layout = boats, .count = 90});
  for (std::size_t i = 6; i < alike.records.size(); ++i) alike.records[i] = alike.records[i - 6];
  model.load(alike);
  CountingPages counting(model.pages);
  const auto tree = make_tpr_tree(counting, 60);
  const std::vector<std::int64_t> ids = model.pages.read(*model.pages.find_leaf(alike.ids[0]))->keys;
  ASSERT_EQ(ids.size(), 9u);
  for (const std::int64_t id : std::span(ids).first(6)) {
    counting.changes = 0;
    EXPECT_TRUE(tree->erase(id));
    EXPECT_EQ(counting.changes, 1);
  }
}

TEST(TprTreeUpdates, ARunIsASubtreeBesideTheOthersWhateverItsSize) {
  Random random(9);
  unsigned seed = 1;
  for (const Layout& layout :
       {boats, Layout{.axes = 3, .law = Law::accelerated, .shape = Shape::box, .has_until = true},
        Layout{.axes = 1, .has_category = true}}) {
    std::size_t taken = 0, refused = 0;
    for (const std::size_t stored : {0, 1, 5, 30, 200, 1500})
      for (const std::size_t added : {1, 4, 20, 100, 700, 3000}) {
        TreeModel model(layout, 60, 5);
        if (stored > 0) model.load(random_scene({.layout = layout, .count = stored, .seed = seed++}));
        double clock = 0;
        for (int runs = 0; runs < 3; ++runs) {
          const bool takes = model.tree->takes_run(added);
          ++(takes ? taken : refused);
          if (!takes) break;
          model.add_run(random_scene({.layout = layout, .count = added, .seed = seed++}));
          model.expect_sound();
        }
        // Nodes of a run with few children are as sound as others when they change.
        if (!model.objects.empty())
          model.churn(random_scene({.layout = layout, .count = stored + added, .seed = seed++}), 300, random,
                      clock);
        model.expect_sound();
      }
    EXPECT_GE(taken, 45u);
    EXPECT_GE(refused, 5u);
  }
}

std::vector<double> boat(Random& random, double t, double x, double y) {
  return {t, x, y, random.in(-3, 3), random.in(-3, 3), 0.5};
}

constexpr std::size_t boat_count = 4000;
constexpr double side = 400;

/// Loads boats at random places; `t` gives the time of each.
template <class Time>
void load_boats(TreeModel& model, Random& random, Time t) {
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  for (std::size_t i = 0; i < boat_count; ++i) {
    const auto id = static_cast<std::int64_t>(i);
    const auto& record = model.objects[id] = boat(random, t(), random.in(0, side), random.in(0, side));
    ids.push_back(id), records.insert(records.end(), record.begin(), record.end());
  }
  model.tree->bulk_load(ids, records, model.never);
}

/// The state after many reports, as a multiple of that of a tree built from the same objects.
struct Decay {
  double nodes;
  testing::LeavesInWindows leaves;
};

/// Objects drift, and report in batches of this size; a batch of one is an update.
Decay decay_by_reports(std::size_t batch) {
  constexpr std::size_t count = boat_count;
  constexpr double duration = 20;
  TreeModel model(boats, 60, 20);
  Random random(6);
  load_boats(model, random, [] { return 0; });
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  for (std::size_t done = 0; done < 2 * count; done += batch) {
    const double now = duration * static_cast<double>(done) / (2 * count);
    ids.clear(), records.clear();
    while (ids.size() < batch) {
      const auto id = static_cast<std::int64_t>(random.below(count));
      if (std::find(ids.begin(), ids.end(), id) != ids.end()) continue;
      std::vector<double>& record = model.objects[id];
      const double past = now - record[0];
      record = boat(random, now, record[1] + record[3] * past, record[2] + record[4] * past);
      ids.push_back(id), records.insert(records.end(), record.begin(), record.end());
    }
    if (batch > 1)
      model.tree->merge(ids, records, model.never);
    else
      EXPECT_TRUE(model.tree->update(ids[0], records));
  }
  model.expect_sound();
  const auto nodes = static_cast<double>(model.pages.node_count());
  const auto leaves = leaves_against_packed(model, side, duration);
  return {nodes / static_cast<double>(model.pages.node_count()), leaves};
}

TEST(TprTreeUpdates, RemainTightAndFullWhileObjectsDrift) {
  for (const std::size_t batch : {1, 50, 250}) {
    const Decay decay = decay_by_reports(batch);
    EXPECT_LT(decay.nodes, 1.6) << batch;
    EXPECT_LT(decay.leaves.with_hits, batch == 1 ? 2 : 1.6) << batch;
    EXPECT_LT(decay.leaves.read, batch == 1 ? 3 : 2.5) << batch;
  }
}

TEST(TprTreeUpdates, EstimatesTheNumberOfObjectsOfUnevenTrees) {
  Random random(5);
  double lowest = 1, highest = 1;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    TreeModel model(boats, 60);
    model.load(random_scene({.layout = boats, .count = 3000, .seed = seed}));
    for (int round = 0; round < 4; ++round) {
      model.merge_new(random_scene({.layout = boats, .count = 300 + random.below(1500), .seed = seed + 99}));
      std::vector<std::int64_t> gone;  // of one half of the places, three quarters
      for (const auto& [id, record] : model.objects)
        if (record[1] < 0 && random.below(4) > 0) gone.push_back(id);
      for (const std::int64_t id : gone) model.erase(id);
      const auto count = static_cast<double>(model.objects.size());
      const double estimate = estimate_objects(model.pages, count / 8);
      lowest = std::min(lowest, estimate / count), highest = std::max(highest, estimate / count);
      EXPECT_EQ(estimate_objects(model.pages, count / 8), estimate);
    }
  }
  EXPECT_GT(lowest, 0.6);
  EXPECT_LT(highest, 1.7);
  TreeModel empty(boats, 60);
  EXPECT_EQ(estimate_objects(empty.pages, 5), 0);
}

// The time that counts is that of the last reports, not of ships that have been silent for long.
TEST(TprTreeUpdates, FollowALoadForTheTimeThatMostObjectsHaveReached) {
  constexpr double now = 200;
  TreeModel model(boats, 60, 20);
  Random random(3);
  load_boats(model, random, [&] { return random.in(0, now); });
  model.tree->insert(4000, boat(random, now, 1, 1));
  for (int i = 0; i < 20; ++i) model.tree->update(4000, boat(random, now, 1, 1));
  const auto leaves = leaves_against_packed(model, side, now);
  EXPECT_LT(leaves.read, 5);
  EXPECT_LT(leaves.with_hits, 2);
}

// A process that has written no t knows no time but that of what is stored.
TEST(TprTreeUpdates, EraseTightlyInAProcessThatWritesNothing) {
  constexpr double now = 1.7e9;
  TreeModel model(boats, 60, 20);
  Random random(3);
  load_boats(model, random, [] { return now; });
  const double before = leaves_in_windows(model, side, now).read;
  model.tree = make_tpr_tree(model.pages, 60);
  for (std::int64_t id = 0; id < 2000; id += 2) model.erase(id);
  model.erase_share(0.2, 1000, random);
  model.expect_sound();
  EXPECT_LT(leaves_in_windows(model, side, now).read, 1.2 * before);
}

}  // namespace
}  // namespace foresee
