// Window queries: the same rows as a join with a box, from scenes and from trees, with any bound left out.
#include "query/window/window.h"

#include <gtest/gtest.h>

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

using Answer = std::map<std::int64_t, std::array<double, 4>>;

Answer answer(const WindowQuestion& question) {
  NeverInterrupt never;
  Window window(question, never);
  Answer all;
  for (auto rows = window.next(); !rows.empty(); rows = window.next())
    for (const WindowRow& row : rows) {
      const ContactTimes& c = row.contact;
      EXPECT_TRUE(all.emplace(row.id, std::array{c.t, c.t_end, c.dt, c.dt_end}).second) << row.id;
    }
  return all;
}

/// A window whose centre and half extents are whole numbers, and which moves.
WindowFaces random_faces(Random& random, const RandomScene& scene, bool still) {
  WindowFaces faces;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.layout.axes); ++axis) {
    const double centre = std::floor(random.in(0, scene.side)),
                 half = std::floor(random.in(0, scene.side / 4));
    faces.lower[axis] = centre - half, faces.upper[axis] = centre + half;
    if (!still) faces.velocity[axis] = random.in(-3, 3);
  }
  return faces;
}

/// The same window as a box in a table of its own, joined with the objects.
Answer joined(const RandomScene& scene, const WindowFaces& faces, double now, double h) {
  const Layout layout{.axes = scene.layout.axes, .law = Law::uniform, .shape = Shape::box, .has_t = true};
  const Offsets at = row_offsets(layout);
  std::vector<double> row(static_cast<std::size_t>(at.size));
  row[static_cast<std::size_t>(at.t)] = now;
  for (int axis = 0; axis < layout.axes; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    row[static_cast<std::size_t>(at.x) + j] = (faces.lower[j] + faces.upper[j]) / 2;
    row[static_cast<std::size_t>(at.v) + j] = faces.velocity[j];
    row[static_cast<std::size_t>(at.half) + j] = (faces.upper[j] - faces.lower[j]) / 2;
  }
  Answer all;
  for (const JoinRow& hit : rows_of({.a = scene_of(layout, {1}, row, "window"),
                            .b = scene_of(scene),
                            .now = now,
                            .h = h,
                            .method = JoinMethod::scan}))
    all[hit.b] = {hit.contact.t, hit.contact.t_end, hit.contact.dt, hit.contact.dt_end};
  return all;
}

class WindowOfEveryLayout : public ::testing::TestWithParam<Layout> {};

TEST_P(WindowOfEveryLayout, AgreesWithABoxThatJoins) {
  std::size_t rows = 0;
  for (auto kind : all_scene_kinds) {
    const RandomScene scene = random_scene({.layout = GetParam(), .kind = kind, .count = 30, .seed = 31});
    Random random(32);
    for (int i = 0; i < 4; ++i) {
      const double now = scene.now + (i == 3 ? 2.5 : 0), h = i == 2 ? 0 : scene.h;
      const WindowFaces faces = random_faces(random, scene, i % 2 == 0);
      const Answer wanted = joined(scene, faces, now, h);
      EXPECT_EQ(answer({.objects = as_scene(scene), .now = now, .h = h, .faces = faces}), wanted)
          << name_of(kind) << " " << i;
      rows += wanted.size();
    }
  }
  EXPECT_GT(rows, 0u);
}

TEST_P(WindowOfEveryLayout, TreeAgreesWithScan) {
  for (auto kind : all_scene_kinds)
    for (double epoch : {0.0, 1.7e9}) {
      const RandomScene scene =
          shifted(random_scene({.layout = GetParam(), .kind = kind, .count = 60, .seed = 33}), epoch);
      const SearchTarget tree = as_tree(scene), all = as_scene(scene);
      Random random(34);
      for (int i = 0; i < 6; ++i) {
        WindowFaces faces = random_faces(random, scene, i % 2 == 0);
        if (i == 4) faces.lower[0] = -infinity;
        if (i == 5) faces = {};
        const WindowQuestion question{
            .objects = all, .now = scene.now + (i == 1 ? -3 : 0), .h = i == 2 ? 0 : 4.0, .faces = faces};
        WindowQuestion of_tree = question;
        of_tree.objects = tree;
        EXPECT_EQ(answer(of_tree), answer(question)) << name_of(kind) << " " << i << " " << epoch;
      }
    }
}

/// For every subset of the sides: leaving them out is the same as placing them very far away.
TEST_P(WindowOfEveryLayout, AMissingSideIsOneThatIsNeverReached) {
  const RandomScene scene = random_scene({.layout = GetParam(), .count = 12, .seed = 35});
  Random random(36);
  const auto axes = static_cast<std::size_t>(scene.layout.axes);
  for (unsigned missing = 0; missing < 1u << (2 * axes); ++missing) {
    WindowFaces open = random_faces(random, scene, missing % 2 == 0), far = open;
    for (std::size_t side = 0; side < 2 * axes; ++side) {
      if (!(missing >> side & 1)) continue;
      (side % 2 ? open.upper : open.lower)[side / 2] = side % 2 ? infinity : -infinity;
      (side % 2 ? far.upper : far.lower)[side / 2] = side % 2 ? 0x1p60 : -0x1p60;
    }
    EXPECT_EQ(answer({.objects = as_scene(scene), .now = 0.5, .h = 3, .faces = open}),
              answer({.objects = as_scene(scene), .now = 0.5, .h = 3, .faces = far}))
        << missing;
  }
}

INSTANTIATE_TEST_SUITE_P(AxesLawShapeTimes, WindowOfEveryLayout, ::testing::ValuesIn(varied_layouts()));

const Layout disc{.axes = 2, .law = Law::uniform, .shape = Shape::ball};

/// One disc of radius 5 at (x, y) moving with (vx, vy).
SearchTarget one_disc(double x, double y, double vx, double vy) {
  return {"ships", scene_of(disc, {7}, {x, y, vx, vy, 5}), nullptr};
}

WindowFaces faces_of(double x0, double x1, double y0 = -infinity, double y1 = infinity) {
  return {.lower = {x0, y0, -infinity}, .upper = {x1, y1, infinity}};
}

TEST(Window, MeasuresTheDistanceOfADiscFromTheCorner) {
  const WindowFaces quarter = faces_of(-infinity, 0, -infinity, 0);
  // From (3, 104) down: the corner is 3 to the left, so it touches 4 above it.
  EXPECT_EQ(answer({.objects = one_disc(3, 104, 0, -1), .h = 200, .faces = quarter}),
            (Answer{{7, {100, 200, 100, 200}}}));
  EXPECT_EQ(answer({.objects = one_disc(-3, 104, 0, -1), .h = 200, .faces = quarter}),
            (Answer{{7, {99, 200, 99, 200}}}));
}

TEST(Window, TouchingCountsAndOneStepBesideDoesNot) {
  const WindowFaces right = faces_of(0, infinity, -infinity, infinity);
  EXPECT_EQ(answer({.objects = one_disc(-5, 0, 0, 1), .h = 1, .faces = right}).size(), 1u);
  EXPECT_EQ(answer({.objects = one_disc(std::nextafter(-5.0, -6), 0, 0, 1), .h = 1, .faces = right}).size(),
            0u);
}

TEST(Window, NeedsNoCentreThatADoubleHolds) {
  // 0.1 and 1e17 have no double between them that is their middle, and their difference is not a double.
  const WindowFaces wide = faces_of(0.1, 1e17, -infinity, infinity);
  EXPECT_EQ(answer({.objects = one_disc(-4.9, 0, 0, 0), .h = 1, .faces = wide}).size(),
            0u);  // slightly less than 0.1
  const SearchTarget points{
      "points",
      scene_of({.axes = 1}, {1, 2, 3, 4}, {0.1, std::nextafter(0.1, 0), 1e17, std::nextafter(1e17, 2e17)}),
      nullptr};
  const Answer rows = answer({.objects = points, .h = 1, .faces = faces_of(0.1, 1e17)});
  EXPECT_TRUE(rows.contains(1) && rows.contains(3));
  EXPECT_FALSE(rows.contains(2) || rows.contains(4));
  const WindowFaces everything = faces_of(-1.7e308, 1.7e308);
  EXPECT_EQ(answer({.objects = points, .h = 1, .faces = everything}).size(), 4u);
}

std::string error_of(WindowQuestion question) {
  NeverInterrupt never;
  try {
    Window window(std::move(question), never);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Window, SaysWhatIsWrong) {
  const SearchTarget ships = one_disc(0, 0, 0, 0);
  EXPECT_EQ(error_of({.objects = ships, .h = -1}), "h must be a finite number >= 0, not -1");
  EXPECT_EQ(error_of({.objects = ships, .now = infinity}), "now must be a finite number, not inf");
  EXPECT_EQ(error_of({.objects = ships, .faces = {.lower = {5, 0}, .upper = {3, 0}}}),
            "x0 must not be greater than x1: x0 is 5, x1 is 3");
  EXPECT_EQ(error_of({.objects = ships, .faces = {.lower = {-infinity, infinity}}}),
            "y0 must be a finite number, or left out for no bound, not inf");
  EXPECT_EQ(error_of({.objects = ships, .faces = {.lower = {-infinity, -infinity, 4}}}),
            "ships has 2 axes (x, y): leave out z0");
  EXPECT_EQ(error_of({.objects = ships, .faces = {.velocity = {0, 0, 1}}}),
            "ships has 2 axes (x, y): leave out wvz");
  EXPECT_EQ(error_of({.objects = ships, .faces = {.velocity = {infinity}}}),
            "wvx must be a finite number, not inf");
}

}  // namespace
}  // namespace foresee
