// Kinds in a join as a library call: rows, helpers and explain equal those of all pairs, filtered; inert objects cost
// no pair.
#include <gtest/gtest.h>

#include <map>

#include "index/memory_pages.h"
#include "index/tpr_tree/tpr_tree.h"
#include "query/join/explain.h"
#include "query/join/pair_kinds.h"
#include "query/join_cases.h"

namespace foresee {
namespace {

using testing::IdPairs;
using testing::numbers_of;
using testing::pairs_of;
using testing::question_about;
using testing::random_scene;
using testing::RandomScene;
using testing::rows_of;
using testing::scene_of;
using testing::SceneKind;

NeverInterrupt no_interrupt;
constexpr Layout kinds_of_discs{
    .axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_category = true, .has_mask = true};

/// The rows of the same scene whose columns have other names, filtered.
std::vector<JoinRow> filtered(const RandomScene& scene) {
  RandomScene plain = scene;
  plain.layout.has_category = plain.layout.has_mask = false;
  plain.rows.clear();
  std::map<std::int64_t, Kinds> kinds;
  const Bodies bodies = scene.bodies();
  for (std::size_t i = 0; i < scene.size(); ++i) {
    plain.rows.insert(plain.rows.end(), bodies.row(i), bodies.row(i) + bodies.at.category);
    kinds[scene.ids[i]] = kinds_of(bodies.row(i), bodies.at);
  }
  std::vector<JoinRow> rows = rows_of(question_about(plain));
  std::erase_if(rows, [&](const JoinRow& row) { return !may_meet(kinds[row.a], kinds[row.b]); });
  return rows;
}

TEST(JoinKinds, RowsAreTheFilteredOnesWithAndWithoutHelpers) {
  for (const SceneKind kind : {SceneKind::uniform, SceneKind::one_giant}) {
    const RandomScene scene =
        random_scene({.layout = kinds_of_discs, .kind = kind, .count = 15000, .seed = 11});
    const std::vector<double> expected = numbers_of(filtered(scene));
    ASSERT_FALSE(expected.empty());
    for (const std::size_t helpers : {0, 3}) {
      JoinQuestion question = question_about(scene);
      question.method = JoinMethod::grid, question.helpers = helpers;
      EXPECT_EQ(numbers_of(rows_of(question)), expected) << name_of(kind) << ", " << helpers;
    }
  }
}

/// Half of the objects meet nothing: category 1, mask 0 beside 2, 2.
RandomScene half_inert(std::size_t count) {
  RandomScene scene = random_scene({.layout = kinds_of_discs, .count = count, .seed = 12});
  const Offsets at = row_offsets(scene.layout);
  for (std::size_t i = 0; i < count; ++i) {
    double* const row = scene.rows.data() + i * static_cast<std::size_t>(at.size);
    row[at.category] = i % 2 ? 2 : 1, row[at.mask] = i % 2 ? 2 : 0;
  }
  return scene;
}

TEST(JoinKinds, InertObjectsAreLeftOutBeforeTheIndex) {
  const RandomScene scene = half_inert(1000);
  const JoinQuestion active = without_inert(question_about(scene), never);
  EXPECT_EQ(active.a->size(), 500u);
  EXPECT_EQ(numbers_of(rows_of(question_about(scene))), numbers_of(filtered(scene)));
  JoinQuestion itself = question_about(scene);
  itself.b = itself.a;
  const JoinQuestion active_itself = without_inert(itself, never);
  EXPECT_EQ(active_itself.a, active_itself.b);
  EXPECT_EQ(active_itself.a->size(), 500u);
  JoinQuestion between = question_about(scene);
  between.b = scene_of(random_scene({.layout = testing::discs, .count = 10, .seed = 3}), "plain");
  EXPECT_EQ(without_inert(between, never).a->size(), 0u) << "the default category is 1, which no mask has";
  EXPECT_EQ(pairs_of(between), IdPairs{});
}

TEST(JoinKinds, AnActiveSceneIsKeptAndKeepsItsTree) {
  const RandomScene scene = half_inert(300);
  MemoryPages pages(scene.layout);
  make_tpr_tree(pages, 3)->bulk_load(scene.ids, scene.rows, no_interrupt);
  TreeScene tree = read_tree(pages, no_interrupt);
  auto with_levels = std::make_shared<Scene>();
  with_levels->name = "ships", with_levels->layout = scene.layout;
  with_levels->ids = tree.ids, with_levels->rows = tree.rows, with_levels->levels = tree.levels;
  JoinQuestion question = question_about(scene);
  question.a = with_levels, question.method = JoinMethod::tree;
  const JoinQuestion active = without_inert(question, never);
  EXPECT_EQ(active.a->size(), 150u);
  EXPECT_EQ(active.a->levels->starts.at(0).back(), 150u);
  EXPECT_EQ(active.a->levels->starts.size(), tree.levels.starts.size());
  EXPECT_EQ(without_inert(question, never).a, active.a);
  EXPECT_EQ(numbers_of(rows_of(question)), numbers_of(filtered(scene)));
  question.b = scene_of(random_scene({.layout = testing::discs, .count = 10, .seed = 3}), "plain");
  question.method = JoinMethod::scan;
  EXPECT_EQ(without_inert(question, never).a->size(), 0u) << "others than those that the kept scene is for";
}

TEST(JoinKinds, ABulkLoadGivesInertObjectsLeavesOfTheirOwn) {
  const RandomScene scene = half_inert(4000);
  MemoryPages pages(scene.layout);
  make_tpr_tree(pages, 3)->bulk_load(scene.ids, scene.rows, no_interrupt);
  const Kinds all = kinds_of_all(pages);
  EXPECT_EQ(all, (Kinds{3, 2}));
  const KindTest wanted = KindTest::of_partners(all);
  const WantedLeaves leaves = find_leaves(pages, wanted, no_interrupt);
  EXPECT_GE(leaves.others, leaves.numbers.size() - 4);  // giants are apart
  const TreeScene active = read_tree(pages, no_interrupt, wanted);
  EXPECT_EQ(active.ids.size(), 2000u);
  EXPECT_FALSE(active.complete);
  JoinQuestion question = question_about(scene);
  auto thinned = std::make_shared<Scene>();
  thinned->name = "ships", thinned->layout = scene.layout;
  thinned->ids = active.ids, thinned->rows = active.rows, thinned->levels = active.levels;
  question.a = thinned, question.method = JoinMethod::tree;
  EXPECT_EQ(numbers_of(rows_of(question)), numbers_of(filtered(scene)));
  EXPECT_EQ(check_tree(pages, no_interrupt).problems, std::vector<std::string>{});
}

TEST(JoinKinds, ExplainCountsThePairsThatMayMeetFirst) {
  const RandomScene scene = half_inert(1000);
  JoinQuestion question = question_about(scene);
  const std::vector<ExplainRow> rows = explain_join(question, no_interrupt);
  EXPECT_STREQ(rows.at(0).stage, "kinds");
  EXPECT_EQ(rows[0].before, 1000u * 999 / 2);
  EXPECT_EQ(rows[0].after, 500u * 499 / 2);
  EXPECT_EQ(rows[1].before, rows[0].after);
  EXPECT_EQ(rows.back().after, rows_of(question).size());
  question.b = scene_of(random_scene({.layout = testing::discs, .count = 10, .seed = 3}), "plain");
  const std::vector<ExplainRow> none = explain_join(question, no_interrupt);
  EXPECT_EQ(none.at(0).before, 10000u);
  for (std::size_t i = 1; i < none.size(); ++i) EXPECT_EQ(none[i].before, 0u);
}

TEST(JoinKinds, ATableWithoutThemHasNoKinds) {
  const JoinQuestion question =
      question_about(random_scene({.layout = testing::discs, .count = 10, .seed = 3}));
  EXPECT_EQ(without_inert(question, never).a, question.a);
  EXPECT_EQ(with_kinds(question).kinds, nullptr);
}

}  // namespace
}  // namespace foresee
