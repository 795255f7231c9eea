// Zones in longitude and latitude: their corners on the plane, the date line, poles, and what is refused.
#include "geography/zone.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "geography/plane.h"
#include "scenes.h"
#include "shape/outline/validity.h"
#include "shape/outline/wkt.h"

namespace foresee {
namespace {

using testing::Random;

Zone read_zone(std::string_view text, const LatLon& origin) {
  NeverInterrupt never;
  return foresee::read_zone(text, origin, never);
}

std::string error_of(const std::string& text, const LatLon& origin = {53.9, 7.9}) {
  try {
    read_zone(text, origin);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// The even-odd rule on the plane.
bool holds(const Outline& outline, double x, double y) {
  bool inside = false;
  for (std::size_t r = 0; r < outline.rings(); ++r) {
    const auto ring = outline.ring(r);
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      if ((ring[i].y > y) != (ring[j].y > y) &&
          x < (ring[j].x - ring[i].x) * (y - ring[i].y) / (ring[j].y - ring[i].y) + ring[i].x)
        inside = !inside;
  }
  return inside;
}

bool holds(const Outline& plane, const LatLon& place, const LatLon& origin) {
  const OnPlane point = to_plane({place, {}}, origin);
  return holds(plane, point.x, point.y);
}

TEST(Zone, HasTheCornersOfThePlane) {
  const LatLon origin{53.9, 7.9};
  const Zone zone = read_zone(
      "SRID=4326;multipolygon(((7.8 53.9, 8 53.9, 7.9 54, 7.8 53.9),"
      "(7.88 53.93, 7.92 53.93, 7.9 53.95, 7.88 53.93)), ((8.1 54, 8.2 54, 8.1 54.1, 8.1 54)))",
      origin);
  EXPECT_EQ(zone.plane.parts(), 2);
  EXPECT_EQ(zone.plane.rings(), 3);
  ASSERT_EQ(zone.plane.corners().size(), 9);
  for (std::size_t i = 0; i < 9; ++i) {
    const Corner corner = zone.degrees.corners()[i];
    const OnPlane point = to_plane({{corner.y, corner.x}, {}}, origin);
    EXPECT_EQ(zone.plane.corners()[i], (Corner{point.x, point.y})) << i;
  }
  EXPECT_EQ(
      write_outline(zone.degrees),
      "MULTIPOLYGON(((7.8 53.9, 8 53.9, 7.9 54, 7.8 53.9), (7.88 53.93, 7.92 53.93, 7.9 53.95, 7.88 53.93)), "
      "((8.1 54, 8.2 54, 8.1 54.1, 8.1 54)))");
}

/// Corners of the plane lie on the geodesics, and every chord within a metre of one.
TEST(Zone, IsBetweenGeodesics) {
  const LatLon origin{50, 0};
  const Zone zone = read_zone("POLYGON((-10 45, 10 45, 12 55, -12 55, -10 45))", origin);
  EXPECT_GT(zone.plane.corners().size(), 50);
  const auto corners = zone.degrees.corners();
  for (std::size_t i = 0; i < 4; ++i) {
    const LatLon a{corners[i].y, corners[i].x}, b{corners[(i + 1) % 4].y, corners[(i + 1) % 4].x};
    const Geodesic line = geodesic_between(a, b);
    for (int step = 1; step < 2000; ++step) {
      const GeodesicEnd at = geodesic_from(a, line.azimuth, line.distance * step / 2000);
      // Left of the ring's direction is inside: a metre and a half to either side decides.
      EXPECT_TRUE(holds(zone.plane, geodesic_from(at.place, at.azimuth - 90, 1.01).place, origin))
          << i << ' ' << step;
      EXPECT_FALSE(holds(zone.plane, geodesic_from(at.place, at.azimuth + 90, 1.01).place, origin))
          << i << ' ' << step;
    }
  }
}

TEST(Zone, CrossesTheDateLine) {
  const LatLon origin{-18, 179.5};
  for (const char* text : {"POLYGON((178 -19, -179 -19, -179 -17, 178 -17, 178 -19))",
                           "POLYGON((178 -17, 178 -19, -179 -19, -179 -17, 178 -17))"}) {
    const Zone zone = read_zone(text, origin);
    EXPECT_TRUE(holds(zone.plane, {-18, 179}, origin));
    EXPECT_TRUE(holds(zone.plane, {-18, 180}, origin));
    EXPECT_TRUE(holds(zone.plane, {-18, -179.5}, origin));
    EXPECT_FALSE(holds(zone.plane, {-18, -178.5}, origin));
    EXPECT_FALSE(holds(zone.plane, {-18, 177.5}, origin));
  }
  const Zone touches = read_zone("POLYGON((-180 -18, 180 -19, 179 -18.5, -180 -18))", origin);
  EXPECT_EQ(touches.plane, read_zone("POLYGON((180 -18, 180 -19, 179 -18.5, 180 -18))", origin).plane);
}

TEST(Zone, HoldsAPole) {
  const LatLon origin{88, 40};
  const Zone cap = read_zone("POLYGON((0 80, 60 80, 120 80, 180 80, -120 80, -60 80, 0 80))", origin);
  EXPECT_TRUE(holds(cap.plane, {90, 0}, origin));
  EXPECT_TRUE(holds(cap.plane, {85, 200}, origin));
  EXPECT_FALSE(holds(cap.plane, {79, 30}, origin));
  // Repeated notations of the pole are one corner.
  const Zone lune = read_zone("POLYGON((0 80, 60 80, 60 90, 0 90, 0 80))", origin);
  EXPECT_TRUE(holds(lune.plane, {85, 30}, origin));
  EXPECT_FALSE(holds(lune.plane, {85, 70}, origin));
  EXPECT_EQ(lune.plane, read_zone("POLYGON((0 80, 60 80, 17 90, 0 80))", origin).plane);
  const Zone ends = read_zone("POLYGON((-180 90, 0 80, 60 80, 180 90, -180 90))", origin);
  EXPECT_TRUE(holds(ends.plane, {85, 30}, origin));
}

/// Zones of random corners: places are inside as the angles around them on the Earth say.
TEST(Zone, IsTheRegionOfRandomPolygons) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const LatLon origin{i % 4 == 0 ? 89.5 : random.in(-89, 89), i % 3 == 0 ? 180 : random.in(-180, 180)};
    const LatLon middle = geodesic_from(origin, random.in(0, 360), random.in(0, 9e5)).place;
    std::string text = "POLYGON((";
    std::vector<LatLon> corners;
    for (int j = 0; j < 7; ++j) {
      corners.push_back(geodesic_from(middle, j * 360.0 / 7, random.in(1e4, 5e5)).place);
      text += shown(Corner{corners.back().lon, corners.back().lat}) + ", ";
    }
    text += shown(Corner{corners[0].lon, corners[0].lat}) + "))";
    const Zone zone = read_zone(text, origin);
    EXPECT_FALSE(flaw_of(zone.plane)) << text;
    EXPECT_TRUE(holds(zone.plane, middle, origin)) << text;
    for (int j = 0; j < 7; ++j) {
      const double out = geodesic_between(middle, corners[j]).distance;
      EXPECT_TRUE(holds(zone.plane, geodesic_from(middle, j * 360.0 / 7, out - 3).place, origin)) << text;
      EXPECT_FALSE(holds(zone.plane, geodesic_from(middle, j * 360.0 / 7, out + 3).place, origin)) << text;
    }
  }
}

TEST(Zone, SaysWhatIsWrong) {
  EXPECT_EQ(error_of("POLYGON((7.8 153, 8 53.9, 7.9 54, 7.8 153))"),
            "corner (7.8 153) has latitude 153, beyond 90; write longitude, then latitude");
  EXPECT_EQ(error_of("POLYGON((187.8 53, 8 53.9, 7.9 54, 187.8 53))"),
            "corner (187.8 53) has longitude 187.8, beyond 180; write -172.2");
  EXPECT_EQ(
      error_of("POLYGON((53.9 7.8, 53.9 8, 54 7.9, 53.9 7.8))"),
      "corner (53.9 7.8) is 6554 km from the origin '53.9 7.9'; write longitude first, and an origin within "
      "1500 km");
  EXPECT_EQ(error_of("POLYGON((-180 70, 180 70, 180 75, -180 75, -180 70))", {72, 180}),
            "edge (-180 70, 180 70) has no length: edges are shortest lines; write corners between its ends");
  EXPECT_EQ(
      error_of(
          "MULTIPOLYGON(((178 -19, 180 -19, 180 -17, 178 -17, 178 -19)), ((-180 -19, -179 -19, -179 -17, "
          "-180 -17, -180 -19)))",
          {-18, 180}),
      "parts meet along the date line; write them as one polygon that passes from 179 to -179");
  EXPECT_EQ(error_of("POLYGON((0 90, 60 90, 120 90, 0 90))", {85, 0}), "ring 1 has fewer than three corners");
  EXPECT_EQ(error_of("POLYGON((7 53, 9 54, 9 53, 7 54, 7 53))"), "edges (7 53, 9 54) and (9 53, 7 54) cross");
  EXPECT_EQ(error_of("POLYGON((7 53, 9 53, 8 54, 7 55, 8 54, 7 53))"),
            "edges (8 54, 7 55) and (7 55, 8 54) overlap");
  EXPECT_EQ(error_of("POLYGON((7 53, 8 53.5, 7 54, 9 54, 8 53.5, 9 53, 7 53))"),
            "ring 1 touches itself at (8 53.5): write a ring for each loop");
  EXPECT_EQ(error_of("POLYGON((7 53, 9 53, 8 54, 7 53), (1 53, 2 53, 2 54, 1 53))"),
            "ring 2 is a hole but lies outside its part");
  EXPECT_EQ(error_of("SRID=32632;POLYGON((7 53, 9 53, 8 54, 7 53))"),
            "at character 6: SRID 32632 is not 4326, longitude and latitude: transform it first");
  EXPECT_EQ(error_of("TIN Z(((7 53 0, 8 53 0, 8 54 0, 7 53 0)))"),
            "at character 1: expected POLYGON or MULTIPOLYGON, found 'TIN'");
  EXPECT_EQ(error_of("POLYGON EMPTY"), "at character 9: EMPTY is no zone: leave it out");
  EXPECT_EQ(error_of("POINT(7 53)"), "at character 1: expected POLYGON or MULTIPOLYGON, found 'POINT'");
  EXPECT_EQ(error_of("POLYGON((7 53, 9 53, 8 54))"),
            "ring 1 is not closed: write the first corner (7 53) again at its end");
}

/// Long edges far from the origin become many corners: too many are refused, not cut off.
TEST(Zone, HasALimitOfCorners) {
  std::string text = "POLYGON((";
  const LatLon origin{0, 0};
  for (int i = 0; i < 4000; ++i)  // a comb of edges 1,000 km long
    text += shown(Corner{-5 + i * 0.00225, i / 2 % 2 == 0 ? -4.0 : 5.0}) + ", ";
  text += "4 -8, -5 -8, -5 -4))";
  EXPECT_EQ(
      error_of(text, origin),
      "more than 65536 corners, with those that keep long edges straight on the Earth: simplify the zone");
}

TEST(Zone, CanBeInterrupted) {
  struct AtOnce final : Interrupt {
    void check() override { throw Interrupted(); }
  } at_once;
  std::string text = "POLYGON((-9 -5, 9 -5";
  for (int i = 0; i < 1000; ++i) text += ", " + shown(Corner{9 - i * 0.01, i % 2 == 0 ? 5.0 : 4.0});
  EXPECT_THROW(foresee::read_zone(text + ", -9 -5))", {0, 0}, at_once), Interrupted);
}

}  // namespace
}  // namespace foresee
