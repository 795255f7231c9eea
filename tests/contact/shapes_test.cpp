// Every row of the table of distances (docs/explanation/semantics.md#contact), by cases whose answer is known without
// computation.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "base/error.h"
#include "contact/pair_by_hand.h"
#include "contact/window_contact.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

Object at(Shape shape, std::initializer_list<double> x, std::initializer_list<double> v, double r = 0,
          double hz = 0) {
  Object o = object(static_cast<int>(x.size()), shape);
  std::copy(x.begin(), x.end(), o.x);
  std::copy(v.begin(), v.end(), o.v);
  for (double& half : o.half) half = r;
  o.r = r, o.hz = hz;
  return o;
}

ContactQuestion queried(double h, double within = 0, std::optional<double> within_z = {}) {
  return {.horizon = {0, h}, .within = within, .within_z = within_z};
}

void expect_span(const std::optional<ContactTimes>& times, double begin, double end) {
  ASSERT_TRUE(times.has_value());
  EXPECT_EQ(times->dt, begin);
  EXPECT_EQ(times->dt_end, end);
}

TEST(BallBall, TouchesWhenGapReachesZero) {
  const Object a = at(Shape::ball, {0, 0}, {1, 0}, 2), b = at(Shape::ball, {9, 0}, {0, 0}, 1);
  expect_span(contact(a, b, queried(100)), 6, 12);
  EXPECT_FALSE(contact(a, b, queried(std::nextafter(6.0, 0))));
}

TEST(BallBall, GrazesForAnInstant) {
  // Passes at the height of 5 = 3 + 2, and slightly above it.
  expect_span(contact(at(Shape::ball, {-4, 5}, {1, 0}, 3), at(Shape::ball, {0, 0}, {0, 0}, 2), queried(100)),
              4, 4);
  EXPECT_FALSE(contact(at(Shape::ball, {-4, std::nextafter(5.0, 9)}, {1, 0}, 3),
                       at(Shape::ball, {0, 0}, {0, 0}, 2), queried(100)));
}

TEST(BallBall, AcceleratedGrazeAtTheTurningPoint) {
  Object thrown = at(Shape::ball, {0, 0, 0}, {0, 0, 8}, 0.5);
  thrown.a[2] = -2;  // rises to 16 at 4
  expect_span(contact(thrown, at(Shape::ball, {0, 0, 17}, {0, 0, 0}, 0.5), queried(100)), 4, 4);
}

/// No contact is lost if squares of the coefficients of the distance overflow.
TEST(BallBall, MeetAtAnyScale) {
  const auto pair = [](double length, double time) {
    const double v = length / time, a = v / time;
    Object one =
        at(Shape::ball, {32 * length, 20 * length, -28 * length}, {10 * v, 2 * v, -10 * v}, 16 * length);
    Object other = at(Shape::ball, {40 * length, 20 * length, 0}, {6 * v, -4 * v, -6 * v}, 12 * length);
    one.a[0] = -a, one.a[1] = -a, one.a[2] = a;
    other.a[0] = 2 * a, other.a[1] = a, other.a[2] = -2 * a;
    return contact(one, other, queried(8 * time));
  };
  const auto usual = pair(1, 1);
  ASSERT_TRUE(usual);
  for (int bits = -480; bits <= 480; bits += 20) {
    const auto other = pair(std::exp2(bits), 1);
    ASSERT_TRUE(other) << bits;
    EXPECT_EQ(other->dt, usual->dt) << bits;
  }
  for (int bits = -240; bits <= 300; bits += 20) {
    const auto other = pair(1, std::exp2(bits));
    ASSERT_TRUE(other) << bits;
    EXPECT_EQ(other->dt, std::exp2(bits) * usual->dt) << bits;
  }
}

TEST(BallBall, PointsMeetWithinADistance) {
  const Object a = at(Shape::point, {0, 3}, {1, 0}), b = at(Shape::point, {10, 0}, {0, 0});
  expect_span(contact(a, b, queried(100, 5)), 6, 14);
  EXPECT_FALSE(contact(a, b, queried(100)));
}

TEST(BallBall, PointInsideADiscIsInContactFromTheStart) {
  expect_span(contact(at(Shape::point, {1, 0}, {1, 0}), at(Shape::ball, {0, 0}, {0, 0}, 3), queried(100)), 0,
              2);
}

TEST(BallBall, InOneDimensionIsAnInterval) {
  const Object a = at(Shape::ball, {0}, {1}, 2), b = at(Shape::ball, {10}, {0}, 1);
  const Object box_a = at(Shape::box, {0}, {1}, 2), box_b = at(Shape::box, {10}, {0}, 1);
  expect_span(contact(a, b, queried(100, 1)), 6, 14);
  expect_span(contact(box_a, box_b, queried(100, 1)), 6, 14);
}

TEST(BoxBall, TouchesTheFaceAndTheCornerOfTheBox) {
  const Object box = at(Shape::box, {0, 0}, {0, 0}, 1);
  expect_span(contact(box, at(Shape::ball, {5, 1}, {-1, 0}, 2), queried(100)), 2, 8);
  // Towards the corner (1, 1): the centre passes at (4, 5), which is 3 and 4 away.
  expect_span(contact(box, at(Shape::ball, {4, 6}, {0, -1}, 5), queried(1)), 1, 1);
  EXPECT_FALSE(contact(box, at(Shape::ball, {4, 6}, {0, -1}, 5), queried(0.999)));
}

TEST(BoxBall, EdgesAreRoundInThreeDimensions) {
  const Object box = at(Shape::box, {0, 0, 0}, {0, 0, 0}, 1);
  expect_span(contact(box, at(Shape::ball, {4, 6, 0.5}, {0, -1, 0}, 5), queried(1)), 1, 1);
  // Corner: 2, 3 and 6 away is 7.
  expect_span(contact(box, at(Shape::ball, {3, 4, 8}, {0, 0, -1}, 7), queried(1)), 1, 1);
}

TEST(BoxBall, WithinAroundABoxIsRoundForPoints) {
  const Object box = at(Shape::box, {0, 0}, {0, 0}, 1);
  EXPECT_TRUE(contact(box, at(Shape::point, {4, 5}, {0, 0}), queried(1, 5)));
  EXPECT_FALSE(contact(box, at(Shape::point, {4.5, 4.75}, {0, 0}), queried(1, 5)));
}

TEST(CylinderCylinder, NeedsBothDirections) {
  const Object a = at(Shape::cylinder, {0, 0, 0}, {0, 0, 1}, 3, 1),
               b = at(Shape::cylinder, {3, 4, 10}, {0, 0, 0}, 2, 2);
  expect_span(contact(a, b, queried(100)), 7, 13);
  expect_span(contact(a, b, queried(100, 0, 2)), 5, 15);
  EXPECT_FALSE(contact(a, at(Shape::cylinder, {3.01, 4, 10}, {0, 0, 0}, 2, 2), queried(100)));
  EXPECT_TRUE(contact(a, at(Shape::cylinder, {3.01, 4, 10}, {0, 0, 0}, 2, 2), queried(100, 1)));
}

TEST(CylinderCylinder, PointsWithWithinZ) {
  const Object a = at(Shape::point, {0, 0, 0}, {1, 0, 0}), b = at(Shape::point, {10, 0, 1000}, {0, 0, 0});
  expect_span(contact(a, b, queried(100, 5, 1000)), 5, 15);
  EXPECT_FALSE(contact(a, b, queried(100, 5, 999)));
}

TEST(CylinderBox, IsRoundInTheHorizontalOnly) {
  const Object box = at(Shape::box, {0, 0, 0}, {0, 0, 0}, 1);
  expect_span(contact(box, at(Shape::cylinder, {4, 6, 3}, {0, -1, 0}, 5, 2), queried(1)), 1, 1);
  EXPECT_FALSE(contact(box, at(Shape::cylinder, {4, 6, 3.5}, {0, -1, 0}, 5, 2), queried(1)));
  EXPECT_TRUE(contact(box, at(Shape::point, {1, 1, 6}, {0, 0, -1}), queried(2, 0, 3)));
}

TEST(Door, ErrorsNameTheTablesAndSayWhatToDo) {
  const Object cylinder = at(Shape::cylinder, {0, 0, 0}, {0, 0, 0}, 1, 1);
  const Object ball = at(Shape::ball, {0, 0, 0}, {0, 0, 0}, 1),
               flat = at(Shape::ball, {0, 0, 0}, {0, 0, 0}, 0);
  const Object box = at(Shape::box, {0, 0, 0}, {0, 0, 0}, 1), point = at(Shape::point, {0, 0, 0}, {0, 0, 0});
  EXPECT_THROW(contact(cylinder, ball, queried(1)), Error);
  EXPECT_THROW(contact(point, ball, queried(1, 1, 1)), Error);
  EXPECT_THROW(contact(cylinder, flat, queried(1)), Error);
  EXPECT_THROW(contact(point, flat, queried(1, 1, 1)), Error);
  EXPECT_THROW(contact(ball, ball, queried(1, 1, 1)), Error);
  EXPECT_THROW(contact(box, box, queried(1, 1, 1)), Error);
  EXPECT_THROW(contact(at(Shape::point, {0, 0}, {0, 0}), at(Shape::point, {0, 0}, {0, 0}), queried(1, 1, 1)),
               Error);
  try {
    contact(cylinder, ball, queried(1));
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("between a (cylinders) and b (balls"), std::string::npos);
  }
}

TEST(Door, ShapesOfALaterVersionAreRefused) {
  const double row[] = {0, 0};
  const Bodies points({.axes = 2}, row, 1);
  Bodies later = points;
  later.layout.shape = static_cast<Shape>(99);
  EXPECT_THROW(make_contact(points, later, queried(1), "a", "b"), Error);
  EXPECT_THROW(make_contact(later, points, queried(1, 1), "a", "b"), Error);
  const MovingWindow window({}, {.axes = 2}, 0);
  EXPECT_THROW(make_window_contact(window, later, {0, 1}), Error);
}

TEST(Answers, DoNotDependOnTheHostsRoundingMode) {
  const Object a = at(Shape::ball, {0.1, 0.2}, {1.3, 0.7}, 0.3),
               b = at(Shape::ball, {9.1, 5.3}, {-0.4, 0.1}, 1.9);
  const auto nearest = contact(a, b, queried(100));
  ASSERT_TRUE(nearest.has_value());
  for (int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const auto other = contact(a, b, queried(100));
    std::fesetround(FE_TONEAREST);
    ASSERT_TRUE(other.has_value());
    EXPECT_EQ(other->dt, nearest->dt);
    EXPECT_EQ(other->t_end, nearest->t_end);
  }
}

TEST(ClosestApproach, OfStraightCourses) {
  const Object a = at(Shape::point, {0, 3}, {1, 0}), b = at(Shape::point, {10, 0}, {0, 0});
  const ClosestApproach approach = closest(a, b, {.horizon = {5, 100}});
  EXPECT_EQ(approach.dt, 5);
  EXPECT_EQ(approach.t, 10);
  EXPECT_EQ(approach.d, 3);
}

TEST(ClosestApproach, IsNotBlurredByAFarHorizon) {
  // The two meet after a second; their positions after 1e308 seconds must not matter.
  const Object a = at(Shape::point, {0, 0}, {1, 0}), b = at(Shape::point, {1, 0}, {0, 0});
  const ClosestApproach approach = closest(a, b, {.horizon = {0, 1e308}});
  EXPECT_EQ(approach.dt, 1);
  EXPECT_EQ(approach.d, 0);
}

TEST(ClosestApproach, IsTheEarliestOnTies) {
  const Object a = at(Shape::point, {0, 3}, {1, 1}), b = at(Shape::point, {10, 0}, {1, 1});
  EXPECT_EQ(closest(a, b, {.horizon = {5, 100}}).dt, 0);
  // |x - 0| with x = t^2 - 4 t + 3 is 0 at 1 and at 3.
  Object swing = at(Shape::point, {3}, {-4});
  swing.a[0] = 2;
  const ClosestApproach twice = closest(swing, at(Shape::point, {0}, {0}), {.horizon = {0, 10}});
  EXPECT_EQ(twice.dt, 1);
  EXPECT_EQ(twice.d, 0);
}

TEST(ClosestApproach, KeepsItsDigitsInANearMiss) {
  // Closing at 2e4 from 1e9 away, they miss each other by 1e-3.
  const Object a = at(Shape::point, {-1e9, 0}, {1e4, 0}), b = at(Shape::point, {1e9, 1e-3}, {-1e4, 0});
  EXPECT_DOUBLE_EQ(closest(a, b, {.horizon = {0, 1e6}}).d, 1e-3);
  EXPECT_EQ(closest(a, b, {.horizon = {0, 1e6}}).dt, 1e5);
}

TEST(ClosestApproach, OfAcceleratedCoursesAgainstDenseStepping) {
  Object a = at(Shape::point, {1, 2, 3}, {-2, 1, 0.5}), b = at(Shape::point, {-5, 9, 4}, {1, -2, 0.25});
  a.a[0] = 0.7, a.a[1] = -0.3, b.a[1] = 0.45, b.a[2] = -0.2;
  const ClosestApproach approach = closest(a, b, {.horizon = {0, 20}});
  long double smallest = 1e9L, time = 0;
  for (int i = 0; i <= 2000000; ++i) {
    const long double s = i * 1e-5L;
    long double square = 0;
    for (int j = 0; j < 3; ++j) {
      const long double gap =
          (b.x[j] - a.x[j]) + s * (b.v[j] - a.v[j]) + s * s / 2 * ((long double)b.a[j] - a.a[j]);
      square += gap * gap;
    }
    if (square < smallest) smallest = square, time = s;
  }
  EXPECT_NEAR(approach.dt, static_cast<double>(time), 1e-5);
  EXPECT_NEAR(approach.d, static_cast<double>(std::sqrt(smallest)), 1e-9);
}

}  // namespace
}  // namespace foresee
