// predictive_explain as a library call: its counts equal those of a test of every pair without index or
// batches.
#include "query/join/explain.h"

#include <gtest/gtest.h>

#include "index/paper_grid/trajectory.h"
#include "query/join_cases.h"
#include "sanitized.h"

namespace foresee {
namespace {

using testing::all_scene_kinds;
using testing::name_of;
using testing::question_about;
using testing::random_scene;
using testing::RandomScene;
using testing::rows_of;
using testing::sanitized;
using testing::scene_of;
using testing::SceneKind;
using testing::varied_layouts;

NeverInterrupt never;
constexpr const char* stage_names[] = {"candidates",    "projection overlap",      "centre point",
                                       "time interval", "trajectory intersection", "exact time",
                                       "refinement"};

using Counts = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

Counts counts_of(const std::vector<ExplainRow>& rows) {
  Counts counts;
  for (const ExplainRow& row : rows) counts.emplace_back(row.before, row.after);
  return counts;
}

Counts explained(JoinQuestion question, JoinMethod method) {
  question.method = method;
  return counts_of(explain_join(question, never));
}

/// Counts every pair in every stage: two boxes share a cell where their cells overlap on every axis.
template <int D>
Counts counted_plainly(const RandomScene& scene) {
  const Vec<D> margin = Vec<D>::constant(scene.within / 2);
  std::vector<Trajectory<D>> t;
  for (std::size_t i = 0; i < scene.size(); ++i)
    t.push_back(trajectory_of<D>(scene.bodies(), i, scene.horizon(), margin));
  RandomScene points = scene;  // the same rows without shapes
  points.layout.shape = Shape::point;
  const auto at = static_cast<std::size_t>(points.bodies().at.size);
  const auto size = static_cast<std::size_t>(scene.bodies().at.size);
  points.rows.clear();
  for (std::size_t i = 0; i < scene.size(); ++i)
    points.rows.insert(points.rows.end(), scene.rows.begin() + static_cast<std::ptrdiff_t>(i * size),
                       scene.rows.begin() + static_cast<std::ptrdiff_t>(i * size + at));
  const auto centres = make_contact(points.bodies(), points.bodies(), {.horizon = scene.horizon()}, "", "");
  const auto contact = make_contact(scene.bodies(), scene.bodies(),
                                    {.horizon = scene.horizon(), .within = scene.within}, "", "");

  Vec<D> sum = Vec<D>::zero(), from = Vec<D>::constant(1e300);
  for (const Trajectory<D>& one : t)
    sum += one.swept.upper - one.swept.lower, from = from.min(one.swept.lower);
  const Vec<D> per_unit = 1 / (sum / static_cast<double>(t.size()));
  const auto cell = [&](const Vec<D>& x) {
    Vec<D> cells = (x - from) * per_unit;
    for (int j = 0; j < D; ++j) cells[j] = std::floor(cells[j]);
    return cells;
  };

  std::uint64_t all = 0, share = 0, overlap = 0, in_time = 0, in_space = 0, touch = 0;
  for (std::uint32_t i = 0; i < t.size(); ++i)
    for (std::uint32_t j = i + 1; j < t.size(); ++j) {
      const Pair pair{i, j};
      const Trajectory<D>&a = t[i], &b = t[j];
      ++all;
      if (!((cell(a.swept.lower) <= cell(b.swept.upper)).all() &&
            (cell(b.swept.lower) <= cell(a.swept.upper)).all()))
        continue;
      ++share;
      if (!a.swept.meets(b.swept)) continue;
      ++overlap;
      std::vector<Pair> met, hit;
      centres->decide(std::span(&pair, 1), met);
      if (met.empty() && !times_may_overlap<D>(a, b)) continue;
      ++in_time;
      if (met.empty() && !regions_may_meet<D>(a, b)) continue;
      ++in_space;
      contact->decide(std::span(&pair, 1), hit);
      touch += hit.size();
    }
  return {{all, share},        {share, overlap},  {overlap, overlap}, {overlap, in_time},
          {in_time, in_space}, {in_space, touch}, {touch, touch}};
}

template <int D>
void expect_the_plain_counts() {
  for (Shape shape : {Shape::point, Shape::box, Shape::ball})
    for (Law law : {Law::uniform, Law::accelerated})
      for (SceneKind kind : {SceneKind::uniform, SceneKind::clustered}) {
        const auto scene = random_scene(
            {.layout = {.axes = D, .law = law, .shape = shape}, .kind = kind, .count = 250, .seed = 31});
        EXPECT_EQ(explained(question_about(scene), JoinMethod::gpcd), counted_plainly<D>(scene))
            << name_of(scene.layout);
      }
}

TEST(Explain, CountsWhatEveryPairOneByOneGives) {
  expect_the_plain_counts<1>();
  expect_the_plain_counts<2>();
  expect_the_plain_counts<3>();
}

TEST(Explain, NamesTheStagesInThePapersOrder) {
  const auto scene = random_scene({.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball}});
  const auto rows = explain_join(question_about(scene), never);
  ASSERT_EQ(rows.size(), std::size(stage_names));
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_STREQ(rows[i].stage, stage_names[i]);
}

/// The stages lead from all pairs to those that touch; the input of each is the output of the one before.
void expect_a_chain(const JoinQuestion& question, std::uint64_t all, const std::string& what) {
  const auto touching = rows_of(question).size();
  for (JoinMethod method : {JoinMethod::automatic, JoinMethod::grid, JoinMethod::scan, JoinMethod::gpcd}) {
    const Counts counts = explained(question, method);
    ASSERT_EQ(counts.size(), std::size(stage_names)) << what;
    EXPECT_EQ(counts.front().first, all) << what;
    EXPECT_EQ(counts.back().second, touching) << what << " by " << name_of(method);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      EXPECT_LE(counts[i].second, counts[i].first) << what;
      if (i > 0) {
        EXPECT_EQ(counts[i].first, counts[i - 1].second) << what;
      }
    }
  }
}

TEST(Explain, LeadsFromAllPairsToThoseOfTheJoin) {
  for (const Layout& layout : varied_layouts())
    for (SceneKind kind : all_scene_kinds) {
      const std::size_t count = sanitized ? 20 : 40;
      const auto scene = random_scene({.layout = layout, .kind = kind, .count = count, .seed = 32});
      expect_a_chain(question_about(scene), count * (count - 1) / 2, name_of(layout) + ", " + name_of(kind));
    }
}

TEST(Explain, BetweenTwoTablesStartsWithEveryPair) {
  for (const Layout& layout : varied_layouts()) {
    const auto ships = random_scene({.layout = layout, .count = 40, .seed = 33});
    const auto crates = random_scene({.layout = layout, .count = 25, .seed = 34});
    JoinQuestion question = question_about(ships);
    question.b = scene_of(crates, "crates");
    expect_a_chain(question, 40 * 25, name_of(layout));
    question.b = question.a;
    expect_a_chain(question, 40 * 39, name_of(layout) + " with itself");
  }
}

TEST(Explain, AppliesWithinAndWithinZ) {
  const auto aircraft =
      random_scene({.layout = {.axes = 3, .law = Law::accelerated, .has_t = true}, .count = 150, .seed = 35});
  JoinQuestion question = question_about(aircraft);
  question.within = 3;
  expect_a_chain(question, 150 * 149 / 2, "within 3");
  const auto wide = rows_of(question).size();
  question.within_z = 0.25;
  expect_a_chain(question, 150 * 149 / 2, "within 3, along z 0.25");
  EXPECT_LT(rows_of(question).size(), wide);
}

TEST(Explain, CountsTheSameWhateverTheOrderOfTheRows) {
  auto scene = random_scene(
      {.layout = {.axes = 3, .law = Law::accelerated, .shape = Shape::box}, .count = 300, .seed = 36});
  const Counts counts = explained(question_about(scene), JoinMethod::gpcd);
  const auto size = scene.rows.size() / scene.size();
  for (std::size_t i = 0; i < scene.size() / 2; ++i)
    std::swap_ranges(scene.rows.begin() + static_cast<std::ptrdiff_t>(i * size),
                     scene.rows.begin() + static_cast<std::ptrdiff_t>((i + 1) * size),
                     scene.rows.end() - static_cast<std::ptrdiff_t>((i + 1) * size));
  std::reverse(scene.ids.begin(), scene.ids.end());
  const Counts again = explained(question_about(scene), JoinMethod::gpcd);
  EXPECT_EQ(again.back(), counts.back());
  // The mean is a sum in row order: its last digit may move a pair across the edge of a cell.
  EXPECT_NEAR(static_cast<double>(again[0].second), static_cast<double>(counts[0].second), 2);
}

TEST(Explain, ReportsPrunePowerInPercent) {
  EXPECT_EQ((ExplainRow{"", 200, 50}.prune_power()), 75);
  EXPECT_EQ((ExplainRow{"", 200, 200}.prune_power()), 0);
  EXPECT_FALSE((ExplainRow{"", 0, 0}.prune_power()).has_value());
}

TEST(Explain, MeasuresTheTimeOfEveryStageThatHasPairs) {
  const auto scene = random_scene(
      {.layout = {.axes = 3, .law = Law::accelerated, .shape = Shape::box}, .count = 3000, .seed = 37});
  JoinQuestion question = question_about(scene);
  question.method = JoinMethod::gpcd;
  for (const ExplainRow& row : explain_join(question, never)) {
    if (row.detail == "left out: no outlines; step 6") continue;
    EXPECT_GT(row.seconds, 0) << row.stage;
    EXPECT_LT(row.seconds, 60) << row.stage;
  }
}

TEST(Explain, SaysWhichStagesTheMethodLeavesOut) {
  const auto scene =
      random_scene({.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball}, .count = 100});
  JoinQuestion question = question_about(scene);
  for (JoinMethod method : {JoinMethod::grid, JoinMethod::scan, JoinMethod::gpcd}) {
    question.method = method;
    const auto rows = explain_join(question, never);
    EXPECT_TRUE(rows[0].detail.starts_with("method '" + std::string(name_of(method)) + "'"))
        << rows[0].detail;
    for (std::size_t stage = 1; stage <= 4; ++stage)
      EXPECT_EQ(rows[stage].detail.starts_with("left out: "), method != JoinMethod::gpcd)
          << rows[stage].detail;
  }
  EXPECT_NE(explain_join(question, never)[0].detail.find("cells of "), std::string::npos);
  question.method = JoinMethod::grid;
  EXPECT_NE(explain_join(question, never)[0].detail.find(" stripes of "), std::string::npos);
  question.method = JoinMethod::automatic;
  EXPECT_TRUE(explain_join(question, never)[0].detail.starts_with("method 'auto' takes '"));
}

TEST(Explain, HasNoRowsWithoutObjects) {
  const auto scene = random_scene({.layout = {.axes = 2}, .count = 5});
  JoinQuestion question{.a = scene_of({.axes = 2}, {}, {}), .h = 5};
  EXPECT_TRUE(explain_join(question, never).empty());
  question.b = scene_of(scene);
  EXPECT_TRUE(explain_join(question, never).empty());
}

TEST(Explain, RefusesWhatTheJoinRefuses) {
  const auto scene = random_scene({.layout = {.axes = 2}, .count = 5});
  JoinQuestion question = question_about(scene);
  question.h = -1;
  EXPECT_THROW(explain_join(question, never), Error);
  question.h = 1;
  question.within_z = 1;
  EXPECT_THROW(explain_join(question, never), Error);
}

}  // namespace
}  // namespace foresee
