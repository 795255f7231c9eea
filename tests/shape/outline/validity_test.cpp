// Every rule of outline validity by example, then all of them against a reference that tests every pair of
// edges in rational numbers.
#include "shape/outline/validity.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "base/error.h"
#include "contact/case_count.h"
#include "shape/outline/outline_judge.h"
#include "shape/outline/outline_rotation.h"
#include "shape/outline/test_outlines.h"
#include "shape/outline/wkt.h"

namespace foresee {
namespace {

using testing_by_hand::scaled_count;

/// The text of the flaw; "" if the outline is valid.
std::string flaw_in(const char* text) {
  try {
    check_outline(read_outline(text));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string flaw_turned(const Outline& outline, double heading) {
  try {
    check_turned(outline, edge_touch_of(outline), turned(outline, heading), heading);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void agree_with_judge(const Outline& outline) {
  const auto flaw = flaw_of(outline);
  EXPECT_EQ(!flaw, is_sound(outline)) << write_outline(outline) << (flaw ? ' ' + shown(*flaw, outline) : "");
}

TEST(Validity, EdgesThatCrossAreNamed) {
  EXPECT_EQ(flaw_in("POLYGON((0 0, 2 2, 2 0, 0 2, 0 0))"), "edges (0 0, 2 2) and (2 0, 0 2) cross");
}

TEST(Validity, ARingHasThreeCornersThatDiffer) {
  EXPECT_EQ(flaw_in("POLYGON((0 0, 1 1, 0 0))"), "ring 1 has fewer than three corners");
  EXPECT_EQ(flaw_in("POLYGON((0 0, 0 0, 1 1, 1 1, 0 0))"), "ring 1 has fewer than three corners");
  EXPECT_EQ(flaw_in("POLYGON((0 0, 4 0, 0 4, 0 0), (1 1))"), "ring 2 has fewer than three corners");
}

TEST(Validity, RepeatedCornersAreDropped) {
  EXPECT_EQ(flaw_in("POLYGON((0 0, 0 0, 1 0, 1 0, 1 0, 0 1, 0 0, 0 0))"), "");
}

TEST(Validity, ARingEnclosesAnArea) {
  EXPECT_EQ(flaw_in("POLYGON((0 0, 1 1, 3 3, 0 0))"), "ring 1 encloses no area: its corners lie on one line");
  EXPECT_EQ(flaw_in("POLYGON((0 3, 0 1, 0 7, 0 3))"), "ring 1 encloses no area: its corners lie on one line");
}

TEST(Validity, ARingDoesNotTurnBackOnItself) {
  EXPECT_EQ(flaw_in("POLYGON((0 0, 4 0, 4 4, 4 2, 0 0))"), "edges (4 0, 4 4) and (4 4, 4 2) overlap");
  EXPECT_EQ(flaw_in("POLYGON((0 0, 4 0, 9 0, 4 0, 4 4, 0 0))"), "edges (4 0, 9 0) and (9 0, 4 0) overlap");
}

TEST(Validity, ARingDoesNotTouchItself) {
  EXPECT_EQ(flaw_in("POLYGON((0 0, 4 0, 2 2, 4 4, 0 4, 2 2, 0 0))"),
            "ring 1 touches itself at (2 2): write a ring for each loop");
  EXPECT_EQ(flaw_in("POLYGON((0 0, 4 0, 4 4, 2 0, 0 4, 0 0))"),
            "ring 1 touches itself at (2 0): write a ring for each loop");
}

TEST(Validity, RingsMayTouchInSinglePoints) {
  EXPECT_EQ(flaw_in("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (0 0, 2 1, 1 2, 0 0))"), "");
  EXPECT_EQ(flaw_in("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (2 0, 3 1, 1 1, 2 0))"), "");
  EXPECT_EQ(flaw_in("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (0 2, 2 1, 4 2, 2 3, 0 2))"), "");
  EXPECT_EQ(flaw_in("MULTIPOLYGON(((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 1, 2 1, 2 2, 1 2, 1 1)))"), "");
  EXPECT_EQ(
      flaw_in("MULTIPOLYGON(((0 0, 9 0, 9 9, 0 9, 0 0), (0 0, 8 2, 8 8, 2 8, 0 0)), ((0 0, 7 3, 3 7, 0 0)))"),
      "");
}

TEST(Validity, RingsDoNotOverlap) {
  EXPECT_EQ(flaw_in("MULTIPOLYGON(((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 0, 2 0, 2 1, 1 1, 1 0)))"),
            "edges (1 0, 1 1) and (1 1, 1 0) overlap");
  EXPECT_EQ(flaw_in("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (1 0, 3 0, 2 2, 1 0))"),
            "edges (0 0, 4 0) and (1 0, 3 0) overlap");
}

TEST(Validity, RingsDoNotCrossInACorner) {
  EXPECT_EQ(flaw_in("MULTIPOLYGON(((0 0, 2 2, 4 0, 4 9, 0 9, 0 0)), ((2 2, 9 9, 9 -9, 1 -9, 2 2)))"),
            "edges (2 2, 4 0) and (2 2, 9 9) cross");
}

TEST(Validity, HolesAreWithinTheirPart) {
  EXPECT_EQ(flaw_in("POLYGON((0 0, 4 0, 0 4, 0 0), (8 8, 9 8, 8 9, 8 8))"),
            "ring 2 is a hole but lies outside its part");
  EXPECT_EQ(flaw_in("POLYGON((1 1, 2 1, 1 2, 1 1), (0 0, 4 0, 0 4, 0 0))"),
            "ring 2 is a hole but lies outside its part");
  EXPECT_EQ(flaw_in("POLYGON((0 0, 9 0, 0 9, 0 0), (1 1, 4 1, 1 4, 1 1), (2 2, 2.5 2, 2 2.5, 2 2))"),
            "ring 3 is a hole but lies within ring 2");
}

TEST(Validity, PartsAreDisjointOrWithinAHole) {
  EXPECT_EQ(flaw_in("MULTIPOLYGON(((0 0, 9 0, 0 9, 0 0)), ((1 1, 2 1, 1 2, 1 1)))"),
            "ring 1 of part 2 lies within ring 1 of part 1: write parts that lie apart");
  EXPECT_EQ(flaw_in("MULTIPOLYGON(((2 2, 2.5 2, 2 2.5, 2 2)), ((0 0, 9 0, 0 9, 0 0), (1 1, 4 1, 1 4, 1 1)))"),
            "");
}

TEST(Validity, AnUlpIsAGap) {
  EXPECT_EQ(flaw_in("POLYGON((0 0, 1 0, 1 1, 0.5 5e-324, 0 1, 0 0))"), "");
  EXPECT_EQ(flaw_in("POLYGON((0 0, 1 0, 1 1, 0.5 0, 0 1, 0 0))"),
            "ring 1 touches itself at (0.5 0): write a ring for each loop");
}

TEST(Validity, AgreesWithTheJudgeAboutRingsOnAGrid) {
  std::mt19937_64 random(1);
  const int cases = scaled_count(6000);
  int sound = 0;
  for (int i = 0; i < cases; ++i) {
    const Outline outline = random_rings(random);
    agree_with_judge(outline);
    sound += !flaw_of(outline);
  }
  EXPECT_GT(sound, cases / 20);
}

TEST(Validity, AgreesWithTheJudgeAboutCells) {
  std::mt19937_64 random(2);
  const int cases = scaled_count(150);
  int sound = 0;
  for (int i = 0; i < cases; ++i) {
    const Outline outline = random_cells(random);
    agree_with_judge(outline);
    sound += !flaw_of(outline);
  }
  EXPECT_GT(sound, cases / 4);
}

TEST(Validity, AgreesWithTheJudgeAnUlpApart) {
  std::mt19937_64 random(3);
  for (int i = 0; i < scaled_count(1500); ++i)
    agree_with_judge(shaken(scaled(moved(random_rings(random),
                                         [](const Corner& c) {
                                           return Corner{c.x + 0.3, c.y / 3};
                                         }),
                                   static_cast<int>(random() % 500) - 300),
                            random));
}

TEST(Validity, AgreesWithTheJudgeBeyondWhatDoublesMultiply) {
  std::mt19937_64 random(4);
  for (const int exponent : {-1074, -700, 700, 1020})
    for (int i = 0; i < scaled_count(100); ++i) agree_with_judge(scaled(random_rings(random), exponent));
}

TEST(Validity, AgreesWithTheJudgeAboutCombsSpiralsStarsAndChains) {
  std::mt19937_64 random(5);
  for (const Outline& outline : {comb(9), spiral(4), random_star(random, 40), chain_of_holes(5)}) {
    EXPECT_EQ(flaw_of(outline), std::nullopt);
    agree_with_judge(outline);
    for (int i = 0; i < 4; ++i) agree_with_judge(shaken(outline, random));
  }
}

TEST(Validity, TurningByRightAnglesKeepsEveryTouch) {
  const Outline outline = read_outline("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (2 0, 3 1, 1 1, 2 0))");
  for (const double heading : {0.0, 90.0, -90.0, 180.0, 270.0, 360.0})
    EXPECT_EQ(flaw_turned(outline, heading), "");
}

TEST(Validity, ATurnPartsACornerFromAnEdge) {
  EXPECT_EQ(flaw_turned(read_outline("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (2 0, 3 1, 1 1, 2 0))"), 37.5),
            "turned by 37.5 degrees its rings no longer touch at (2 0): write this point as a corner of both "
            "rings");
  EXPECT_EQ(flaw_turned(read_outline("POLYGON((0 0, 2 0, 4 0, 4 4, 0 4, 0 0), (2 0, 3 1, 1 1, 2 0))"), 37.5),
            "");
}

TEST(Validity, EdgeTouchesAreComputedOnceForAllRotations) {
  const Outline outline = read_outline("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (2 0, 3 1, 1 1, 2 0))");
  const auto touch = edge_touch_of(outline);
  ASSERT_TRUE(touch.has_value());
  EXPECT_EQ(touch->place, (Corner{2, 0}));
  EXPECT_THROW(check_turned(outline, touch, turned(outline, 37.5), 37.5), Error);
  EXPECT_NO_THROW(check_turned(outline, touch, turned(outline, 270), 270));
  const Outline square = read_outline("POLYGON((0 0, 4 0, 4 4, 0 4, 0 0))");
  EXPECT_FALSE(edge_touch_of(square).has_value());
  EXPECT_NO_THROW(check_turned(square, {}, turned(square, 37.5), 37.5));
}

TEST(Validity, ATurnMayCloseAGapOfAnUlp) {
  // Two parts beside each other, an ulp of 1 apart, far out.
  const Outline outline = read_outline(
      "MULTIPOLYGON(((0.5 9, 1 9, 1 70, 0.5 9)), ((1.0000000000000002 9, 2 9, 1.0000000000000002 60, "
      "1.0000000000000002 9)))");
  EXPECT_EQ(flaw_of(outline), std::nullopt);
  int refused = 0;
  for (int heading = 1; heading < 90; ++heading) {
    const std::string message = flaw_turned(outline, heading);
    if (message.empty()) continue;
    ++refused;
    EXPECT_NE(message.find("touch: they are closer than doubles resolve"), std::string::npos) << message;
    EXPECT_FALSE(is_sound(turned(outline, heading)));
  }
  EXPECT_GT(refused, 20);
}

/// Cost must grow as n log n for every outline: the maximum of corners takes well below a second.
TEST(Validity, TheMaximumOfCornersTakesNoLongerThanOthers) {
  std::mt19937_64 random(6);
  const Outline slanted = moved(comb(32767), [](const Corner& c) {
    return Corner{c.x * 1000 + c.y, c.x * 1000 - c.y};
  });
  for (const Outline& outline :
       {random_star(random, 65536), comb(32767), slanted, spiral(8192), chain_of_holes(16382)}) {
    EXPECT_GT(outline.corners().size(), 65500u);
    EXPECT_LE(outline.corners().size(), max_corners);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(flaw_of(outline), std::nullopt);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
  }
}

}  // namespace
}  // namespace foresee
