#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "base/error.h"
#include "shape/outline/wkt.h"

namespace foresee {
namespace {

/// The error of the reader for this text; "" if it reads it.
std::string refusal(std::string_view text) {
  try {
    read_outline(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string whole;
  whole.reserve(text.size() * times);
  for (; times > 0; --times) whole += text;
  return whole;
}

/// A ring of so many corners.
std::string ring_of(std::size_t corners) {
  std::string ring = "(0 0";
  for (std::size_t i = 1; i < corners; ++i) ring += ", " + std::to_string(i) + " 1";
  return ring + ", 0 0)";
}

TEST(WktReader, ReadsPartsRingsAndCorners) {
  const Outline outline =
      read_outline("MULTIPOLYGON(((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1)), ((20 0, 29 0, 20 9, 20 0)))");
  EXPECT_EQ(outline.parts(), 2u);
  EXPECT_EQ(outline.rings(), 3u);
  EXPECT_EQ(outline.part_start(1), 2u);
  EXPECT_EQ(outline.corners().size(), 9u);
  EXPECT_EQ(outline.ring(1)[2], (Corner{1, 2}));
  EXPECT_EQ(outline.extents().upper[0], 29);
}

TEST(WktReader, TakesAnyCaseAndWhiteSpace) {
  const Outline outline = read_outline("POLYGON((0 0,1 0,0 1,0 0))");
  EXPECT_EQ(read_outline(" \n polygon\t( ( 0\r0 , 1 0,0  1\f,\v0 0 ) ) \n"), outline);
  EXPECT_EQ(read_outline("MultiPolygon (((0 0, 1 0, 0 1, 0 0)))"), outline);
}

TEST(WktReader, NumbersAreTheNearestDoubles) {
  const Outline outline = read_outline("POLYGON((+1e2 -.5, 5. 1E-3, 0.1 4.9e-324, 1e+2 -0.5))");
  EXPECT_EQ(outline.corners()[0], (Corner{100, -0.5}));
  EXPECT_EQ(outline.corners()[1], (Corner{5, 0.001}));
  EXPECT_EQ(outline.corners()[2], (Corner{0.1, 5e-324}));
}

TEST(WktReader, MinusZeroIsZero) {
  const Outline outline = read_outline("POLYGON((-0 0, 1 -0.0, 0 1, 0 -0e5))");
  EXPECT_EQ(outline.corners().size(), 3u);
  for (const Corner& corner : outline.corners())
    EXPECT_FALSE(std::signbit(corner.x) || std::signbit(corner.y));
}

TEST(WktReader, RepeatedCornersAreDropped) {
  EXPECT_EQ(read_outline("POLYGON((0 0, 0 0, 1 0, 1 0, 1 0, 0 1, 0 0, 0 0))").corners().size(), 3u);
}

TEST(WktReader, AnSridIsDroppedUnlessItMeansDegrees) {
  EXPECT_EQ(read_outline("srid = 32632 ; POLYGON((0 0,1 0,0 1,0 0))").corners().size(), 3u);
  EXPECT_EQ(refusal("SRID=4326;POLYGON((0 0,1 0,0 1,0 0))"),
            "at character 6: SRID 4326 is in degrees: project to metres first");
  EXPECT_EQ(refusal("SRID=x;POLYGON((0 0,1 0,0 1,0 0))"),
            "at character 6: expected a whole number, found 'x'");
  EXPECT_EQ(refusal("SRID=;POLYGON((0 0,1 0,0 1,0 0))"),
            "at character 6: expected a whole number, found ';'");
  EXPECT_EQ(refusal("SRID=12 POLYGON((0 0,1 0,0 1,0 0))"), "at character 9: expected ;, found 'POLYGON'");
}

TEST(WktReader, EmptyIsNoOutline) {
  EXPECT_EQ(refusal("POLYGON EMPTY"), "at character 9: EMPTY is no outline: write NULL for a point");
  EXPECT_EQ(refusal("multipolygon(empty)"), "at character 14: EMPTY is no outline: write NULL for a point");
  EXPECT_EQ(refusal("POLYGON((0 0,1 0,0 1,0 0),EMPTY)"),
            "at character 27: EMPTY is no outline: write NULL for a point");
}

TEST(WktReader, RingsAreClosed) {
  EXPECT_EQ(refusal("POLYGON((0 0, 1 0, 0 1))"),
            "ring 1 is not closed: write the first corner (0 0) again at its end");
  EXPECT_EQ(refusal("MULTIPOLYGON(((0 0, 9 0, 0 9, 0 0)), ((5 5, 1 0, 0 1)))"),
            "ring 1 of part 2 is not closed: write the first corner (5 5) again at its end");
}

TEST(WktReader, WhatIsNoNumberIsNamed) {
  EXPECT_EQ(refusal("POLYGON((0 0,nan 0))"), "at character 14: expected a number, found 'nan'");
  for (const char* word : {"inf", "-inf", "infinity", "0x10", "1e", "1e+", "--1", "+-1", "-", "+", ".", "1_0",
                           "1.2.3", "1-2", "1'", "e5", "#"})
    EXPECT_EQ(refusal(std::string("POLYGON((0 0,") + word + " 0))"),
              std::string("at character 14: expected a number, found '") + word + "'");
  EXPECT_EQ(refusal("POLYGON((0 0,1, 1 1))"), "at character 15: expected a number, found ','");
  EXPECT_EQ(refusal("POLYGON((0 0,"), "at character 14: expected a number, found the end");
  EXPECT_EQ(refusal("POLYGON((0 0,1e999 0))"), "at character 14: no double is near 1e999");
  EXPECT_EQ(refusal("POLYGON((0 0,1 -1e-999))"), "at character 16: no double is near -1e-999");
}

TEST(WktReader, AThirdNumberIsRefused) {
  EXPECT_EQ(refusal("POLYGON((0 0 0, 1 0 0, 0 1 0, 0 0 0))"),
            "at character 14: a third number: corners of a flat outline have two: leave z out");
  EXPECT_EQ(refusal("POLYGON Z((0 0 0, 1 0 0, 0 1 0, 0 0 0))"),
            "at character 9: corners of a flat outline have two numbers: leave Z out");
}

TEST(WktReader, OtherTextsAreRefused) {
  EXPECT_EQ(refusal(""), "at character 1: expected POLYGON or MULTIPOLYGON, found the end");
  EXPECT_EQ(refusal("POINT(0 0)"), "at character 1: expected POLYGON or MULTIPOLYGON, found 'POINT'");
  EXPECT_EQ(refusal("POLYGONS((0 0,1 0,0 1,0 0))"),
            "at character 1: expected POLYGON or MULTIPOLYGON, found 'POLYGONS'");
  EXPECT_EQ(refusal("POLYGON(0 0,1 0,0 1,0 0)"), "at character 9: expected (, found '0'");
  EXPECT_EQ(refusal("POLYGON((0 0,1 0,0 1,0 0)"), "at character 26: expected ), found the end");
  EXPECT_EQ(refusal("POLYGON((0 0,1 0,0 1,0 0)))"), "at character 27: expected the end, found ')'");
  EXPECT_EQ(refusal("POLYGON((0 0,1 0,0 1,0 0)),"), "at character 27: expected the end, found ','");
  EXPECT_EQ(refusal("POLYGON((0 0,1 0;0 1,0 0))"), "at character 17: expected , or ), found ';'");
  EXPECT_EQ(refusal("POLYGON()"), "at character 9: expected (, found ')'");
  EXPECT_EQ(refusal("POLYGON(())"), "at character 10: expected a number, found ')'");
}

TEST(WktReader, QuotesFortyCharactersAtMost) {
  EXPECT_EQ(refusal(repeated("x", 1000)),
            "at character 1: expected POLYGON or MULTIPOLYGON, found '" + repeated("x", 39) + "…'");
  EXPECT_EQ(refusal(repeated("\xc3\xa9", 1000)),
            "at character 1: expected POLYGON or MULTIPOLYGON, found '" + repeated("\xc3\xa9", 39) + "…'");
  EXPECT_EQ(refusal(repeated("x", 40)),
            "at character 1: expected POLYGON or MULTIPOLYGON, found '" + repeated("x", 40) + "'");
  EXPECT_EQ(refusal(std::string_view("ab\0cd", 5)),
            "at character 1: expected POLYGON or MULTIPOLYGON, found 'ab'");
}

TEST(WktReader, TheMaximumOfCornersIsRead) {
  EXPECT_EQ(read_outline("POLYGON(" + ring_of(65536) + ")").corners().size(), 65536u);
  EXPECT_EQ(read_outline("POLYGON(" + ring_of(65533) + ", " + ring_of(3) + ")").corners().size(), 65536u);
}

TEST(WktReader, MoreCornersAreCounted) {
  EXPECT_EQ(refusal("POLYGON(" + ring_of(65537) + ")"), "65537 corners; at most 65536: simplify the outline");
  EXPECT_EQ(refusal("POLYGON(" + ring_of(70000) + ")"), "70000 corners; at most 65536: simplify the outline");
  EXPECT_EQ(refusal("POLYGON(" + ring_of(65534) + ", " + ring_of(3) + ")"),
            "65537 corners; at most 65536: simplify the outline");
  EXPECT_EQ(refusal("MULTIPOLYGON((" + ring_of(65534) + ", " + ring_of(100) + "), (" + ring_of(7) + "))"),
            "65641 corners; at most 65536: simplify the outline");
  EXPECT_EQ(refusal("POLYGON(" + ring_of(65536) + ", (0 0))"),
            "65537 corners; at most 65536: simplify the outline");
}

/// Texts of two million characters.
TEST(WktReader, HostileTextTakesNoLongerThanItIs) {
  const std::size_t n = 2'000'000;
  for (const std::string& text :
       {repeated("(", n), "POLYGON" + repeated(" ", n), "POLYGON((" + repeated("9", n) + " 0))",
        "POLYGON((0." + repeated("1", n) + "x", "POLYGON((" + repeated("0 0,", n / 4),
        "POLYGON((" + repeated("1 1,0 0,", n / 8), "SRID=" + repeated("1", n),
        "MULTIPOLYGON(" + repeated("((0 0)),", n / 8), "POLYGON(" + repeated("(0 0),", n / 6)}) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_LT(refusal(text).size(), 200u);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
  }
}

}  // namespace
}  // namespace foresee
