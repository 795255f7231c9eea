// Tiles: the tiles of any tiling give the whole join together, every row once, with the same doubles.
// FORESEE_LONG=1: more than 10,000 tilings.

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "base/axes.h"
#include "never_interrupt.h"
#include "query/join/join_scenes.h"
#include "query/join/tilings.h"
#include "query/join_cases.h"
#include "query/memory_table.h"

namespace foresee {
namespace {

using testing::discs;
using testing::flat_boxes;
using testing::FlatBox;
using testing::numbers_of;
using testing::Random;
using testing::random_scene;
using testing::random_tiling;
using testing::RandomScene;
using testing::rows_in_order;
using testing::rows_of;
using testing::scene_of;
using testing::SceneKind;

constexpr JoinMethod methods[] = {JoinMethod::automatic, JoinMethod::grid, JoinMethod::scan,
                                  JoinMethod::gpcd};

std::vector<FlatBox> boxes_of(const Scene& scene, const JoinQuestion& question) {
  return with_axes(scene.layout.axes, [&]<int D>(Axes<D>) {
    return flat_boxes<D>(scene.bodies(), {question.now, question.h}, question.within);
  });
}

/// The objects sent to a tile: all that it needs, by a rule independent of Tile, and some others.
std::shared_ptr<const Scene> shipped(const Scene& scene, const JoinQuestion& question, const Tile& tile,
                                     Random& random) {
  const std::vector<FlatBox> boxes = boxes_of(scene, question);
  const auto size = static_cast<std::size_t>(row_offsets(scene.layout).size);
  std::vector<std::int64_t> ids;
  std::vector<double> rows;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const FlatBox& box = boxes[i];
    const bool apart = !(box.lower[0] < tile.x1) || box.upper[0] < tile.x0 ||
                       (scene.layout.axes > 1 && (!(box.lower[1] < tile.y1) || box.upper[1] < tile.y0));
    if (apart && random.below(4)) continue;
    ids.push_back(scene.ids[i]);
    rows.insert(rows.end(), scene.rows.begin() + static_cast<std::ptrdiff_t>(i * size),
                scene.rows.begin() + static_cast<std::ptrdiff_t>((i + 1) * size));
  }
  return scene_of(scene.layout, ids, rows);
}

/// The rows of all tiles; each joins the whole scenes, or only the objects sent to it.
std::vector<double> rows_of_tiles(const JoinQuestion& question, const std::vector<Tile>& tiles,
                                  bool by_shipping, Random& random) {
  std::vector<JoinRow> all;
  for (const Tile& tile : tiles) {
    JoinQuestion part = question;
    part.tile = tile;
    if (by_shipping) part.a = shipped(*question.a, question, tile, random);
    if (by_shipping && question.b)
      part.b = question.b == question.a ? part.a : shipped(*question.b, question, tile, random);
    for (const JoinRow& row : rows_of(part)) all.push_back(row);
  }
  std::sort(all.begin(), all.end(),
            [](const JoinRow& l, const JoinRow& r) { return std::pair(l.a, l.b) < std::pair(r.a, r.b); });
  return numbers_of(all);
}

void expect_tilings_agree(const JoinQuestion& question, int tilings, Random& random) {
  const auto whole = numbers_of(rows_of(question));
  std::vector<FlatBox> boxes = boxes_of(*question.a, question);
  if (question.b)
    for (const FlatBox& box : boxes_of(*question.b, question)) boxes.push_back(box);
  for (int i = 0; i < tilings; ++i) {
    const auto tiles = random_tiling(boxes, question.a->layout.axes, 1 + random.below(9), random);
    EXPECT_EQ(rows_of_tiles(question, tiles, i % 2 == 1, random), whole);
  }
}

TEST(Tiles, TogetherAreTheWholeJoinOfEveryLayout) {
  const bool is_long = std::getenv("FORESEE_LONG") != nullptr;
  Random random(5);
  std::size_t number = 0, rows = 0;
  for (const Layout& layout : testing::varied_layouts())
    for (const SceneKind kind : testing::all_scene_kinds) {
      if (!is_long && ++number % 3 != 0) continue;
      const auto scene = random_scene({.layout = layout, .kind = kind, .count = 50, .seed = 40 + number});
      JoinQuestion question = testing::question_about(scene);
      question.method = methods[random.below(4)];
      if (random.below(4) == 0) question.h = 0;
      if (random.below(8) == 0) question.within = 5e-324;
      const std::uint64_t other = random.below(3);
      if (other == 1) question.b = question.a;
      if (other == 2)
        question.b = scene_of(random_scene({.layout = layout, .kind = kind, .count = 30, .seed = 3}), "b");
      expect_tilings_agree(question, is_long ? 16 : 2, random);
      if (::testing::Test::HasFailure()) FAIL() << testing::name_of(layout) << ", " << testing::name_of(kind);
      rows += rows_of(question).size();
    }
  EXPECT_GT(rows, 3000u);
}

TEST(Tiles, TogetherAreTheWholeJoinWithLimitsAlongZ) {
  Random random(6);
  for (const Shape shape : {Shape::point, Shape::cylinder}) {
    auto scene = random_scene({.layout = {3, Law::accelerated, shape, true, true}, .count = 300, .seed = 8});
    JoinQuestion question = testing::question_about(scene);
    for (const double within_z : {0.0, 0.5, 40.0}) {
      question.within_z = within_z, question.within = 1.5;
      expect_tilings_agree(question, 4, random);
    }
    EXPECT_GT(rows_of(question).size(), 100u);
  }
}

TEST(Tiles, OwnWhatNoDoubleBounds) {
  Random random(7);
  // Positions, speeds and radii about as large as doubles are, and some as small.
  std::vector<std::int64_t> ids;
  std::vector<double> rows;
  const double sizes[] = {1e300, 1e308, 1, 1e-300, 0};
  for (int i = 0; i < 60; ++i) {
    ids.push_back(i);
    const auto drawn = [&] { return random.in(-1, 1) * sizes[random.below(5)]; };
    for (int k = 0; k < 4; ++k) rows.push_back(drawn());
    rows.push_back(std::abs(drawn()));
  }
  JoinQuestion question{.a = scene_of(discs, ids, rows), .now = 0, .h = 1e10};
  EXPECT_GT(rows_of(question).size(), 500u);
  expect_tilings_agree(question, 12, random);
  question.h = 0, question.within = 1e305;
  expect_tilings_agree(question, 10, random);
}

TEST(Tiles, CutWhereParabolasTurn) {
  // x = k + (s - 1)^2 - 1 turns at k - 1, a low corner; neighbours touch.
  std::vector<std::int64_t> ids;
  std::vector<double> rows;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) {
      ids.push_back(10 * x + y);
      rows.insert(rows.end(), {1.0 * x, 1.0 * y, -2, 0, 2, 0, 0.5});
    }
  const Layout layout{.axes = 2, .law = Law::accelerated, .shape = Shape::ball};
  JoinQuestion question{.a = scene_of(layout, ids, rows), .now = 0, .h = 3};
  EXPECT_EQ(rows_of(question).size(), 60u);
  Random random(8);
  expect_tilings_agree(question, 40, random);
  question.b = question.a;
  for (double edge = 0; edge < 6; ++edge)
    for (const double x : {edge - 1, edge - 1.5, edge + 0.5}) {
      Tile left, right;
      left.x1 = right.x0 = x;
      EXPECT_EQ(rows_of_tiles(question, {left, right}, false, random), numbers_of(rows_of(question)));
    }
}

TEST(Tiles, OfManyObjectsAgreeWithHelpersAndInOrder) {
  const auto scene = random_scene({.layout = discs, .kind = SceneKind::one_giant, .count = 20000, .seed = 2});
  JoinQuestion question = testing::question_about(scene);
  const auto whole = numbers_of(rows_of(question));
  const double middle = scene.side / 2;
  Tile tiles[4];
  tiles[0].x1 = tiles[1].x1 = tiles[2].x0 = tiles[3].x0 = middle;
  tiles[0].y1 = tiles[2].y1 = tiles[1].y0 = tiles[3].y0 = middle + 1;
  question.order = JoinOrder::by_t_and_ids;
  std::vector<JoinRow> all;
  for (const Tile& tile : tiles) {
    question.tile = tile, question.helpers = 0;
    const auto alone = rows_in_order(question);
    question.helpers = 2;
    EXPECT_EQ(numbers_of(rows_in_order(question)), numbers_of(alone));
    for (std::size_t i = 1; i < alone.size(); ++i) EXPECT_LE(alone[i - 1].contact.t, alone[i].contact.t);
    all.insert(all.end(), alone.begin(), alone.end());
  }
  std::sort(all.begin(), all.end(),
            [](const JoinRow& l, const JoinRow& r) { return std::pair(l.a, l.b) < std::pair(r.a, r.b); });
  EXPECT_EQ(numbers_of(all), whole);
}

TEST(Tiles, LeaveNoTraceWhereTheyOwnAll) {
  const auto scene = random_scene({.layout = discs, .count = 500, .seed = 2});
  JoinQuestion question = testing::question_about(scene);
  question.tile = Tile{-1e300, 1e300, -1e300, 1e300};
  const JoinQuestion in = in_tile(question, testing::never);
  EXPECT_EQ(in.own, nullptr);
  EXPECT_EQ(in.a, question.a);
  question.tile->x0 = scene.side / 2;
  const JoinQuestion half = in_tile(question, testing::never);
  EXPECT_NE(half.own, nullptr);
  EXPECT_LT(half.a->size(), 400u);
}

/// A thousand ships in a row, ten apart.
std::shared_ptr<MemoryTable> row_of_ships() {
  auto ships =
      std::make_shared<MemoryTable>("ships", Layout{.axes = 2, .law = Law::uniform, .shape = Shape::ball});
  for (int i = 0; i < 1000; ++i) ships->put(i, std::vector<double>{10.0 * i, 0, 0, 0, 1});
  return ships;
}

TEST(LoadedScenes, HoldWhatATileNeedsAndElseAllObjects) {
  NeverInterrupt never;
  const JoinedTables within_one{row_of_ships()}, with_itself{within_one.a, within_one.a};
  JoinQuestion question;
  question.h = 1, question.within = 9, question.tile = Tile{.x0 = 95, .x1 = 205};
  load_scenes(within_one, question, never);
  EXPECT_EQ(question.b, nullptr);
  EXPECT_LT(question.a->size(), 200u);
  EXPECT_EQ(rows_of(question).size(), 11u);  // the pairs with ship 11 to ship 21 as the second one
  question.tile.reset();
  load_scenes(with_itself, question, never);
  EXPECT_EQ(question.a, question.b);
  EXPECT_EQ(question.a->size(), 1000u);
  question.tile = Tile{}, question.h = -1;
  EXPECT_THROW(load_scenes(within_one, question, never), Error);
}

TEST(LoadedScenes, HoldAnObjectAndThoseNearIt) {
  NeverInterrupt never;
  const JoinedTables within_one{row_of_ships()}, with_itself{within_one.a, within_one.a};
  JoinQuestion question;
  question.h = 1, question.within = 9, question.only_b = 7;
  load_scenes(within_one, question, never);  // pairs once, the smaller id first
  EXPECT_EQ(question.a->ids, std::vector<std::int64_t>{6});
  EXPECT_EQ(question.b->ids, std::vector<std::int64_t>{7});
  EXPECT_EQ(question.method, JoinMethod::scan);
  question.method = JoinMethod::tree, question.only_a = 7;
  load_scenes(with_itself, question, never);
  EXPECT_EQ(question.a->ids, std::vector<std::int64_t>{7});
  EXPECT_EQ(std::set(question.b->ids.begin(), question.b->ids.end()), (std::set<std::int64_t>{6, 8}));
}

}  // namespace
}  // namespace foresee
