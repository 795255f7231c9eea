// The rotated outlines of many rows: looked up once, rotated on demand, also by several threads.
#include <gtest/gtest.h>

#include <thread>

#include "shape/outline/wkt.h"
#include "shape/swept_boxes.h"
#include "shape/turned_forms.h"

namespace foresee {
namespace {

struct Shelf final : FormSource {
  std::shared_ptr<const Form> form(std::int64_t number) override {
    ++queried;
    if (number > 2) throw Error("no such outline");
    return std::make_shared<const SharedOutline>(read_outline(
        number == 1 ? "POLYGON((0 0, 4 0, 0 3, 0 0))" : "POLYGON((-9 -9, -5 -9, -5 -5, -6 -8, -9 -9))"));
  }
  int queried = 0;
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
  ScratchPieces<ConvexPieces> own;
  const TurnedOutlines outlines(Bodies(ships, rows.data(), 5), shelf, never);
  EXPECT_EQ(shelf.queried, 2);
  EXPECT_EQ(outlines.pieces(1, own), nullptr);
  EXPECT_EQ(outlines.pieces(0, own), outlines.pieces(4, own));
  EXPECT_NE(outlines.pieces(0, own), outlines.pieces(2, own));
  EXPECT_EQ(outlines.pieces(2, own), outlines.pieces(2, own));
  EXPECT_EQ(outlines.pieces(2, own)->bounds(0).lower[1], -4);  // clockwise from the y axis
  EXPECT_EQ(outlines.pieces(3, own)->count(), 2u);
}

TEST(TurnedOutlines, OfOneHeadingAreShared) {
  const auto rows = rows_of({row(1, 90), row(2, 90), row(1, 90), row(1, 91)});
  Shelf shelf;
  NeverInterrupt never;
  ScratchPieces<ConvexPieces> own;
  const TurnedOutlines outlines(Bodies(ships, rows.data(), 4), shelf, never);
  EXPECT_EQ(outlines.pieces(0, own), outlines.pieces(2, own));
  EXPECT_NE(outlines.pieces(0, own), outlines.pieces(1, own));
  EXPECT_NE(outlines.pieces(0, own), outlines.pieces(3, own));
  EXPECT_EQ(own.pieces, nullptr);
}

TEST(TurnedOutlines, OfMoreHeadingsThanThereIsRoomForAreMadeAgainAndAreTheSame) {
  constexpr std::size_t count = 300, budget = 4096;
  std::vector<double> rows;
  for (std::size_t i = 0; i < count; ++i)
    for (const double number : row(1 + i % 2, 1.0 + static_cast<double>(i))) rows.push_back(number);
  Shelf shelf;
  NeverInterrupt never;
  ScratchPieces<ConvexPieces> own, unused;
  TurnedOutlines few(budget), all;
  for (TurnedOutlines* outlines : {&few, &all})
    outlines->assign(Bodies(ships, rows.data(), count), shelf, never);
  const std::size_t before = few.memory();
  std::size_t made_again = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const ConvexPieces& one = *few.pieces(i, own);
    const ConvexPieces& other = *all.pieces(i, unused);
    ASSERT_EQ(one.count(), other.count());
    for (std::size_t p = 0; p < one.count(); ++p)
      ASSERT_TRUE(std::equal(one.corners(p).begin(), one.corners(p).end(), other.corners(p).begin()));
    made_again += &one == own.pieces.get();
    EXPECT_EQ(few.pieces(i, own), &one) << "the same pieces at a second read";
  }
  EXPECT_LE(few.memory(), before + budget);
  EXPECT_GT(all.memory(), before + 4 * budget);
  EXPECT_GT(made_again, count / 2);
  EXPECT_EQ(unused.pieces, nullptr);
}

TEST(TurnedOutlines, SayWhatMemoryTheyTake) {
  const auto rows = rows_of({row(1, 0), row(1, 90), row(2, 90)});
  Shelf shelf;
  NeverInterrupt never;
  ScratchPieces<ConvexPieces> own;
  const TurnedOutlines outlines(Bodies(ships, rows.data(), 3), shelf, never);
  const std::size_t before = outlines.memory();
  outlines.pieces(0, own);
  EXPECT_EQ(outlines.memory(), before);
  outlines.pieces(2, own);
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
      ScratchPieces<ConvexPieces> own;
      for (int i = 0; i < count; ++i) mine.push_back(outlines.pieces(static_cast<std::size_t>(i), own));
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(seen[0], seen[1]);
  EXPECT_EQ(seen[0], seen[2]);
}

TEST(TurnedOutlines, AreMadeAgainForOtherRows) {
  auto rows = row(1, 90);
  Shelf shelf;
  NeverInterrupt never;
  ScratchPieces<ConvexPieces> own;
  TurnedOutlines outlines;
  outlines.assign(Bodies(ships, rows.data(), 1), shelf, never);
  EXPECT_EQ(outlines.pieces(0, own)->bounds(0).lower[1], -4);
  rows = row(1, -90);
  outlines.assign(Bodies(ships, rows.data(), 1), shelf, never);
  EXPECT_EQ(outlines.pieces(0, own)->bounds(0).upper[1], 4);
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
}  // namespace foresee
