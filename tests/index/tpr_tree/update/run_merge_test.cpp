// Batches of new objects as loose leaves: the tree is sound, few nodes are written, and windows visit few leaves.
#include <gtest/gtest.h>

#include <set>

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

/// Notes which nodes are written.
class WrittenPages final : public Pages {
 public:
  explicit WrittenPages(Pages& pages) : pages_(pages) {}

  const Layout& layout() const override { return pages_.layout(); }
  NodeNumber find_root() override { return pages_.find_root(); }
  std::shared_ptr<const Node> read(NodeNumber number) override { return pages_.read(number); }
  std::size_t leaf_capacity() const override { return pages_.leaf_capacity(); }
  std::size_t inner_capacity() const override { return pages_.inner_capacity(); }
  Node& modify(NodeNumber number) override { return note(number), pages_.modify(number); }
  NodeNumber allocate() override {
    const NodeNumber number = pages_.allocate();
    note(number);
    return number;
  }
  NodeNumber reserve(std::size_t count) override { return pages_.reserve(count); }
  void put(NodeNumber number, Node node) override {
    EXPECT_LE(node.size(), node.is_leaf() ? leaf_capacity() : inner_capacity());
    note(number);
    pages_.put(number, std::move(node));
  }
  void free(NodeNumber number) override { pages_.free(number); }
  void set_root(NodeNumber number) override { pages_.set_root(number); }
  std::optional<NodeNumber> find_leaf(std::int64_t id) override { return pages_.find_leaf(id); }
  void place(std::span<const std::int64_t> ids, NodeNumber leaf) override { pages_.place(ids, leaf); }
  void forget(std::int64_t id) override { pages_.forget(id); }

  std::set<NodeNumber> written;

 private:
  void note(NodeNumber number) { written.insert(number); }

  Pages& pages_;
};

TEST(RunMerge, KeepsTheTreeSoundInEveryLayoutAtEverySize) {
  unsigned seed = 1;
  for (const Layout& layout : varied_layouts())
    for (const std::size_t capacity : {4, 7}) {
      SCOPED_TRACE(name_of(layout) + ", " + std::to_string(capacity));
      TreeModel model(layout, 3, capacity);
      Random random(seed);
      double clock = 0;
      const RandomScene other = random_scene({.layout = layout, .count = 60, .seed = seed++});
      int packed = 0;
      for (const std::size_t count : {40, 300, 33, 150, 60, 400, 35, 35, 35, 1000}) {
        packed += model.tree->packs_new(count);
        model.merge_new(random_scene({.layout = layout, .count = count, .seed = seed++}));
        model.expect_sound();
        if (count == 60) model.churn(other, 300, random, clock);
        if (count == 400) model.merge(other, 100, random);
        model.expect_sound();
        if (::testing::Test::HasFailure()) return;
      }
      EXPECT_GE(packed, 7);
    }
}

TEST(RunMerge, KeepsTheTreeSoundInEveryKindOfScene) {
  unsigned seed = 1;
  for (auto kind : all_scene_kinds) {
    SCOPED_TRACE(name_of(kind));
    TreeModel model(boats, 60, 8);
    Random random(2);
    double clock = 0;
    for (int round = 0; round < 8; ++round, clock += 50) {
      const RandomScene scene =
          random_scene({.layout = boats, .kind = kind, .count = 40 + random.below(500), .seed = seed++});
      model.merge_new(scene);
      model.expect_sound();
      model.churn(scene, 200, random, clock);
      model.expect_sound();
    }
  }
}

TEST(RunMerge, KeepsTheTreeSoundInSmallBatchesOfHighTrees) {
  TreeModel model(boats, 60, 4);
  for (unsigned batch = 0; batch < 200; ++batch) {
    model.merge_new(random_scene({.layout = boats, .count = 80, .seed = batch + 1}));
    if (batch % 10 == 9) model.expect_sound();
  }
}

TEST(RunMerge, RefusesANodeWithAChildTwice) {
  TreeModel model(boats, 60, 8);
  model.load(random_scene({.layout = boats, .count = 1000, .seed = 1}));
  const auto parent = model.pages.read(*model.pages.find_leaf(1))->parent;
  Node& node = model.pages.modify(parent);
  node.keys[1] = node.keys[0];
  const RandomScene more = random_scene({.layout = boats, .count = 1000, .seed = 2});
  std::vector<std::int64_t> ids(more.ids);
  for (std::int64_t& id : ids) id += 1000;
  EXPECT_THROW(model.tree->merge_new(ids, more.records, model.never), BrokenTree);
}

/// 25,000 objects in batches of equal size: the number of nodes written by all, over the number of nodes at the end.
double writes_of_batches(int batches, bool as_new) {
  const std::size_t batch = 25'000 / static_cast<std::size_t>(batches);
  MemoryPages pages(boats, 20, 20);
  WrittenPages counting(pages);
  const auto tree = make_tpr_tree(counting, 60);
  NeverInterrupt never;
  std::size_t written = 0;
  for (int i = 0; i < batches; ++i) {
    const RandomScene scene =
        random_scene({.layout = boats, .count = batch, .seed = static_cast<unsigned>(i) + 1});
    std::vector<std::int64_t> ids;
    for (std::size_t j = 0; j < batch; ++j)
      ids.push_back(static_cast<std::int64_t>(static_cast<std::size_t>(i) * batch + j + 1));
    counting.written.clear();
    as_new ? tree->merge_new(ids, scene.records, never) : tree->merge(ids, scene.records, never);
    written += counting.written.size();
  }
  EXPECT_TRUE(check_tree(pages, never).problems.empty());
  return static_cast<double>(written) / static_cast<double>(pages.node_count());
}

TEST(RunMerge, WritesAFractionOfTheTreeForEachBatch) {
  const double packed = writes_of_batches(25, true), in_place = writes_of_batches(25, false);
  EXPECT_LT(packed, 5.75);
  EXPECT_GT(in_place, 1.5 * packed);
}

TEST(RunMerge, PacksSmallBatchesIntoSubtrees) {
  const double packed = writes_of_batches(200, true), in_place = writes_of_batches(200, false);
  EXPECT_LT(packed, 13);
  EXPECT_GT(in_place, 1.5 * packed);
}

TEST(RunMerge, LeavesFewLooseLeavesAndFullOnes) {
  TreeModel model(boats, 60, 20);
  for (unsigned batch = 0; batch < 30; ++batch) {
    model.merge_new(random_scene({.layout = boats, .count = 700, .seed = batch + 1}));
    std::size_t loose = 0, leaves = 0;
    const auto count = [&](auto& self, NodeNumber number) -> void {
      const auto node = model.pages.read(number);
      for (const std::int64_t child : node->keys) {
        if (node->level > 1) self(self, child);
        if (node->level == 1) ++leaves, loose += child > number;
      }
    };
    count(count, model.pages.find_root());
    EXPECT_LT(static_cast<double>(loose), 0.5 * static_cast<double>(leaves)) << batch;
    EXPECT_LT(static_cast<double>(leaves), static_cast<double>(model.objects.size()) / (0.7 * 20) + 5)
        << batch;
  }
  model.expect_sound();
}

/// The number of leaves visited by small windows.
std::size_t leaves_in_windows(TreeModel& model, double side) {
  Random random(8);
  std::size_t leaves = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec<2> lower(random.in(0, side), random.in(0, side)), still = Vec<2>::zero();
    const Horizon horizon{0, 0};
    WindowWalk<2> walk(model.pages, moving_window<2>(lower, lower + side / 100, still, horizon), horizon,
                       still, model.never);
    for (LeafHits hits; walk.next(hits);) ++leaves;
  }
  return leaves;
}

/// The number of leaves that windows visit in a tree that has grown by so many batches, and in a fresh tree.
std::pair<std::size_t, std::size_t> visited_after(unsigned batches) {
  TreeModel grown(boats, 60, 20);
  for (unsigned batch = 0; batch < batches; ++batch)
    grown.merge_new(random_scene({.layout = boats, .count = 10'000 / batches, .seed = batch + 1}));
  const double side = [&] {
    double largest = 0;
    for (const auto& [id, record] : grown.objects)
      largest = std::max(largest, record[static_cast<std::size_t>(record_offsets(boats).x)]);
    return largest;
  }();
  const std::size_t leaves = leaves_in_windows(grown, side);
  grown.tree->rebuild(grown.never);
  return {leaves, leaves_in_windows(grown, side)};
}

TEST(RunMerge, WindowsVisitLessThanTwiceTheLeavesOfAFreshTree) {
  for (const unsigned batches : {20, 80}) {
    const auto [leaves, fresh] = visited_after(batches);
    EXPECT_GT(fresh, 100u);
    EXPECT_LT(leaves, 2 * fresh) << batches;
  }
}

}  // namespace
}  // namespace foresee
