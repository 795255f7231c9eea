#include "motion/plan/plan_text.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>

#include "base/error.h"
#include "motion/plan/random_legs.h"
#include "numbers/rationals.h"

namespace foresee {
namespace {

using testing::read_plan;
using testing::write_plan;

std::string refusal_of_text(std::string_view text) {
  try {
    read_plan(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(PlanText, ReadsKnots) {
  const Plan plan = read_plan("LINESTRING M(0 0 0, 10 0 5, 10 0.5 9)");
  EXPECT_EQ(plan.axes, 2);
  EXPECT_EQ(plan.kind, PlanKind::knots);
  ASSERT_EQ(plan.knots.size(), 3u);
  EXPECT_EQ(plan.knots[2], (Knot{9, {10, 0.5, 0}}));
  EXPECT_EQ(read_plan("LINESTRING ZM(0 1 2 3, 4 5 6 7)").knots[1], (Knot{7, {4, 5, 6}}));
}

TEST(PlanText, ReadsParts) {
  const Plan plan = read_plan("MULTILINESTRING M((0 0 0, 1 0 1), (7 7 1, 8 7 2, 9 9 3))");
  EXPECT_EQ(plan.part_starts, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(plan.part_end(0), 2u);
  EXPECT_EQ(plan.part_end(1), 5u);
  EXPECT_EQ(read_plan("MULTILINESTRING ZM((0 0 0 0, 1 0 0 1))").parts(), 1u);
}

TEST(PlanText, TakesAnyCaseAndWhiteSpace) {
  const Plan plan = read_plan("LINESTRING M(0 0 0,1 0 1)");
  for (const char* text : {"linestringm(0 0 0,1 0 1)", " \n LineString\tm ( 0\r0 0 ,\v1 0  1 ) ",
                           "SRID=32632;LINESTRING M(0 0 0, +1 -0e3 1.)"})
    EXPECT_EQ(read_plan(text), plan) << text;
  EXPECT_EQ(read_plan("linestringzm(0 0 0 0,1 0 0 1)").axes, 3);
  EXPECT_EQ(read_plan("multilinestringM((0 0 0,1 0 1))"), plan);
  EXPECT_EQ(read_plan("MultiLineStringZM((0 0 0 0,1 0 0 1))").axes, 3);
}

TEST(PlanText, ReadsAMoverThatRests) {
  for (const char* word : {"inf", "Inf", "INFINITY", "infinity"}) {
    const Plan plan = read_plan(std::string("LINESTRING M(0 0 0, 5 0 5, 5 0 ") + word + ")");
    EXPECT_EQ(plan.knots.back(), (Knot{no_end, {5, 0, 0}}));
  }
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 0, 5 0 inf)"),
            "knot 2: t is inf, but its place is not that of knot 1: write the place where the mover stays");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 0, 0 0 inf, 0 0 9)"),
            "knot 3: t is 9 after inf: times must rise; write MULTILINESTRING M for a jump");
  EXPECT_EQ(refusal_of_text("MULTILINESTRING M((0 0 0, 0 0 inf), (0 0 8, 0 0 9))"),
            "part 2 starts at 8, before part 1 ends at inf");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 -inf, 5 0 1)"),
            "at character 18: expected a number, found '-inf' (knot 1)");
  EXPECT_EQ(refusal_of_text("LINESTRING M(inf 0 0, 5 0 1)"),
            "at character 14: expected a number, found 'inf' (knot 1)");
}

TEST(PlanText, NamesAWrongNumberOfNumbers) {
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0, 10 0 5)"),
            "at character 14: expected 3 numbers (x y t), found 2 (knot 1)");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 0 0, 10 0 5)"),
            "at character 14: expected 3 numbers (x y t), found 4 (knot 1)");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 0, 10)"),
            "at character 21: expected 3 numbers (x y t), found 1 (knot 2)");
  EXPECT_EQ(refusal_of_text("LINESTRING ZM(0 0 0, 10 0 5)"),
            "at character 15: expected 4 numbers (x y z t), found 3 (knot 1)");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 0 1e400)"),
            "at character 20: no double is near 1e400 (knot 1)");
}

TEST(PlanText, NamesWhatIsNoPlan) {
  EXPECT_EQ(
      refusal_of_text("LINESTRING(0 0 0, 10 0 5)"),
      "at character 11: write LINESTRING M: the third number is the time, or LINESTRING ZM: the fourth");
  EXPECT_EQ(refusal_of_text("MULTILINESTRING ((0 0 0, 10 0 5))"),
            "at character 17: write MULTILINESTRING M: the third number is the time, or MULTILINESTRING ZM: "
            "the fourth");
  EXPECT_EQ(refusal_of_text("LINESTRING Z(0 0 0, 10 0 5)"),
            "at character 12: write LINESTRING ZM: the fourth number is the time");
  EXPECT_EQ(refusal_of_text("LINESTRING EMPTY"), "at character 12: EMPTY is no plan: write NULL and x, y");
  EXPECT_EQ(refusal_of_text("LINESTRING M EMPTY"), "at character 14: EMPTY is no plan: write NULL and x, y");
  EXPECT_EQ(refusal_of_text("MULTILINESTRING M(EMPTY)"),
            "at character 19: EMPTY is no plan: write NULL and x, y");
  EXPECT_EQ(refusal_of_text("POINT M(0 0 0)"),
            "at character 1: expected LINESTRING M or LINESTRING ZM, found 'POINT'");
  EXPECT_EQ(refusal_of_text("from A to B"),
            "at character 1: expected LINESTRING M or LINESTRING ZM, found 'from'");
  EXPECT_EQ(refusal_of_text("LINESTRINGS M(0 0 0)"),
            "at character 1: expected LINESTRING M or LINESTRING ZM, found 'LINESTRINGS'");
  EXPECT_EQ(refusal_of_text(""), "at character 1: expected LINESTRING M or LINESTRING ZM, found the end");
  EXPECT_EQ(refusal_of_text("SRID=4326;LINESTRING M(0 0 0, 1 0 1)"),
            "at character 6: SRID 4326 is in degrees: project to metres first");
  EXPECT_EQ(refusal_of_text("LINESTRING M 0 0 0"), "at character 14: expected (, found '0'");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 0; 1 0 1)"), "at character 19: expected , or ), found ';'");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 0, 1 0 1"), "at character 26: expected , or ), found the end");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 0, 1 0 1))"), "at character 27: expected the end, found ')'");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 x 0, 1 0 1)"),
            "at character 16: expected a number, found 'x' (knot 1)");
  EXPECT_EQ(refusal_of_text("MULTILINESTRING M(0 0 0, 1 0 1)"), "at character 19: expected (, found '0'");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 0)"), "part 1 has one knot: write two, or a plain row");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 0, 1 0 5, 2 0 5)"),
            "knot 3: t is 5 after 5: times must rise; write MULTILINESTRING M for a jump");
  EXPECT_EQ(refusal_of_text("MULTILINESTRING M((0 0 0, 1 0 5), (2 0 4, 3 3 7))"),
            "part 2 starts at 4, before part 1 ends at 5");
}

TEST(PlanText, SaysWhatToWriteInPlaceOfOtherFormats) {
  EXPECT_EQ(
      refusal_of_text(R"({"type": "LineString"})"),
      "at character 1: expected LINESTRING M, found JSON: read it with json_each and plan_points(t, x, y)");
  EXPECT_EQ(refusal_of_text("01020000C002000000000000000000F03F"),
            "at character 1: expected LINESTRING M, found a geometry in hexadecimal digits: write "
            "ST_AsText(g, 17)");
  EXPECT_EQ(refusal_of_text("LINESTRING M(0 0 2026-11-21T12:00:00Z, 1 0 9)"),
            "at character 18: expected a number, found '2026-11-21T12:00:00Z': write seconds, as "
            "unixepoch('2026-11-21T12:00:00Z') gives them (knot 1)");
  std::string text = "LINESTRING M(0 0 0";
  for (int t = 1; t < 499; ++t) text += ", 1 0 " + std::to_string(t);
  EXPECT_EQ(refusal_of_text(text + ", 1 0 last)").substr(17), ": expected a number, found 'last' (knot 500)");
}

TEST(PlanText, TimesInSecondsHaveNoExponent) {
  EXPECT_EQ(write_plan(read_plan("LINESTRING M(0 0 1796e6, 1 1e9 1796000020.5)")),
            "LINESTRING M(0 0 1796000000, 1 1000000000 1796000020.5)");
}

TEST(PlanText, WritesWhatTheReferenceShows) {
  for (const char* text :
       {"LINESTRING M(0 0 0, 10 0 5, 10 0 inf)", "LINESTRING ZM(0 0 0.1 0, 1e+22 1e-07 5 5)",
        "MULTILINESTRING M((0 0 0, 1 0 1), (7 7 1, -0 7 2))",
        "MULTILINESTRING ZM((0 0 0 0, 1 0 0 1), (7 7 1 1, 8 7 2 2))"})
    EXPECT_EQ(write_plan(read_plan(text)), text);
}

TEST(PlanText, NumbersReadBackBitForBit) {
  judge::Inputs inputs(5);
  for (int i = judge::cases(2000); i > 0; --i) {
    Plan plan{.kind = PlanKind::knots, .axes = inputs.between(2, 3)};
    double t = inputs.any_double();
    for (int n = inputs.between(2, 9); n > 0 && std::abs(t) < 1e300; --n) {
      Knot knot{t, {}};
      for (int j = 0; j < plan.axes; ++j) knot.x[static_cast<std::size_t>(j)] = inputs.any_double();
      plan.knots.push_back(knot);
      t = std::nextafter(t + std::abs(t) * inputs.below(3), no_end);
    }
    if (plan.knots.size() < 2) continue;
    const Plan read = read_plan(write_plan(plan));
    ASSERT_EQ(read, plan) << write_plan(plan);
    ASSERT_EQ(write_plan(read), write_plan(plan));
  }
}

TEST(PlanText, HostileTextTakesNoLongerThanItIs) {
  const auto repeated = [](const std::string& text, std::size_t times) {
    std::string whole;
    for (; times > 0; --times) whole += text;
    return whole;
  };
  const std::size_t n = 2'000'000;
  for (const std::string& text :
       {repeated("(", n), "LINESTRING M" + repeated(" ", n), "LINESTRING M(" + repeated("9", n) + " 0 0)",
        "LINESTRING M(" + repeated("0 ", n / 2), "LINESTRING M(" + repeated("0 0 0,", n / 6),
        "MULTILINESTRING M(" + repeated("(0 0 0),", n / 8), "LINESTRING M(" + repeated("inf ", n / 4)}) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_LT(refusal_of_text(text).size(), 200u);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3));
  }
}

}  // namespace
}  // namespace foresee
