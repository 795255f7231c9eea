// The projection to a plane: distances and bearings from the origin, velocities against differences of
// places.
#include "geography/plane.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "geography/geodesic_by_steps.h"
#include "scenes.h"

namespace foresee {
namespace {

using testing::Random;

double degrees_between(double a, double b) {
  return std::abs(std::remainder(a - b, 360));
}

TEST(Plane, KeepsDistanceAndBearingFromItsOrigin) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const LatLon origin{random.in(-90, 90), random.in(-200, 200)},
        place{random.in(-90, 90), random.in(-200, 200)};
    const OnPlane point = to_plane({place, {}}, origin);
    const Geodesic line = geodesic_between(origin, place);
    EXPECT_NEAR(std::hypot(point.x, point.y), line.distance, 1e-8) << i;
    EXPECT_NEAR(std::remainder(std::atan2(point.x, point.y) * 57.29577951308232 - line.azimuth, 360), 0,
                1e-12)
        << i;
    EXPECT_FALSE(point.v) << i;
  }
}

/// A velocity is the difference of the places a little later and a little earlier, both integrated in long
/// doubles.
TEST(Plane, VelocityIsWhatDifferencesOfPlacesShow) {
  Random random(2);
  for (int i = 0; i < 60; ++i) {
    const LatLon origin{random.in(-80, 80), random.in(-180, 180)};
    const double distance = i % 10 == 0 ? 0 : std::pow(10, random.in(0, i % 3 == 0 ? 6.8 : 5.5));
    const LatLon place = geodesic_from(origin, random.in(0, 360), distance).place;
    const double course = random.in(-360, 720), speed = random.in(0.1, 30), step = 100;
    const OnPlane point = to_plane({place, Course{speed, course}}, origin);
    // Richardson's two differences leave an error of the fourth order.
    const auto difference = [&](double metres, double OnPlane::*part) {
      const OnPlane ahead = to_plane({walked(place, course, metres).place, {}}, origin);
      const OnPlane behind = to_plane({walked(place, course, -metres).place, {}}, origin);
      return speed * (ahead.*part - behind.*part) / (2 * metres);
    };
    for (const auto part : {&OnPlane::x, &OnPlane::y}) {
      const double slope = (4 * difference(step, part) - difference(2 * step, part)) / 3;
      EXPECT_NEAR((*point.v)[part == &OnPlane::y], slope, 2e-9 * speed) << i << ' ' << distance;
    }
  }
}

TEST(Plane, LeadsBackToTheReport) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const LatLon origin{random.in(-90, 90), random.in(-180, 180)};
    const double distance = std::pow(10, random.in(-2, 7.2)), azimuth = random.in(0, 360);
    const LatLon place = geodesic_from(origin, azimuth, distance).place;
    const Course course{random.in(0.5, 30), random.in(0, 360)};
    const Fix back = from_plane(to_plane({place, course}, origin), origin);
    EXPECT_NEAR(metres_between(back.place, place), 0, 1e-8) << i;
    EXPECT_NEAR(back.course->speed, course.speed, 1e-9 * course.speed) << i;
    // A course is measured from north, which turns quickly near a pole.
    EXPECT_NEAR(degrees_between(back.course->degrees, course.degrees) * std::cos(place.lat / 57.3), 0, 1e-8)
        << i << ' ' << distance;
  }
}

TEST(Plane, AtItsOriginIsTheGround) {
  const OnPlane north = to_plane({{30, -90.5}, Course{10, 0}}, {30, -90.5});
  EXPECT_EQ(north.x, 0);
  EXPECT_EQ(north.y, 0);
  EXPECT_EQ((*north.v)[0], 0);
  EXPECT_EQ((*north.v)[1], 10);
  const OnPlane west = to_plane({{30, -90.5}, Course{10, 270}}, {30, 269.5});
  EXPECT_EQ((*west.v)[0], -10);
  EXPECT_NEAR((*west.v)[1], 0, 1e-15);
}

TEST(Plane, KnowsCoursesOfAnySize) {
  const LatLon origin{54, 8}, place{54.3, 8.4};
  const OnPlane zero = to_plane({place, Course{5, 0}}, origin),
                full = to_plane({place, Course{5, 360}}, origin);
  EXPECT_EQ(zero.v, full.v);
}

TEST(Plane, AnObjectAtRestHasNoCourse) {
  const Fix fix = from_plane({1000, 2000, {{0, 0}}}, {54, 8});
  EXPECT_EQ(fix.course->speed, 0);
  EXPECT_TRUE(std::isnan(fix.course->degrees));
}

TEST(Plane, EndsAtTheOtherSideOfTheEarth) {
  EXPECT_THROW(to_plane({{-30, 89.5}, Course{1, 2}}, {30, -90.5}), Error);
  EXPECT_NO_THROW(to_plane({{-30, 89.5}, {}}, {30, -90.5}));
  EXPECT_THROW(from_plane({2.1e7, 0, {}}, {30, -90.5}), Error);
}

}  // namespace
}  // namespace foresee
