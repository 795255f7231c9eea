// Conversions from degrees to metres and back, where formulas divide by zero. Cases: poles and their
// neighbourhood, the date line, places opposite the origin, and speeds at either end of a double's range.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "geography/geodesic_by_steps.h"
#include "geography/globe.h"
#include "geography/plane.h"
#include "scenes.h"

namespace foresee {
namespace {

using testing::Random;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

double any_latitude(Random& random) {
  const double sign = random.below(2) == 0 ? 1 : -1;
  switch (random.below(6)) {
    case 0:
      return sign * 90;
    case 1:
      return sign * (90 - std::pow(10, random.in(-14, -1)));
    case 2:
      return sign * std::pow(10, random.in(-15, 0));
    case 3:
      return 0;
    default:
      return random.in(-90, 90);
  }
}

double any_longitude(Random& random) {
  switch (random.below(6)) {
    case 0:
      return 15.0 * static_cast<double>(random.below(25)) - 180;
    case 1:
      return std::copysign(180 - std::pow(10, random.in(-14, 0)), random.in(-1, 1));
    case 2:
      return random.in(-1e6, 1e6);
    default:
      return random.in(-180, 180);
  }
}

LatLon any_place(Random& random, const LatLon& origin) {
  if (random.below(4) == 0)
    return geodesic_from(origin, random.in(0, 360), std::pow(10, random.in(-6, 7.3))).place;
  if (random.below(8) == 0) return {-origin.lat, origin.lon + 180 - random.in(0, 1)};
  return {any_latitude(random), any_longitude(random)};
}

/// Compares velocities in space, which do not depend on a convention for the longitude of a pole.
double off(const Fix& a, const Fix& b) {
  const auto va = to_globe({a}).motion->v, vb = to_globe({b}).motion->v;
  return std::hypot(va[0] - vb[0], va[1] - vb[1], va[2] - vb[2]);
}

/// Nothing where no plane about the origin holds a velocity.
OnPlane on_plane(const Fix& fix, const LatLon& origin) try {
  return to_plane(fix, origin);
} catch (const Error&) {
  return to_plane({fix.place, {}}, origin);
}

TEST(RoundTrip, ByThePlaneOfEveryOrigin) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const LatLon origin{any_latitude(random), any_longitude(random)}, place = any_place(random, origin);
    const Course course{random.in(0.5, 30), static_cast<double>(random.below(8)) * 45};
    const OnPlane point = on_plane({place, course}, origin);
    const Fix back = from_plane(point, origin);
    ASSERT_LT(metres_between(back.place, place), 3e-8) << origin.lat << ' ' << place.lat << ' ' << i;
    ASSERT_TRUE(back.place.lon >= -180 && back.place.lon <= 180) << back.place.lon;
    if (std::abs(place.lat) < 89) {
      ASSERT_NEAR(back.place.lat, place.lat, 1e-9) << origin.lat << ' ' << i;
      ASSERT_NEAR(std::remainder(back.place.lon - place.lon, 360), 0, 1e-9) << origin.lat << ' ' << i;
    }
    if (!point.v) continue;
    ASSERT_TRUE(back.course->degrees >= 0 && back.course->degrees < 360) << back.course->degrees;
    ASSERT_NEAR(back.course->speed, course.speed, 1e-9 * course.speed) << i;
    ASSERT_LT(off(back, {place, course}), 1e-9 * course.speed) << origin.lat << ' ' << place.lat << ' ' << i;
  }
}

TEST(RoundTrip, APoleIsAnOriginLikeAnyOther) {
  for (const double pole : {90.0, -90.0})
    for (const double lon0 : {0.0, 30.0, -170.0, 180.0})
      for (const double lat : {80.0, -80.0, 0.0, 90.0, -90.0, 89.999999})
        for (const double lon : {120.0, -120.0, 0.0, 180.0, 30.0}) {
          const Fix back = from_plane(to_plane({{lat, lon}, {}}, {pole, lon0}), {pole, lon0});
          EXPECT_NEAR(back.place.lat, lat, 1e-9);
          const double wrong = std::remainder(back.place.lon - lon, 360) * std::cos(lat / 57.29577951308232);
          EXPECT_NEAR(wrong, 0, 1e-9) << pole << ' ' << lon0 << ' ' << lat << ' ' << lon;
        }
  const Fix origin = from_plane({0, 0, {{0, 5}}}, {90, 30});
  EXPECT_EQ(origin.place.lat, 90);
  EXPECT_EQ(origin.place.lon, 30);
  EXPECT_EQ(origin.course->degrees, 0);
}

TEST(RoundTrip, LongitudesAtThePolesMayBeOfAnySize) {
  const OnPlane point = to_plane({{90, 1.7e308}, Course{5, 0}}, {90, -1.7e308});
  EXPECT_NEAR(std::hypot((*point.v)[0], (*point.v)[1]), 5, 1e-12);
}

TEST(RoundTrip, WhereTheGeodesicsOfTheEquatorMeetThereIsNoVelocity) {
  const double meeting = 180 * (1 - 1 / 298.257223563);
  EXPECT_THROW(to_plane({{0, meeting}, Course{5, 0}}, {0, 0}), Error);
  EXPECT_NO_THROW(to_plane({{0, meeting}, {}}, {0, 0}));
  EXPECT_NO_THROW(to_plane({{0, meeting - 0.01}, Course{5, 0}}, {0, 0}));
}

TEST(RoundTrip, CoursesAreBelow360AndNeverMinusZero) {
  for (const double x : {0.0, -0.0, -1e-10, -1e-5, 1e-10})
    for (const double y : {0.0, 100.0, -100.0, 1e6})
      for (const double vx : {0.0, -0.0, -1e-17, 1e-17, -1e-300})
        for (const double vy : {1.0, -1.0})
          for (const double lat0 : {0.0, 54.0, -54.0, 90.0, -90.0}) {
            const double course = from_plane({x, y, {{vx, vy}}}, {lat0, 8}).course->degrees;
            EXPECT_TRUE(course >= 0 && course < 360 && !std::signbit(course)) << course;
          }
}

TEST(RoundTrip, OfSpeedsOfAnySize) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const LatLon origin{any_latitude(random), any_longitude(random)}, place{random.in(-89, 89), 7};
    const Course one{1, random.in(0, 360)};
    const double height = random.in(-1e4, 1e5);
    const OnPlane point = on_plane({place, one}, origin);
    const OnGlobe flight = to_globe({{place, one}, height, 0.5});
    for (const double scale : {0x1p900, 0x1p-900}) {
      const Course course{scale, one.degrees};
      if (point.v) {
        const OnPlane scaled = to_plane({place, course}, origin);
        EXPECT_EQ((*scaled.v)[0], scale * (*point.v)[0]);
        EXPECT_EQ((*scaled.v)[1], scale * (*point.v)[1]);
        EXPECT_NEAR(from_plane(scaled, origin).course->speed / scale, 1, 1e-9);
      }
      const double slow = std::sqrt(scale);  // its acceleration is of its square
      const OnGlobe flying = to_globe({{place, Course{slow, one.degrees}}, height, 0.5 * slow});
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(flying.motion->v[k], slow * flight.motion->v[k]);
        EXPECT_EQ(flying.motion->a[k], scale * flight.motion->a[k]);
      }
      EXPECT_NEAR(from_globe(flying).fix.course->speed / slow, 1, 1e-9);
    }
  }
}

TEST(RoundTrip, AVelocityIsFiniteWhereADoubleHoldsIt) {
  // At 10 N 170 E the plane about 0, 0 is stretched by about five across.
  const LatLon place{10, 170}, origin{0, 0};
  EXPECT_THROW(to_plane({place, Course{1.79e308, 0}}, origin), Error);
  const OnPlane fits = to_plane({place, Course{0.1 * largest, 0}}, origin),
                one = to_plane({place, Course{0.1, 0}}, origin);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_NEAR((*fits.v)[k] / largest, (*one.v)[k], 1e-15 * std::abs((*one.v)[k]));
  // Across it is more than a double holds, along x and y it is not.
  const GeodesicEnd end = geodesic_from(origin, 45, 1e7);
  const OnPlane diagonal = to_plane({end.place, Course{0.8 * largest, end.azimuth + 90}}, origin);
  EXPECT_GT(std::hypot(0.5 * (*diagonal.v)[0], 0.5 * (*diagonal.v)[1]), 0.6 * largest);
  EXPECT_TRUE(std::isfinite((*diagonal.v)[0]) && std::isfinite((*diagonal.v)[1]));
  EXPECT_EQ((*to_plane({origin, Course{largest, 90}}, origin).v)[0], largest);
  EXPECT_EQ((*to_plane({origin, Course{smallest, 90}}, origin).v)[0], smallest);
  EXPECT_EQ(from_plane({0, 0, {{largest, 0}}}, origin).course->speed, largest);
  EXPECT_EQ(from_plane({0, 0, {{0, -smallest}}}, origin).course->degrees, 180);
  EXPECT_THROW(from_plane({0, 0, {{0.9 * largest, 0.9 * largest}}}, origin), Error);
}

TEST(RoundTrip, OnTheGlobeIsFiniteWhereADoubleHoldsIt) {
  const OnGlobe fast = to_globe({{{0, 0}, Course{1e157, 90}}});
  EXPECT_NEAR(fast.motion->a[0] / (-1e157 / 6378137 * 1e157), 1, 1e-12);
  EXPECT_THROW(to_globe({{{0, 0}, Course{1e160, 90}}}), Error);
  EXPECT_THROW(to_globe({{{0, 0}, {}}, -6378137}), Error);
  EXPECT_THROW(to_globe({{{0, 0}, Course{1, 2}}, -1e7}), Error);
  EXPECT_EQ(to_globe({{{0, 0}, {}}, 1.7e308}).x[0], 1.7e308);
  EXPECT_THROW(from_globe({{1.7e308, 1.7e308, 0}, {}}), Error);
  EXPECT_EQ(from_globe({{1.7e308, 0, 0}, {}}).height, 1.7e308);
  const Flight flight = from_globe({{6.4e6, 0, 0}, OnGlobe::Motion{{0, 0.5 * largest, 0.5 * largest}, {}}});
  EXPECT_NEAR(flight.fix.course->speed / largest, std::sqrt(0.5), 1e-15);
  EXPECT_THROW(from_globe({{6.4e6, 0, 0}, OnGlobe::Motion{{0, largest, largest}, {}}}), Error);
}

TEST(RoundTrip, OnTheAxisThereIsOneLongitude) {
  for (const double x : {0.0, -0.0})
    for (const double y : {0.0, -0.0}) {
      const Flight flight = from_globe({{x, y, 6.4e6}, OnGlobe::Motion{{-1, 0, 0}, {}}});
      EXPECT_EQ(flight.fix.place.lon, 0);
      EXPECT_EQ(flight.fix.course->degrees, 0) << x << ' ' << y;
    }
  const Flight beside = from_globe({{smallest, smallest, 6.4e6}, OnGlobe::Motion{{1, 0, 0}, {}}});
  EXPECT_NEAR(beside.fix.course->speed, 1, 1e-15);
}

}  // namespace
}  // namespace foresee
