// Geocentric coordinates: places against the formula in long doubles, velocities and accelerations against
// integrated geodesics.
#include "geography/globe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <regex>

#include "base/error.h"
#include "geography/geodesic_by_steps.h"
#include "scenes.h"

namespace foresee {
namespace {

using testing::Random;

double off(const std::array<double, 3>& a, const Point& b) {
  Real square = 0;
  for (std::size_t i = 0; i < 3; ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return static_cast<double>(std::sqrt(square));
}

TEST(Globe, PutsPlacesOnTheEllipsoid) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const LatLon place{random.in(-90, 90), random.in(-400, 400)};
    EXPECT_LT(off(to_globe({{place, {}}}).x, on_ellipsoid(place)), 3e-9) << i;
  }
  EXPECT_EQ(to_globe({{{0, 0}, {}}, 10}).x, (std::array<double, 3>{6378147, 0, 0}));
  EXPECT_NEAR(to_globe({{{90, 77}, {}}}).x[2], static_cast<double>(axis_b), 1e-9);
}

/// As the header says: 0.001 m after 6 km, 0.19 m after 36 km, 7 m after 120 km.
TEST(Globe, AStraightCourseIsCloseToItsGeodesic) {
  Random random(2);
  double farthest[3] = {0, 0, 0};
  const double lengths[3] = {6000, 36000, 120000}, allowed[3] = {0.0012, 0.2, 7.2};
  for (int i = 0; i < 40; ++i) {
    const LatLon place{random.in(-85, 85), random.in(-180, 180)};
    const double course = random.in(0, 360), speed = 10;
    const OnGlobe point = to_globe({{place, Course{speed, course}}});
    for (int k = 0; k < 3; ++k) {
      const double t = lengths[k] / speed;
      std::array<double, 3> then;
      for (std::size_t j = 0; j < 3; ++j)
        then[j] = point.x[j] + t * point.motion->v[j] + t * t / 2 * point.motion->a[j];
      farthest[k] = std::max(farthest[k], off(then, on_ellipsoid(walked(place, course, lengths[k]).place)));
    }
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_LT(farthest[k], allowed[k]);
    EXPECT_GT(farthest[k], allowed[k] / 2);
  }
}

/// The cells of the table of degrees.md whose rows start with a number of minutes or hours.
std::vector<std::array<std::string, 5>> drift_of_the_page() {
  std::ifstream page(FORESEE_SOURCE_DIR "/docs/reference/degrees.md");
  const std::regex row(R"(\| (\d+ (?:minutes?|hours?)) \| ([^|]+) \| ([^|]+) \| ([^|]+) \| ([^|]+) \|)");
  std::vector<std::array<std::string, 5>> rows;
  std::smatch cells;
  for (std::string line; std::getline(page, line);)
    if (std::regex_match(line, cells, row))
      rows.push_back({cells[1], cells[2], cells[3], cells[4], cells[5]});
  return rows;
}

/// "5.7 m" in metres, and half a unit of its last digit that is not 0, up to the second digit.
std::pair<double, double> printed(const std::string& text) {
  const std::size_t space = text.find(' ');
  const std::string digits = text.substr(0, space), unit = text.substr(space + 1);
  const double scale = unit == "mm" ? 1e-3 : unit == "km" ? 1e3 : 1, value = std::stod(digits);
  const std::size_t point = digits.find('.');
  const double last = point == std::string::npos ? 1 : std::pow(10, -double(digits.size() - point - 1));
  return {value * scale, std::max(last, std::pow(10, std::floor(std::log10(value)) - 1)) / 2 * scale};
}

/// The length on the ground of a path with this speed at its height, which starts at 0 and grows at `climb`.
double length_on_ground(const LatLon& place, double course, double speed, double climb, double t) {
  if (climb == 0) return speed * t;
  const double sine = std::sin(course / double(radian)), lat = std::sin(place.lat / double(radian));
  const double e2 = 1 - static_cast<double>(axis_b * axis_b / (axis_a * axis_a)), flat = 1 - e2 * lat * lat;
  const double across = static_cast<double>(axis_a) / std::sqrt(flat), along = across * (1 - e2) / flat;
  const double radius = 1 / (sine * sine / across + (1 - sine * sine) / along);
  return speed * radius / climb * std::log1p(climb * t / radius);
}

/// The largest distance of some straight paths from their geodesics after `t`, and the largest error of the height.
std::pair<double, double> drift(double speed, double climb, double t) {
  Random random(4);
  double distance = 0, height = 0;
  for (int i = 0; i < 40; ++i) {
    const LatLon place{random.in(-85, 85), random.in(-180, 180)};
    const double course = random.in(0, 360);
    const OnGlobe point = to_globe({{place, Course{speed, course}}, 0, climb});
    std::array<double, 3> then;
    for (std::size_t j = 0; j < 3; ++j)
      then[j] = point.x[j] + t * point.motion->v[j] + t * t / 2 * point.motion->a[j];
    const LatLon there = walked(place, course, length_on_ground(place, course, speed, climb, t)).place;
    const Real lat = there.lat / radian, lon = there.lon / radian;
    const Point up{std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
    distance = std::max(distance, off(then, sum(on_ellipsoid(there), climb * t, up)));
    height = std::max(height, from_globe({then, {}}).height - climb * t);
  }
  return {distance, height};
}

TEST(Globe, APathLeavesItsGeodesicAsThePageSays) {
  const auto rows = drift_of_the_page();
  ASSERT_EQ(rows.size(), 5U);
  for (const auto& [after, ship, flight, height, climbing] : rows) {
    const double t = std::stod(after) * (after.find("hour") == std::string::npos ? 60 : 3600);
    const auto [flight_drift, flight_height] = drift(250, 0, t);
    std::vector<std::pair<std::string, double>> cells = {
        {ship, drift(20 * 1852.0 / 3600, 0, t).first}, {flight, flight_drift}, {height, flight_height}};
    if (climbing != "–") cells.emplace_back(climbing, drift(250, 10, t).first);
    for (const auto& [text, measured] : cells) {
      const auto [value, half_a_unit] = printed(text);
      EXPECT_NEAR(measured, value, half_a_unit) << after << ": " << text;
    }
  }
}

/// How far apart two paths are after `t`: that of a report of the age `age`, and that of a new report from its place.
double apart_after_a_new_report(double speed, double age, double t) {
  Random random(5);
  double largest = 0;
  for (int i = 0; i < 40; ++i) {
    const LatLon place{random.in(-85, 85), random.in(-180, 180)};
    const OnGlobe old = to_globe({{place, Course{speed, random.in(0, 360)}}});
    const auto at = [](const OnGlobe& point, double time) {
      OnGlobe then = point;
      for (std::size_t j = 0; j < 3; ++j) {
        then.x[j] += time * point.motion->v[j] + time * time / 2 * point.motion->a[j];
        then.motion->v[j] += time * point.motion->a[j];
      }
      return then;
    };
    const OnGlobe proven = at(old, age + t), stored = at(to_globe(from_globe(at(old, age))), t);
    largest = std::max(largest, off(proven.x, {stored.x[0], stored.x[1], stored.x[2]}));
  }
  return largest;
}

/// The figures of predictive_avoid.md, "Writing the change back".
TEST(Globe, AFreshReportLeavesTheProvenPathAsThePageSays) {
  const double radius = 6371e3, knots = 1852.0 / 3600;
  for (const auto& [speed, figure] : {std::pair(250.0, 95.0), std::pair(20 * knots, 7e-3)}) {
    const double apart = apart_after_a_new_report(speed, 600, 900);
    EXPECT_NEAR(apart, figure, figure / 14) << speed;
    EXPECT_NEAR(apart, std::pow(speed, 3) * 600 * 900 * 900 / (2 * radius * radius), apart / 30) << speed;
    EXPECT_LT(apart_after_a_new_report(speed, 0, 900), 1e-6) << speed;
  }
}

TEST(Globe, LeadsBackToTheReport) {
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    const LatLon place{i % 7 == 0 ? std::copysign(90 - std::pow(10, random.in(-9, 0)), random.in(-1, 1))
                                  : random.in(-90, 90),
                       random.in(-180, 180)};
    const Course course{random.in(0.5, 300), random.in(0, 360)};
    const double height = random.in(-11000, i % 2 == 0 ? 15000 : 4e7), climb = random.in(-10, 10);
    const Flight back = from_globe(to_globe({{place, course}, height, climb}));
    const double scale = 1 + std::abs(height) / 6.4e6;
    EXPECT_NEAR(metres_between(back.fix.place, place), 0, 4e-9 * scale) << i;
    EXPECT_NEAR(back.height, height, 4e-9 * scale) << i;
    EXPECT_NEAR(back.fix.course->speed, course.speed, 1e-9 * course.speed) << i;
    EXPECT_NEAR(back.climb, climb, 1e-6) << i;
    EXPECT_NEAR(std::remainder(back.fix.course->degrees - course.degrees, 360) * std::cos(place.lat / 57.3),
                0, 1e-8)
        << i;
  }
}

TEST(Globe, VerticalMotionHasNoCourse) {
  Random random(4);
  for (int i = 0; i < 4000; ++i) {
    const LatLon place{i % 7 == 0 ? 90 - std::pow(10, random.in(-9, 0)) : random.in(-90, 90),
                       random.in(-180, 180)};
    const double height = random.in(-11000, i % 2 == 0 ? 15000 : 4e7), climb = random.in(-10, 10);
    const Flight back = from_globe(to_globe({{place, Course{0, 90}}, height, climb}));
    EXPECT_EQ(back.fix.course->speed, 0) << place.lat << ' ' << place.lon << ' ' << height << ' ' << climb;
    EXPECT_TRUE(std::isnan(back.fix.course->degrees)) << i;
  }
  EXPECT_EQ(from_globe(to_globe({{{0, 0}, Course{1e-12, 90}}, 0, 100})).fix.course->degrees, 90);
}

TEST(Globe, AtThePoleHasAHeight) {
  const Flight flight = from_globe({{0, 0, 6400000}, {}});
  EXPECT_EQ(flight.fix.place.lat, 90);
  EXPECT_NEAR(flight.height, 6400000 - static_cast<double>(axis_b), 1e-8);
}

TEST(Globe, HasNoHeightAtItsCentre) {
  EXPECT_THROW(from_globe({{0, 0, 0}, {}}), Error);
  EXPECT_THROW(from_globe({{1e4, 1e4, -1e4}, {}}), Error);
}

}  // namespace
}  // namespace foresee
