// Every method gives the same rows: grid = gpcd = scan, and a join of one id = the filtered join.
#include <gtest/gtest.h>

#include "query/join_cases.h"
#include "sanitized.h"

namespace foresee {
namespace {

using testing::after_now;
using testing::all_layouts;
using testing::all_scene_kinds;
using testing::name_of;
using testing::numbers_of;
using testing::question_about;
using testing::random_scene;
using testing::RandomScene;
using testing::rows_of;
using testing::sanitized;
using testing::scene_of;
using testing::SceneKind;
using testing::SceneSpec;
using testing::varied_layouts;

std::vector<double> answer(JoinQuestion question, JoinMethod method) {
  question.method = method;
  return numbers_of(rows_of(question));
}

class JoinOfEveryLayout : public ::testing::TestWithParam<Layout> {};

TEST_P(JoinOfEveryLayout, GridAndGpcdAgreeWithScan) {
  std::size_t pairs = 0;
  for (SceneKind kind : all_scene_kinds) {
    const RandomScene scene = random_scene({.layout = GetParam(), .kind = kind, .count = 120, .seed = 5});
    const auto scanned = answer(question_about(scene), JoinMethod::scan);
    EXPECT_EQ(answer(question_about(scene), JoinMethod::grid), scanned) << name_of(kind);
    EXPECT_EQ(answer(question_about(scene), JoinMethod::gpcd), scanned) << name_of(kind);
    pairs += scanned.size();
  }
  EXPECT_GT(pairs, 0u);
}

TEST_P(JoinOfEveryLayout, GridAndGpcdAgreeWithScanAtTheEdgesOfTime) {
  const RandomScene scene = random_scene({.layout = GetParam(), .count = 40, .seed = 6});
  for (double h : {0.0, 1e9, 1e100}) {
    JoinQuestion question = question_about(scene);
    question.h = h;
    const auto scanned = answer(question, JoinMethod::scan);
    EXPECT_EQ(answer(question, JoinMethod::grid), scanned) << h;
    EXPECT_EQ(answer(question, JoinMethod::gpcd), scanned) << h;
  }
}

TEST_P(JoinOfEveryLayout, OneIdGivesTheRowsOfTheWholeJoin) {
  const RandomScene scene =
      random_scene({.layout = GetParam(), .kind = SceneKind::clustered, .count = 80, .seed = 7});
  const auto whole = rows_of(question_about(scene));
  for (std::int64_t id : {1, 20, 40, 80}) {
    std::vector<JoinRow> as_a, as_b;
    for (const JoinRow& row : whole) {
      if (row.a == id) as_a.push_back(row);
      if (row.b == id) as_b.push_back(row);
    }
    JoinQuestion question = question_about(scene);
    question.only_a = id;
    EXPECT_EQ(numbers_of(rows_of(question)), numbers_of(as_a)) << id;
    question.only_a.reset();
    question.only_b = id;
    EXPECT_EQ(numbers_of(rows_of(question)), numbers_of(as_b)) << id;
  }
}

INSTANTIATE_TEST_SUITE_P(AxesLawShapeTimes, JoinOfEveryLayout, ::testing::ValuesIn(varied_layouts()));

/// Layouts that may be joined: as many axes, and no cylinder with a ball.
std::vector<std::pair<Layout, Layout>> mixed_layouts() {
  constexpr std::size_t step = sanitized ? 21 : 7;
  std::vector<std::pair<Layout, Layout>> mixed;
  const std::vector<Layout> all = all_layouts();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i % step; j < all.size(); j += step) {
      const auto both = [&](Shape a, Shape b) { return all[i].shape == a && all[j].shape == b; };
      if (all[i].axes != all[j].axes) continue;
      if (both(Shape::cylinder, Shape::ball) || both(Shape::ball, Shape::cylinder)) continue;
      mixed.emplace_back(all[i], all[j]);
    }
  return mixed;
}

TEST(JoinOfTwoTables, GridAndGpcdAgreeWithScanForMixedLayouts) {
  for (const auto& [a, b] : mixed_layouts()) {
    const RandomScene ships = random_scene({.layout = a, .count = 60, .seed = 8});
    const RandomScene crates = random_scene({.layout = b, .count = 40, .seed = 9});
    JoinQuestion question = question_about(ships);
    question.b = scene_of(crates, "crates");
    question.within = 0.5;
    const auto scanned = answer(question, JoinMethod::scan);
    EXPECT_EQ(answer(question, JoinMethod::grid), scanned) << name_of(a) << " and " << name_of(b);
    EXPECT_EQ(answer(question, JoinMethod::gpcd), scanned) << name_of(a) << " and " << name_of(b);
    question.only_b = 7;
    EXPECT_LE(rows_of(question).size(), scanned.size());
  }
}

TEST(JoinOfTwoTables, IsTheMirrorImageOfTheOtherOrder) {
  for (const auto& [a, b] : mixed_layouts()) {
    const RandomScene ships = random_scene({.layout = a, .count = 30, .seed = 8});
    const RandomScene crates = random_scene({.layout = b, .count = 30, .seed = 9});
    JoinQuestion question = question_about(ships);
    question.b = scene_of(crates, "crates");
    auto there = rows_of(question);
    std::swap(question.a, question.b);
    const auto back = rows_of(question);
    for (JoinRow& row : there) std::swap(row.a, row.b);
    std::sort(there.begin(), there.end(),
              [](const JoinRow& l, const JoinRow& r) { return std::pair(l.a, l.b) < std::pair(r.a, r.b); });
    EXPECT_EQ(numbers_of(there), numbers_of(back)) << name_of(a) << " and " << name_of(b);
  }
}

TEST(JoinOfManyObjects, GridAndGpcdAgreeWithScan) {
  const Layout discs{.axes = 2, .law = Law::uniform, .shape = Shape::ball};
  const std::size_t many = sanitized ? 1500 : 5000;
  const SceneSpec specs[] = {
      {.layout = discs, .kind = SceneKind::uniform, .count = many, .seed = 10},
      {.layout = discs, .kind = SceneKind::one_fast, .count = many, .seed = 11},
      {.layout = {.axes = 1, .law = Law::uniform}, .kind = SceneKind::clustered, .count = 3000, .seed = 12},
      {.layout = {.axes = 3, .law = Law::accelerated, .shape = Shape::box, .has_t = true},
       .kind = SceneKind::one_giant,
       .count = 1500,
       .seed = 13}};
  for (const SceneSpec& spec : specs) {
    const RandomScene scene = random_scene(spec);
    const auto question = question_about(scene);
    const auto scanned = answer(question, JoinMethod::scan);
    EXPECT_EQ(answer(question, JoinMethod::grid), scanned)
        << name_of(spec.layout) << ", " << name_of(spec.kind);
    EXPECT_EQ(answer(question, JoinMethod::gpcd), scanned)
        << name_of(spec.layout) << ", " << name_of(spec.kind);
  }
}

/// The columns a, b, t and dt of a join in which only these are wanted.
std::vector<double> starts_of(JoinQuestion question, JoinMethod method) {
  question.method = method, question.wants = {.ends = false, .approach = false};
  std::vector<double> numbers;
  for (const JoinRow& row : rows_of(question))
    numbers.insert(numbers.end(),
                   {static_cast<double>(row.a), static_cast<double>(row.b), row.contact.t, row.contact.dt});
  return numbers;
}

TEST(JoinOfManyObjects, WhoseStartsAloneAreWantedHasTheSameRows) {
  constexpr std::size_t count = sanitized ? 50 : 150;
  std::uint64_t seed = 20;
  for (const Layout& layout : varied_layouts()) {
    const RandomScene scene =
        random_scene({.layout = layout, .kind = SceneKind::one_giant, .count = count, .seed = ++seed});
    JoinQuestion question = question_about(scene);
    for (int kind = 0; kind < 6; ++kind) {
      if (kind == 1) question.queried_dt = after_now;
      if (kind == 2) question.queried_dt = {0, 0};
      if (kind == 3) question.queried_dt = {}, question.only_a = scene.ids[scene.size() / 2];
      if (kind == 4) question.only_a.reset(), question.b = question.a;
      if (kind == 5) question.b = scene_of(scene, "others");
      EXPECT_EQ(starts_of(question, JoinMethod::grid), starts_of(question, JoinMethod::scan))
          << name_of(layout) << ", query " << kind;
    }
  }
}

TEST(JoinOfManyObjects, ChoosesAMethodWithoutChangingTheRows) {
  for (std::size_t count : {2u, 40u, 60u, 100u, 1000u}) {
    const RandomScene scene = random_scene(
        {.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball}, .count = count, .seed = 11});
    EXPECT_EQ(answer(question_about(scene), JoinMethod::automatic),
              answer(question_about(scene), JoinMethod::scan));
  }
}

}  // namespace
}  // namespace foresee
