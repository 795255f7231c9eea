// k nearest neighbours: rows are ranked by the real distance rounded once, ties by id, in scenes and in
// trees.
#include "query/nearest/nearest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "query/search_cases.h"

namespace foresee {
namespace {

using testing::all_scene_kinds;
using testing::as_scene;
using testing::as_tree;
using testing::name_of;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::rows_of;
using testing::scene_of;
using testing::shifted;
using testing::varied_layouts;

constexpr double infinity = std::numeric_limits<double>::infinity();

using Row = std::tuple<std::int64_t, double, double, double>;

std::vector<Row> answer(const NearestQuestion& question) {
  NeverInterrupt never;
  std::vector<Row> rows;
  for (const NearestRow& row : nearest(question, never))
    rows.emplace_back(row.id, row.distance, row.t, row.dt);
  return rows;
}

NearestQuestion random_question(Random& random, const RandomScene& scene, int i) {
  NearestQuestion question{.objects = as_scene(scene), .now = scene.now, .h = i % 4 == 0 ? 0.0 : scene.h};
  question.k = i % 5 == 4 ? 1000 : 1 + static_cast<std::int64_t>(random.below(12));
  for (int axis = 0; axis < scene.layout.axes; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    question.point[j] = i % 3 == 0 ? std::floor(random.in(0, scene.side)) : random.in(0, scene.side);
    if (i % 2) question.velocity[j] = random.in(-3, 3);
  }
  return question;
}

/// The objects without a shape, and the query point in a table of its own.
std::map<std::int64_t, JoinRow> approaches(const RandomScene& scene, const NearestQuestion& question,
                                           double within, std::optional<std::int64_t> only = {}) {
  Layout bare = scene.layout;
  bare.shape = Shape::point;
  if (bare.law == Law::forced) bare.law = Law::accelerated;
  const Offsets from = row_offsets(scene.layout), to = row_offsets(bare);
  std::vector<double> rows(scene.size() * static_cast<std::size_t>(to.size));
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const double* source = scene.bodies().row(i);
    double* row = rows.data() + i * static_cast<std::size_t>(to.size);
    const auto copy = [&](int there, int here, int count) {
      if (here != Offsets::absent) std::copy_n(source + there, count, row + here);
    };
    copy(from.t, to.t, 1), copy(from.x, to.x, bare.axes), copy(from.v, to.v, bare.axes);
    copy(from.a, to.a, bare.axes), copy(from.until, to.until, 1);
  }
  const Layout point{.axes = bare.axes, .law = Law::uniform, .has_t = true};
  std::vector<double> at{question.now};
  for (int axis = 0; axis < bare.axes; ++axis) at.push_back(*question.point[static_cast<std::size_t>(axis)]);
  for (int axis = 0; axis < bare.axes; ++axis)
    at.push_back(question.velocity[static_cast<std::size_t>(axis)]);
  std::map<std::int64_t, JoinRow> found;
  for (const JoinRow& row : rows_of({.a = scene_of(point, {1}, at),
                            .b = scene_of(bare, scene.ids, rows),
                            .now = question.now,
                            .h = question.h,
                            .within = within,
                            .method = JoinMethod::scan,
                            .only_b = only}))
    found.emplace(row.b, row);
  return found;
}

class NearestOfEveryLayout : public ::testing::TestWithParam<Layout> {};

TEST_P(NearestOfEveryLayout, RanksEveryObjectByItsExactDistance) {
  for (auto kind : all_scene_kinds) {
    const RandomScene scene = random_scene({.layout = GetParam(), .kind = kind, .count = 16, .seed = 41});
    Random random(42);
    for (int i = 0; i < 4; ++i) {
      NearestQuestion question = random_question(random, scene, i);
      question.k = 1000;
      const std::vector<Row> rows = answer(question);
      const auto all = approaches(scene, question, 1e9);
      ASSERT_EQ(rows.size(), all.size()) << name_of(kind) << " " << i;
      double last = 0;
      std::int64_t last_id = 0;
      for (const auto& [id, distance, t, dt] : rows) {
        const ClosestApproach& near = all.at(id).approach;
        EXPECT_EQ(t, near.t);
        EXPECT_EQ(dt, near.dt);
        EXPECT_NEAR(distance, near.d, 1e-12 * near.d + 1e-14);
        EXPECT_TRUE(last < distance || (last == distance && last_id < id)) << id;
        last = distance, last_id = id;
        if (id % 4 != 0) continue;
        // Exact contact of two points agrees: they touch within the next double, not within the one before.
        EXPECT_EQ(approaches(scene, question, std::nextafter(distance, infinity), id).size(), 1u) << distance;
        if (distance == 0) continue;
        EXPECT_EQ(approaches(scene, question, std::nextafter(distance, 0), id).size(), 0u) << distance;
      }
    }
  }
}

TEST_P(NearestOfEveryLayout, TreeAgreesWithScan) {
  for (auto kind : all_scene_kinds)
    for (double epoch : {0.0, 1.7e9}) {
      const RandomScene scene =
          shifted(random_scene({.layout = GetParam(), .kind = kind, .count = 60, .seed = 43}), epoch);
      const SearchTarget tree = as_tree(scene);
      Random random(44);
      for (int i = 0; i < 6; ++i) {
        NearestQuestion question = random_question(random, scene, i);
        const std::vector<Row> scanned = answer(question);
        question.objects = tree;
        EXPECT_EQ(answer(question), scanned) << name_of(kind) << " " << i << " " << epoch;
      }
    }
}

INSTANTIATE_TEST_SUITE_P(AxesLawShapeTimes, NearestOfEveryLayout, ::testing::ValuesIn(varied_layouts()));

TEST(Nearest, EqualDistancesComeById) {
  // Eight mirror images of one motion: different intermediate numbers, the same distance.
  const Layout layout{.axes = 2, .law = Law::uniform};
  std::vector<double> rows;
  std::vector<std::int64_t> ids;
  for (int image = 0; image < 8; ++image) {
    double x = 1.1, y = 7.3, vx = 0.3, vy = -0.7;
    if (image & 1) x = -x, vx = -vx;
    if (image & 2) y = -y, vy = -vy;
    if (image & 4) std::swap(x, y), std::swap(vx, vy);
    rows.insert(rows.end(), {x, y, vx, vy});
    ids.push_back(8 - image);
  }
  const NearestQuestion question{
      .objects = {"ships", scene_of(layout, ids, rows), nullptr}, .h = 100, .k = 5, .point = {0.0, 0.0}};
  const std::vector<Row> found = answer(question);
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(std::get<0>(found[i]), static_cast<std::int64_t>(i + 1));
    EXPECT_EQ(std::get<1>(found[i]), std::get<1>(found[0]));
  }
}

TEST(Nearest, ADistanceIsTheNearestDoubleWhereDoubleArithmeticCannotDecide) {
  const Layout layout{.axes = 2, .law = Law::uniform};
  // Passes the point at 1e-30 and 1e20 a second: no digit of the distance is left in double-double.
  const SearchTarget ships{"ships", scene_of(layout, {1}, {-1e20, 1e-30, 1e20, 0}), nullptr};
  const std::vector<Row> rows = answer({.objects = ships, .h = 2, .point = {0.0, 0.0}});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(std::get<1>(rows[0]), 1e-30);
  const SearchTarget still{
      "ships", scene_of({.axes = 2}, {1, 2, 3, 4}, {3e200, 4e200, 3e-200, 4e-200, 0, 0, 1e308, 1.5e308}),
      nullptr};
  const std::vector<Row> far = answer({.objects = still, .k = 4, .point = {0.0, 0.0}});
  ASSERT_EQ(far.size(), 4u);
  EXPECT_EQ(std::get<1>(far[0]), 0);
  EXPECT_DOUBLE_EQ(std::get<1>(far[1]), 5e-200);
  EXPECT_DOUBLE_EQ(std::get<1>(far[2]), 5e200);
  EXPECT_EQ(std::get<1>(far[3]), infinity);
}

std::string error_of(const NearestQuestion& question) {
  NeverInterrupt never;
  try {
    nearest(question, never);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Nearest, SaysWhatIsWrong) {
  const SearchTarget ships{"ships", scene_of({.axes = 2}, {}, {}), nullptr};
  EXPECT_EQ(error_of({.objects = ships, .k = 0, .point = {0, 0}}), "k must be a whole number >= 1, not 0");
  EXPECT_EQ(error_of({.objects = ships, .h = -1, .point = {0, 0}}), "h must be a finite number >= 0, not -1");
  EXPECT_EQ(error_of({.objects = ships, .point = {0}}),
            "ships has 2 axes (x, y): y is missing; give one number for each axis");
  EXPECT_EQ(error_of({.objects = ships, .point = {0, 0, 0}}), "ships has 2 axes (x, y): leave out z");
  EXPECT_EQ(error_of({.objects = ships, .point = {0, infinity}}), "y must be a finite number, not inf");
  EXPECT_EQ(error_of({.objects = ships, .point = {0, 0}, .velocity = {0, 0, 2}}),
            "ships has 2 axes (x, y): leave out qvz");
  EXPECT_EQ(error_of({.objects = ships, .point = {0, 0}}), "");
}

}  // namespace
}  // namespace foresee
