// The grid over moving objects: no instruction set loses a pair that touches, whatever the numbers. Pairs
// that are never near at the same time are not candidates.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/contact.h"
#include "every_simd.h"
#include "index/candidate_pairs.h"
#include "index/gpcd_grid/gpcd_grid.h"

namespace foresee::testing {
namespace {

/// A scene of any layout, with numbers that a test may change.
struct Moving {
  Layout layout;
  std::vector<double> rows;
  Horizon horizon;
  double within = 0;

  std::size_t size() const { return rows.size() / static_cast<std::size_t>(row_offsets(layout).size); }
  Bodies bodies() const { return {layout, rows.data(), size()}; }
};

Moving moving(const RandomScene& scene, double h) {
  return {scene.layout, scene.rows, {scene.now, h}, scene.within};
}

template <int D>
std::vector<Pair> candidates_of(const Moving& a, const Moving* b) {
  const Vec<D> margin = Vec<D>::constant(a.within / 2);
  const MovingBoxes<D> first{a.bodies(), a.horizon, margin};
  if (!b) return drain(*make_gpcd_grid<D>(first, nullptr, never));
  const MovingBoxes<D> second{b->bodies(), b->horizon, margin};
  return drain(*make_gpcd_grid<D>(first, &second, never));
}

std::vector<Pair> candidates_of(const Moving& a, const Moving* b = nullptr) {
  if (a.layout.axes == 1) return candidates_of<1>(a, b);
  if (a.layout.axes == 2) return candidates_of<2>(a, b);
  return candidates_of<3>(a, b);
}

std::vector<Pair> touching(const Moving& a, const Moving* b = nullptr) {
  const auto contact = make_contact(a.bodies(), b ? b->bodies() : a.bodies(),
                                    {.horizon = a.horizon, .within = a.within}, "a", "b");
  std::vector<Pair> pairs, hits;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = b ? 0 : i + 1; j < (b ? b->size() : a.size()); ++j) pairs.push_back({i, j});
  contact->decide(pairs, hits);
  return hits;
}

/// With every instruction set: all pairs that touch, none twice, and the same candidates in the same order.
void expect_all_touching(const Moving& a, const Moving* b = nullptr) {
  SCOPED_TRACE(::testing::Message() << name_of(a.layout) << ", h " << a.horizon.h);
  std::vector<Pair> first;
  for_every_simd([&](Simd simd) {
    const std::vector<Pair> found = candidates_of(a, b);
    if (simd == Simd::baseline) first = found;
    EXPECT_TRUE(found == first) << "other candidates";
  });
  expect_all_once(b ? in_order(first) : within_order(first), touching(a, b), first.size());
}

class GpcdGridTime : public ::testing::TestWithParam<SceneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, GpcdGridTime, ::testing::ValuesIn(all_scene_kinds), [](const auto& info) {
  std::string name = name_of(info.param);
  std::erase(name, ' ');
  return name;
});

TEST_P(GpcdGridTime, LosesNothingForEveryLayout) {
  std::uint64_t seed = 1;
  for (const Layout& layout : varied_layouts()) {
    const Moving a = moving(random_scene({layout, GetParam(), 50, ++seed}), 3);
    const Moving b = moving(random_scene({layout, GetParam(), 30, ++seed}), 3);
    expect_all_touching(a);
    expect_all_touching(a, &b);
  }
}

TEST_P(GpcdGridTime, LosesNothingForHorizonsOfAnyLength) {
  for (double h : {0.0, 5e-324, 1e-300, 1e-9, 50.0, 1e9, 1e154, 1e308})
    for (int axes = 1; axes <= 3; ++axes)
      for (Law law : {Law::uniform, Law::accelerated})
        expect_all_touching(
            moving(random_scene({{axes, law, Shape::box, true, true}, GetParam(), 40, 5}), h));
}

/// Tables hold finite numbers only.
double stored(double x) {
  constexpr double max = std::numeric_limits<double>::max();
  return std::isnan(x) ? 0 : std::clamp(x, -max, max);
}

/// Multiplies lengths by `scale` and then adds `offset`; multiplies times by `slow` and adds `since`.
Moving changed(Moving scene, double scale, double offset, double slow, double since) {
  const Offsets at = row_offsets(scene.layout);
  for (std::size_t i = 0; i < scene.size(); ++i) {
    double* row = scene.rows.data() + i * static_cast<std::size_t>(at.size);
    for (int axis = 0; axis < scene.layout.axes; ++axis) {
      row[at.x + axis] = stored(row[at.x + axis] * scale + offset);
      row[at.v + axis] = stored(row[at.v + axis] * (scale / slow));
      row[at.a + axis] = stored(row[at.a + axis] * (scale / slow / slow));
      row[at.half + axis] = stored(row[at.half + axis] * scale);
    }
    row[at.t] = row[at.t] * slow + since;
    row[at.until] = row[at.until] * slow + since;
  }
  scene.horizon = {scene.horizon.now * slow + since, scene.horizon.h * slow};
  return scene;
}

TEST_P(GpcdGridTime, LosesNothingAtExtremeNumbers) {
  for (double scale : {1.0, 0x1p-1060, 0x1p-1000, 0x1p-400, 0x1p1000, 0x1p1015})
    for (double slow : {1.0, 0x1p-500, 0x1p-1000, 0x1p500})
      for (int axes = 1; axes <= 3; ++axes) {
        const RandomScene scene =
            random_scene({{axes, Law::accelerated, Shape::box, true, true}, GetParam(), 24, 8});
        expect_all_touching(changed(moving(scene, 3), scale, 0, slow, 0));
        if (scale == 1) expect_all_touching(changed(moving(scene, 3), 1, 1e15, slow, 1.7e9));
      }
}

/// Candidates per object in a uniform scene with about one true pair per object.
double candidates_an_object(double offset, double since, bool lives) {
  const Layout layout{2, Law::accelerated, Shape::box, true, true};
  Moving scene = moving(random_scene({layout, SceneKind::uniform, 4000, 3}), 3);
  const Offsets at = row_offsets(layout);
  for (std::size_t i = 0; !lives && i < scene.size(); ++i) {
    double* row = scene.rows.data() + i * static_cast<std::size_t>(at.size);
    row[at.t] = 0, row[at.until] = std::numeric_limits<double>::infinity();
  }
  const Moving moved = changed(scene, 1, offset, 1, since);
  const std::vector<Pair> found = candidates_of(moved);
  const auto contact = make_contact(moved.bodies(), moved.bodies(), {.horizon = moved.horizon}, "a", "a");
  std::vector<Pair> hits;
  contact->decide(found, hits);
  EXPECT_LE(static_cast<double>(found.size()), 1.6 * static_cast<double>(hits.size()));
  return static_cast<double>(found.size()) / static_cast<double>(scene.size());
}

/// Every seventh object crosses the scene several times over, every eleventh is tall or long.
Moving racers(const Layout& layout, std::size_t count, std::uint64_t seed) {
  Moving scene = moving(random_scene({layout, SceneKind::uniform, count, seed}), 3);
  const Offsets at = row_offsets(layout);
  for (std::size_t i = 0; i < count; ++i) {
    double* row = scene.rows.data() + i * static_cast<std::size_t>(at.size);
    for (int axis = 0; axis < layout.axes; ++axis) {
      if (i % 7 == 0) row[at.v + axis] *= 60;
      if (i % 11 == static_cast<std::size_t>(axis)) row[at.half + axis] *= 30;
    }
  }
  return scene;
}

TEST(GpcdGridTimeTest, LosesNothingThatRacersMeet) {
  constexpr int repetitions = sanitized ? 2 : 6;
  std::uint64_t seed = 600;
  std::size_t met = 0;
  for (const Law law : {Law::uniform, Law::accelerated})
    for (int axes = 2; axes <= 3; ++axes)
      for (int repetition = 0; repetition < repetitions; ++repetition) {
        const Layout layout{.axes = axes, .law = law, .shape = Shape::box};
        const Moving a = racers(layout, 500, ++seed), b = racers(layout, 300, ++seed);
        expect_all_touching(a);
        expect_all_touching(a, &b);
        for (const Pair& pair : touching(a)) met += (pair.a % 7 == 0) != (pair.b % 7 == 0);
      }
  EXPECT_GT(met, sanitized ? 600u : 2000u);
}

TEST(GpcdGridTimeTest, LetsFewPassThatDoNotTouch) {
  for (bool lives : {false, true}) {
    const double here = candidates_an_object(0, 0, lives);
    EXPECT_GT(here, 0.2);
    EXPECT_NEAR(candidates_an_object(1e6, 0, lives), here, 0.01) << "coordinates of a map";
    EXPECT_NEAR(candidates_an_object(-1e12, 0, lives), here, 0.05);
    EXPECT_NEAR(candidates_an_object(0, 1.7e9, lives), here, 0.01) << "Unix time";
  }
}

TEST(GpcdGridTimeTest, PassesNothingWhereAllMoveAlike) {
  std::vector<double> rows;  // x, y, vx, vy, half extents: a convoy, each far behind the other
  for (int i = 0; i < 500; ++i) rows.insert(rows.end(), {i * 10.0, i * 0.1, 50, 7, 1, 1});
  const Moving convoy{{2, Law::uniform, Shape::box, false, false}, rows, {0, 100}};
  EXPECT_EQ(candidates_of(convoy).size(), 0u);
}

TEST(GpcdGridTimeTest, PassesNothingThatIsNeverThereTogether) {
  std::vector<double> rows;  // t, x, v, half extent, until: one place, one after another
  for (int i = 0; i < 500; ++i) rows.insert(rows.end(), {i * 1.0, 0, 0.1, 1, i + 0.5});
  const Moving visitors{{1, Law::uniform, Shape::box, true, true}, rows, {0, 600}};
  EXPECT_EQ(candidates_of(visitors).size(), 0u);
}

}  // namespace
}  // namespace foresee::testing
