// Kinds in the TPR-tree: entries contain the kinds beneath them after every change, a wrong entry is found, walks give
// what they accept and skip the rest.
#include <algorithm>

#include "index/tpr_tree/node.h"
#include "index/tpr_tree/search/nearest_walk.h"
#include "index/tpr_tree/search/window_walk.h"
#include "tests/index/tpr_tree/tree_model.h"

namespace foresee::testing {
namespace {

constexpr Layout kinds_of_boats{.axes = 2,
                                .law = Law::uniform,
                                .shape = Shape::ball,
                                .has_t = true,
                                .has_category = true,
                                .has_mask = true};

std::vector<std::int64_t> found_by(TreeModel& model, const std::optional<KindTest>& test) {
  std::vector<std::int64_t> ids;
  const Vec<2> far = Vec<2>::constant(1e9), still = Vec<2>::zero();
  WindowWalk<2> walk(model.pages, moving_window<2>(-far, far, still, {0, 1}), {0, 1}, still, model.never,
                     test);
  for (LeafHits hits; walk.next(hits);)
    for (const std::uint32_t slot : hits.slots) ids.push_back(hits.leaf->keys[slot]);
  std::sort(ids.begin(), ids.end());
  return ids;
}

TEST(TprTreeKinds, WalksReturnWhatTheyAcceptAfterEveryChange) {
  const RandomScene scene = random_scene({.layout = kinds_of_boats, .count = 300, .seed = 3});
  TreeModel model(kinds_of_boats, 30);
  Random random(5);
  double clock = 0;
  const Offsets at = record_offsets(kinds_of_boats);
  model.load(scene);
  for (int round = 0; round < 12; ++round) {
    if (round > 0) model.churn(scene, 200, random, clock);
    if (round % 3 == 2) model.merge(scene, 100, random);
    for (auto& [id, record] : model.objects) {  // the kinds alone
      if (random.below(4) != 0) continue;
      std::vector<double> changed = record;
      changed[static_cast<std::size_t>(at.category)] = static_cast<double>(random.below(9));
      model.update(id, changed);
    }
    model.expect_sound();
    for (const KindTest& test :
         {KindTest::of_categories(8), KindTest::of_categories(5), KindTest::of_categories(0),
          KindTest::of_partners({2, 6}), KindTest::of_partners({1, every_kind})}) {
      std::vector<std::int64_t> accepted;
      const std::vector<std::int64_t> all = found_by(model, {});
      for (const std::int64_t id : all)
        if (test.accepts(kinds_of(model.objects[id].data(), at))) accepted.push_back(id);
      EXPECT_EQ(found_by(model, test), accepted);
      std::size_t nearest = 0;
      const Vec<2> origin = Vec<2>::zero();
      NearestWalk<2> walk(model.pages, origin, origin, {0, 1}, model.never, test);
      for (LeafHits hits; walk.next(1e300, hits);) nearest += hits.slots.size();
      EXPECT_EQ(nearest, accepted.size());
    }
  }
}

TEST(TprTreeKinds, AnEntryWithoutABitBeneathItIsAProblem) {
  const RandomScene scene = random_scene({.layout = kinds_of_boats, .count = 200, .seed = 4});
  TreeModel model(kinds_of_boats, 30);
  model.load(scene);
  model.expect_sound();
  for (const bool of_category : {true, false}) {
    Node& root = model.pages.modify(model.pages.find_root());
    ASSERT_FALSE(root.is_leaf());
    const Kinds right = kinds_at(root, 0);
    std::uint32_t& bits = of_category ? root.kinds[0].category : root.kinds[0].mask;
    ASSERT_NE(bits, 0u);
    bits &= bits - 1;
    const TreeReport report = check_tree(model.pages, model.never);
    ASSERT_FALSE(report.problems.empty());
    EXPECT_NE(report.problems[0].find("which an entry above does not contain"), std::string::npos);
    root.kinds[0] = right;
  }
  Node& root = model.pages.modify(model.pages.find_root());
  root.kinds.pop_back();
  EXPECT_NE(check_tree(model.pages, model.never).problems.at(0).find("has numbers missing"),
            std::string::npos);
}

TEST(TprTreeKinds, ATableOfTheDefaultsStoresNone) {
  const RandomScene scene = random_scene({.layout = boats, .count = 200, .seed = 4});
  TreeModel model(boats, 30);
  model.load(scene);
  EXPECT_TRUE(model.pages.read(model.pages.find_root())->kinds.empty());
}

/// Counts the nodes that a walk reads.
class CountedPages final : public NodeSource {
 public:
  explicit CountedPages(MemoryPages& pages) : pages_(pages) {}
  const Layout& layout() const override { return pages_.layout(); }
  NodeNumber find_root() override { return pages_.find_root(); }
  std::shared_ptr<const Node> read(NodeNumber number) override { return ++count, pages_.read(number); }
  int count = 0;

 private:
  MemoryPages& pages_;
};

TEST(TprTreeKinds, WalksSkipNodesWithoutAnAcceptedKind) {
  RandomScene scene = random_scene({.layout = kinds_of_boats, .count = 400, .seed = 6});
  const Offsets at = record_offsets(kinds_of_boats);
  for (std::size_t i = 0; i < scene.size(); ++i) {  // a category for each half of the space
    double* record = scene.records.data() + i * static_cast<std::size_t>(at.size);
    record[at.category] = record[at.x] < scene.side / 2 ? 1 : 2;
  }
  TreeModel model(kinds_of_boats, 3);
  model.load(scene);
  const Vec<2> far = Vec<2>::constant(1e9), still = Vec<2>::zero();
  const auto reads = [&](std::uint32_t mask) {
    CountedPages pages(model.pages);
    WindowWalk<2> walk(pages, moving_window<2>(-far, far, still, {0, 1}), {0, 1}, still, model.never,
                       KindTest::of_categories(mask));
    for (LeafHits hits; walk.next(hits);) {
    }
    return pages.count;
  };
  EXPECT_LT(reads(1), 0.7 * reads(3));
  EXPECT_EQ(reads(4), 1);
}

}  // namespace
}  // namespace foresee::testing
