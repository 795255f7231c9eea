// make_contact() against the oracle on the families of hard_pairs.h: contact or no contact, and each of dt,
// dt_end, t, t_end the double nearest to the exact one.
//
// FORESEE_LONG=1 multiplies the number of cases by 50.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "contact/case_count.h"
#include "contact/hard_pairs.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

void check(const Family& family, Shapes shapes, int axes, int cases, std::uint64_t seed) {
  Generator generate(family, seed);
  int contacts = 0;
  for (int i = 0; i < scaled_count(cases); ++i) {
    const Case c = make_case(generate, family, shapes, axes);
    const auto answer = contact(c.a, c.b, c.question);
    contacts += answer.has_value();
    const std::string complaint =
        oracle::judge(rule_of(c.a, c.b, c.question), c.a, c.b, c.question.horizon, answer);
    if (complaint.empty()) continue;
    std::ostringstream story;
    story << c;
    if (answer)
      story << "\n  answer dt " << answer->dt << " dt_end " << answer->dt_end << " t " << answer->t
            << " t_end " << answer->t_end;
    FAIL() << family.name << ", axes " << axes << ", case " << i << ": " << complaint << "\n" << story.str();
  }
  // A family without any contact would prove nothing.
  if (family.spread == 0 && scaled_count(cases) >= 50 && axes < 3) {
    EXPECT_GT(contacts, 0) << family.name;
  }
}

void check_all(std::span<const Family> list, Shapes shapes, std::initializer_list<int> all_axes, int cases) {
  std::uint64_t seed = 1000 * (static_cast<int>(shapes) + 1);
  for (const Family& family : list)
    for (int axes : all_axes) check(family, shapes, axes, cases, seed++);
}

TEST(Oracle, BoxesInOneDimension) {
  check_all(ordinary_families(), Shapes::boxes, {1}, 400);
}
TEST(Oracle, BoxesInTwoDimensions) {
  check_all(ordinary_families(), Shapes::boxes, {2}, 400);
}
TEST(Oracle, BoxesInThreeDimensions) {
  check_all(ordinary_families(), Shapes::boxes, {3}, 300);
}
TEST(Oracle, BoxesOfExtremeNumbers) {
  check_all(extreme_families(), Shapes::boxes, {1, 2, 3}, 60);
}
TEST(Oracle, BallsInOneDimension) {
  check_all(ordinary_families(), Shapes::balls, {1}, 50);
}
TEST(Oracle, BallsInTwoDimensions) {
  check_all(ordinary_families(), Shapes::balls, {2}, 120);
}
TEST(Oracle, BallsInThreeDimensions) {
  check_all(ordinary_families(), Shapes::balls, {3}, 60);
}
TEST(Oracle, BallsOfExtremeNumbers) {
  check_all(extreme_families(), Shapes::balls, {2, 3}, 40);
}
TEST(Oracle, PointsWithinADistance) {
  check_all(ordinary_families(), Shapes::points_within, {1, 2, 3}, 20);
}
TEST(Oracle, BoxAndBall) {
  check_all(ordinary_families(), Shapes::box_and_ball, {1, 2}, 60);
}
TEST(Oracle, BoxAndBallInThreeDimensions) {
  check_all(ordinary_families(), Shapes::box_and_ball, {3}, 60);
}
TEST(Oracle, BoxAndBallOfExtremeNumbers) {
  check_all(extreme_families(), Shapes::box_and_ball, {2, 3}, 10);
}
TEST(Oracle, BoxAndPointWithinADistance) {
  check_all(ordinary_families(), Shapes::box_and_point_within, {1, 2, 3}, 30);
}
TEST(Oracle, Cylinders) {
  check_all(ordinary_families(), Shapes::cylinders, {3}, 120);
}
TEST(Oracle, CylinderAndBox) {
  check_all(ordinary_families(), Shapes::cylinder_and_box, {3}, 60);
}
TEST(Oracle, CylindersOfExtremeNumbers) {
  check_all(extreme_families(), Shapes::cylinders, {3}, 20);
  check_all(extreme_families(), Shapes::cylinder_and_box, {3}, 10);
}

TEST(Oracle, BoxesThatGrow) {
  check_all(growing_families(), Shapes::boxes, {1, 2, 3}, 60);
}
TEST(Oracle, BallsThatGrow) {
  check_all(growing_families(), Shapes::balls, {1, 2, 3}, 40);
}
TEST(Oracle, BoxAndBallThatGrow) {
  check_all(growing_families(), Shapes::box_and_ball, {1, 2}, 30);
  check_all(growing_families(), Shapes::box_and_ball, {3}, 10);
  check_all(growing_families(), Shapes::box_and_point_within, {2}, 10);
}
TEST(Oracle, CylindersThatGrow) {
  check_all(growing_families(), Shapes::cylinders, {3}, 40);
  check_all(growing_families(), Shapes::cylinder_and_box, {3}, 20);
}

TEST(Oracle, HostileScales) {
  check_all(hostile_families(), Shapes::boxes, {2, 3}, 40);
  check_all(hostile_families(), Shapes::balls, {2, 3}, 20);
  check_all(hostile_families(), Shapes::box_and_ball, {2, 3}, 4);
  check_all(hostile_families(), Shapes::cylinders, {3}, 10);
}

/// An oracle that accepts every answer would prove nothing either.
TEST(Oracle, ObjectsToAnyOtherAnswer) {
  for (const Shapes shapes : {Shapes::boxes, Shapes::balls, Shapes::box_and_ball, Shapes::cylinders}) {
    Generator generate(ordinary_families()[1], 7);
    for (int i = 0; i < 50; ++i) {
      const Case c = make_case(generate, ordinary_families()[1], shapes, 3);
      const oracle::Rule rule = rule_of(c.a, c.b, c.question);
      const auto objects_to = [&](const std::optional<ContactTimes>& answer) {
        return !oracle::judge(rule, c.a, c.b, c.question.horizon, answer).empty();
      };
      const auto right = contact(c.a, c.b, c.question);
      EXPECT_FALSE(objects_to(right));
      if (!right) {
        EXPECT_TRUE(objects_to(ContactTimes{0, 0, 0, 0}));
        continue;
      }
      EXPECT_TRUE(objects_to(std::nullopt));
      for (double ContactTimes::*time :
           {&ContactTimes::t, &ContactTimes::t_end, &ContactTimes::dt, &ContactTimes::dt_end})
        for (double towards : {-1e9, 1e9}) {
          ContactTimes wrong = *right;
          wrong.*time = std::nextafter(wrong.*time, towards);
          EXPECT_TRUE(objects_to(wrong));
        }
    }
  }
}

}  // namespace
}  // namespace foresee
