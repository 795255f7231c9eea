// Cores of giants: every pair that the grid reports as touching touches, whatever the numbers. No pair is
// lost, and most pairs of a giant are reported as touching.
#include <algorithm>
#include <cmath>

#include "contact/contact.h"
#include "every_simd.h"
#include "index/candidate_pairs.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "shape/swept_boxes.h"

namespace foresee::testing {
namespace {

struct Side {
  Layout layout;
  std::vector<double> rows;

  Bodies bodies() const {
    return {layout, rows.data(), rows.size() / static_cast<std::size_t>(row_offsets(layout).size)};
  }
};

struct Question {
  Horizon horizon;
  double within;
};

struct Found {
  std::vector<Pair> all, touching;
};

template <int D>
Found candidates_of(const Side& a, const Side* b, const Question& question) {
  const Vec<D> margin = Vec<D>::constant(question.within / 2);
  const MovingBoxes<D> first{a.bodies(), question.horizon, margin};
  MovingBoxes<D> second = first;
  if (b) second.bodies = b->bodies();
  const auto grid = make_gpcd_grid<D>(first, b ? &second : nullptr, never);
  Found found;
  for (std::vector<Pair> batch; grid->next(batch); batch.clear()) {
    found.all.insert(found.all.end(), batch.begin(), batch.end());
    if (grid->touching()) found.touching.insert(found.touching.end(), batch.begin(), batch.end());
  }
  return found;
}

Found candidates_of(const Side& a, const Side* b, const Question& question) {
  if (a.layout.axes == 1) return candidates_of<1>(a, b, question);
  if (a.layout.axes == 2) return candidates_of<2>(a, b, question);
  return candidates_of<3>(a, b, question);
}

std::vector<Pair> those_that_touch(const Side& a, const Side* b, const Question& question,
                                   const std::vector<Pair>& pairs) {
  const auto contact = make_contact(a.bodies(), b ? b->bodies() : a.bodies(),
                                    {.horizon = question.horizon, .within = question.within}, "a", "b");
  std::vector<Pair> hits;
  contact->decide(pairs, hits);
  return hits;
}

std::vector<Pair> all_pairs(const Side& a, const Side* b) {
  std::vector<Pair> pairs;
  const auto count_a = static_cast<std::uint32_t>(a.bodies().count),
             count_b = b ? static_cast<std::uint32_t>(b->bodies().count) : count_a;
  for (std::uint32_t i = 0; i < count_a; ++i)
    for (std::uint32_t j = b ? 0 : i + 1; j < count_b; ++j) pairs.push_back({i, j});
  return pairs;
}

/// Runs with every instruction set; returns the number of pairs reported as touching.
std::size_t expect_touching(const Side& a, const Side* b, const Question& question) {
  SCOPED_TRACE(::testing::Message() << name_of(a.layout) << " with " << name_of(b ? b->layout : a.layout)
                                    << ", now " << question.horizon.now << ", h " << question.horizon.h);
  Found first;
  for_every_simd([&](Simd simd) {
    const Found found = candidates_of(a, b, question);
    if (simd == Simd::baseline) first = found;
    EXPECT_TRUE(found.all == first.all && found.touching == first.touching);
  });
  const Question now{{question.horizon.now, 0}, question.within};
  EXPECT_EQ(those_that_touch(a, b, now, first.touching).size(), first.touching.size());
  expect_all_once(b ? in_order(first.all) : within_order(first.all),
                  those_that_touch(a, b, question, all_pairs(a, b)), first.all.size());
  return first.touching.size();
}

/// A scene in which every fortieth object is a giant, twice as wide as the space.
Side with_giants(const Layout& layout, std::size_t count, std::uint64_t seed) {
  const RandomScene scene = random_scene({layout, SceneKind::uniform, count, seed});
  Side side{layout, scene.rows};
  const Offsets at = row_offsets(layout);
  for (std::size_t i = 7; i < count; i += 40) {
    double* row = side.rows.data() + i * static_cast<std::size_t>(at.size);
    for (int axis = 0; axis < layout.axes && at.half != Offsets::absent; ++axis)
      row[at.half + axis] = scene.side;
    for (int place : {at.r, at.hz})
      if (place != Offsets::absent) row[place] = scene.side;
  }
  return side;
}

TEST(GpcdGridCores, HoldOnlyWhatTouchesInEveryLayout) {
  std::uint64_t seed = 0;
  for (const Layout& layout : varied_layouts()) {
    const Side side = with_giants(layout, 200, ++seed);
    expect_touching(side, nullptr, {{0.5, 0.25}, 0.25});
    expect_touching(side, nullptr, {{0.5, 0}, 0.25});
    const std::size_t sure = expect_touching(side, nullptr, {{1, 0.25}, 0.25});  // all objects have started
    if (layout.shape != Shape::point && !layout.starts_as_point) {
      EXPECT_GT(sure, 40u) << name_of(layout);
    }
  }
}

/// Giants that exist at the start meet objects that may not, moving or at rest.
TEST(GpcdGridCores, HoldOnlyWhatExistsAtTheStartOfTheHorizon) {
  std::uint64_t seed = 0;
  std::size_t sure = 0;
  for (Shape giant : {Shape::box, Shape::ball})
    for (int axes = 1; axes <= 3; ++axes)
      for (const Layout& other : varied_layouts()) {
        if (other.axes != axes || (giant == Shape::ball && other.shape == Shape::cylinder)) continue;
        for (Law law : {Law::rest, Law::accelerated}) {
          const Side a = with_giants({axes, law, giant, false, false}, 120, ++seed);
          const Side b = with_giants(other, 80, ++seed);
          sure += expect_touching(a, &b, {{0.5, 0.25}, 0});
          sure += expect_touching(b, &a, {{0.5, 0.25}, 0});
        }
      }
  EXPECT_GT(sure, sanitized ? 250u : 1000u);
}

/// Also if a coordinate has few digits left, if all numbers are tiny, or if none fits a float.
TEST(GpcdGridCores, HoldOnlyWhatTouchesAtExtremeNumbers) {
  constexpr std::size_t count = sanitized ? 60 : 100;
  std::size_t sure = 0;
  for (int axes = 1; axes <= 3; ++axes)
    for (double scale : {1.0, 0x1p-1060, 0x1p-400, 0x1p400, 0x1p1010})
      for (double offset : {0.0, 1e3, -1e15}) {
        Side side = with_giants({axes, Law::accelerated, Shape::box, true, false}, count, 5);
        const Offsets at = row_offsets(side.layout);
        for (std::size_t i = 0; i < side.bodies().count; ++i) {
          double* row = side.rows.data() + i * static_cast<std::size_t>(at.size);
          row[at.t] = -0.5 * row[at.t] * row[at.t];
          for (int place = at.x; place < at.size; ++place) row[place] *= scale;
          for (int axis = 0; axis < axes; ++axis) row[at.x + axis] += offset * scale;
        }
        sure += expect_touching(side, nullptr, {{0, 0.25}, 0});
        expect_touching(side, nullptr, {{1e6, 1e-3}, 0});
        expect_touching(side, nullptr, {{0, 1e12}, 0});
      }
  EXPECT_GT(sure, 1000u);
}

/// Points on the boundary of a giant, or just beside it.
TEST(GpcdGridCores, LeaveTheBoundaryToContact) {
  Random random(9);
  for (double offset : {0.0, 1e6, 1e12}) {
    const Layout layout{.axes = 2, .law = Law::uniform, .shape = Shape::box};
    const double side = 200;
    std::vector<double> rows{offset, offset, 1, 0, side, side};  // x, y, vx, vy, hx, hy
    for (int i = 0; i < 1000; ++i) {
      const double past = std::ldexp(random.in(-16, 2), -static_cast<int>(random.below(40)));
      const double along = random.in(-side, side), x = side + past;
      const double place[] = {i % 2 ? x : along, i % 2 ? along : -x};
      rows.insert(rows.end(),
                  {offset + place[0], offset + place[1], random.in(-1, 1), random.in(-1, 1), 0, 0});
    }
    EXPECT_GT(expect_touching({layout, rows}, nullptr, {{0, 3}, 0}), 0u) << offset;
  }
}

TEST(CoreBox, IsWithinTheShape) {
  Random random(3);
  for (Shape shape : {Shape::box, Shape::ball, Shape::cylinder}) {
    const Layout layout{.axes = 3, .law = Law::accelerated, .shape = shape, .has_t = true};
    const RandomScene scene = random_scene({layout, SceneKind::uniform, 200, 4});
    for (double now : {0.0, 1.0, 1e5}) {
      std::size_t cores = 0;
      for (std::size_t i = 0; i < scene.size(); ++i) {
        const Box<3> core = core_box<3>(scene.bodies(), i, now);
        if (core.is_empty()) continue;
        ++cores;
        Side corners{{.axes = 3}, {}};
        for (int corner = 0; corner < 8; ++corner)
          for (int axis = 0; axis < 3; ++axis)
            corners.rows.push_back(corner >> axis & 1 ? core.upper[axis] : core.lower[axis]);
        const auto contact = make_contact(scene.bodies(), corners.bodies(), {.horizon = {now, 0}}, "a", "b");
        std::vector<Pair> pairs, hits;
        for (std::uint32_t corner = 0; corner < 8; ++corner)
          pairs.push_back({static_cast<std::uint32_t>(i), corner});
        contact->decide(pairs, hits);
        EXPECT_EQ(hits.size(), 8u) << name_of(layout) << ", now " << now;
      }
      EXPECT_EQ(cores == scene.size(), now >= 1) << "some start after 0";
    }
  }
}

}  // namespace
}  // namespace foresee::testing
