// The outlines of many rows: looked up once, turned when asked for, by several threads too.
#include "shape/outline/turned_outlines.h"

#include <gtest/gtest.h>

#include <thread>

#include "shape/outline/turn.h"
#include "shape/outline/wkt_reader.h"
#include "shape/swept_boxes.h"

namespace foresee::shape {
namespace {

struct Shelf final : FormSource {
  std::shared_ptr<const Form> form(std::int64_t number) override {
    ++asked;
    if (number > 2) throw Error("no such outline");
    return std::make_shared<const CutOutline>(read_outline(
        number == 1 ? "POLYGON((0 0, 4 0, 0 3, 0 0))" : "POLYGON((-9 -9, -5 -9, -5 -5, -6 -8, -9 -9))"));
  }
  int asked = 0;
};

constexpr Layout ships{.axes = 2, .shape = Shape::outline, .has_heading = true};

/// x, y, number, heading, bounds: of which contact's rows need number and heading.
std::vector<double> row(double number, double heading) {
  return {0, 0, number, heading, 0, 0, 0, 0};
}

std::vector<double> rows_of(std::initializer_list<std::vector<double>> rows) {
  std::vector<double> all;
  for (const auto& one : rows) all.insert(all.end(), one.begin(), one.end());
  return all;
}

TEST(TurnedOutlines, AreSharedUnlessTheyAreTurned) {
  const auto rows = rows_of({row(1, 0), row(0, 30), row(1, 90), row(2, 0), row(1, 0)});
  Shelf shelf;
  NeverInterrupt never;
  const TurnedOutlines outlines(Bodies(ships, rows.data(), 5), shelf, never);
  EXPECT_EQ(shelf.asked, 2);
  EXPECT_EQ(outlines.pieces(1), nullptr);
  EXPECT_EQ(outlines.pieces(0), outlines.pieces(4));
  EXPECT_NE(outlines.pieces(0), outlines.pieces(2));
  EXPECT_EQ(outlines.pieces(2), outlines.pieces(2));
  EXPECT_EQ(outlines.pieces(2)->bounds(0).lower[1], -4);  // clockwise from the y axis
  EXPECT_EQ(outlines.pieces(3)->count(), 2u);
}

TEST(TurnedOutlines, SayWhatMemoryTheyTake) {
  const auto rows = rows_of({row(1, 0), row(1, 90), row(2, 90)});
  Shelf shelf;
  NeverInterrupt never;
  const TurnedOutlines outlines(Bodies(ships, rows.data(), 3), shelf, never);
  const std::size_t before = outlines.memory();
  outlines.pieces(0);
  EXPECT_EQ(outlines.memory(), before);
  outlines.pieces(2);
  EXPECT_GE(outlines.memory(), before + 4 * sizeof(Corner));
}

TEST(TurnedOutlines, ManyThreadsGetTheSamePieces) {
  constexpr int count = 64;
  std::vector<double> rows;
  for (int i = 0; i < count; ++i)
    for (const double number : row(1 + i % 2, i)) rows.push_back(number);
  Shelf shelf;
  NeverInterrupt never;
  const TurnedOutlines outlines(Bodies(ships, rows.data(), count), shelf, never);
  std::vector<const ConvexPieces*> seen[3];
  std::vector<std::thread> threads;
  for (auto& mine : seen)
    threads.emplace_back([&] {
      for (int i = 0; i < count; ++i) mine.push_back(outlines.pieces(static_cast<std::size_t>(i)));
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(seen[0], seen[1]);
  EXPECT_EQ(seen[0], seen[2]);
}

TEST(TurnedOutlines, AreMadeAnewForOtherRows) {
  auto rows = row(1, 90);
  Shelf shelf;
  NeverInterrupt never;
  TurnedOutlines outlines;
  outlines.assign(Bodies(ships, rows.data(), 1), shelf, never);
  EXPECT_EQ(outlines.pieces(0)->bounds(0).lower[1], -4);
  rows = row(1, -90);
  outlines.assign(Bodies(ships, rows.data(), 1), shelf, never);
  EXPECT_EQ(outlines.pieces(0)->bounds(0).upper[1], 4);
  rows = row(3, 0);
  EXPECT_THROW(outlines.assign(Bodies(ships, rows.data(), 1), shelf, never), Error);
}

// The box of an outline may lie beside the object's position; extents reach to both, and grow by r outward.
TEST(OutlineShape, ItsExtentsAreThoseOfTheOutlineGrownAndOfThePosition) {
  const Layout layout{.axes = 2, .shape = Shape::outline, .has_radius = true};
  const double numbers[] = {100, 200, 0.1, 1, -5, 4, -3, 6};  // x, y, r, number, bounds
  const Extents<2> around = extents_of<2>(Bodies(layout, numbers, 1), 0);
  EXPECT_LE(around.lower[0], -5 - 0.1);
  EXPECT_GE(around.upper[1], 6 + 0.1);
  EXPECT_NEAR(around.lower[0], -5.1, 1e-14);
  EXPECT_EQ(around.upper[0], 0);
  EXPECT_EQ(around.lower[1], 0);
  EXPECT_TRUE(core_box<2>(Bodies(layout, numbers, 1), 0, 0).is_empty());
}

}  // namespace
}  // namespace foresee::shape
