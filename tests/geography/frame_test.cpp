// Frames of tables: units of speed, origins as text, reports that lead to the plane and back, frames that conflict.
#include "geography/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenes.h"

namespace foresee {
namespace {

using testing::Random;

Frame degrees_about(const LatLon& origin, SpeedUnit unit = SpeedUnit::mps) {
  return {.kind = FrameKind::degrees, .origin = origin, .unit = unit};
}

double turn_between(double a, double b) {
  return std::abs(std::remainder(a - b, 360));
}

TEST(Frames, ConvertUnitsOfSpeed) {
  EXPECT_EQ(to_mps(14, SpeedUnit::knots), 14.0 * 1852 / 3600);
  EXPECT_EQ(to_mps(14, SpeedUnit::kmh), 14 / 3.6);
  EXPECT_EQ(to_mps(14, SpeedUnit::mps), 14);
  for (const SpeedUnit unit : {SpeedUnit::mps, SpeedUnit::knots, SpeedUnit::kmh}) {
    EXPECT_NEAR(from_mps(to_mps(13.7, unit), unit), 13.7, 1e-14);
    EXPECT_EQ(speed_unit_of(name_of(unit)), unit);
  }
  EXPECT_FALSE(speed_unit_of("kn"));
}

TEST(Frames, StoreTheBitsOfTheProjection) {
  const LatLon origin{53.9, 7.9}, place{53.99, 7.85};
  const Metres stored = degrees_about(origin, SpeedUnit::knots).to_metres({{place, Course{14, 91}}, 120, -2});
  const OnPlane expected = to_plane({place, Course{14.0 * 1852 / 3600, 91}}, origin);
  EXPECT_EQ(stored.x, (std::array{expected.x, expected.y, 120.0}));
  EXPECT_EQ(stored.motion->v, (std::array{(*expected.v)[0], (*expected.v)[1], -2.0}));
  EXPECT_EQ(stored.motion->a, (std::array<double, 3>{}));
  EXPECT_FALSE(degrees_about(origin).to_metres({{place, {}}}).motion);
}

/// Up to the greatest distance from origins anywhere, at places up to 89 degrees from the equator: within 1e-9 degrees
/// and 1e-9 m/s.
TEST(Frames, LeadBackToTheReport) {
  Random random(1);
  double place_error = 0, course_error = 0, speed_error = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto unit = static_cast<SpeedUnit>(i % 3);
    const LatLon origin{random.in(-85, 85), random.in(-180, 180)};
    const double distance = i % 2 == 0 ? std::pow(10, random.in(-3, 6.17)) : random.in(0, 1500e3);
    const LatLon place = geodesic_from(origin, random.in(0, 360), distance).place;
    if (std::abs(place.lat) > 89) continue;
    const Course course{random.in(0, 60), random.in(0, 360)};
    const Frame frame = degrees_about(origin, unit);
    const Fix back = frame.shown(frame.to_metres({{place, course}})).fix;
    place_error = std::max(
        {place_error, std::abs(back.place.lat - place.lat), turn_between(back.place.lon, place.lon)});
    course_error = std::max(course_error, turn_between(back.course->degrees, course.degrees));
    speed_error = std::max(speed_error, std::abs(back.course->speed - course.speed));
    EXPECT_GE(back.course->degrees, 0);
    EXPECT_LT(back.course->degrees, 360);
  }
  EXPECT_LT(place_error, 1e-9);
  EXPECT_LT(course_error, 1e-9);
  EXPECT_LT(speed_error, 1e-9);
}

/// Reports have few decimals: these come back as they were, also due north and on the 180th meridian.
TEST(Frames, ReadReportsBackAsTheyWereWritten) {
  Random random(2);
  for (int i = 0; i < 4000; ++i) {
    const LatLon origin{std::round(random.in(-700, 700)) / 10, std::round(random.in(-1799, 1799)) / 10};
    const double degrees = i % 3 == 0 ? 1 : 0.05;  // some kilometres from the origin digits are lost
    const LatLon place{std::round((origin.lat + random.in(-degrees, degrees)) * 1e5) / 1e5,
                       std::round((origin.lon + random.in(-degrees, degrees)) * 1e5) / 1e5};
    const double speed = random.in(1, 300), fast = random.in(1, 2000);
    const Course course{i % 5 == 0 ? std::round(fast * 1e9) / 1e9 : std::round(speed) / 10,
                        std::round(random.in(0, 3599)) / 10};
    if (std::abs(place.lon) > 180) continue;
    const Frame frame = degrees_about(origin, SpeedUnit::knots);
    const Fix back = frame.shown(frame.to_metres({{place, i % 4 == 0 ? Course{12.5, 0} : course}})).fix;
    EXPECT_EQ(back.place.lat, place.lat) << i;
    EXPECT_EQ(back.place.lon, place.lon) << i;
    EXPECT_EQ(back.course->speed, i % 4 == 0 ? 12.5 : course.speed) << i;
    EXPECT_EQ(back.course->degrees, i % 4 == 0 ? 0 : course.degrees) << i;
  }
  for (const double lon : {180.0, -180.0}) {
    const Frame frame = degrees_about({10, 179.9});
    EXPECT_EQ(frame.shown(frame.to_metres({{{10, lon}, {}}})).fix.place.lon, 180);
  }
}

TEST(Frames, ShowWhatMovesAsMoving) {
  const Frame frame = degrees_about({50, 8});
  const Fix slow = frame.shown(frame.to_metres({{{50, 8}, Course{1e-13, 45}}})).fix;
  EXPECT_GT(slow.course->speed, 0);
  const Fix still = frame.shown({{1, 2}, OnGlobe::Motion{}}).fix;
  EXPECT_EQ(still.course->speed, 0);
  EXPECT_TRUE(std::isnan(still.course->degrees));
}

/// Anywhere on the Earth, at heights up to 10,000 km: within 1e-9 degrees, 1e-9 m/s and 1e-7 m. Close
/// to a pole a degree of longitude is short.
TEST(Frames, LeadBackFromTheGlobe) {
  Random random(6);
  double place_error = 0, course_error = 0, speed_error = 0, height_error = 0, climb_error = 0;
  for (int i = 0; i < 20000; ++i) {
    const Frame frame{.kind = FrameKind::globe, .unit = static_cast<SpeedUnit>(i % 3)};
    const double lat = i % 5 == 0 ? 90 - std::pow(10, random.in(-2, 1)) : random.in(-90, 90);
    const Flight flight{{{lat, random.in(-180, 180)}, Course{random.in(0, 300), random.in(0, 360)}},
                        i % 4 == 0 ? std::pow(10, random.in(0, 7)) : random.in(-100, 20000),
                        random.in(-20, 20)};
    const Flight back = frame.shown(frame.to_metres(flight));
    const double shrink = std::cos(lat * 3.14159265358979323846 / 180);
    place_error = std::max({place_error, std::abs(back.fix.place.lat - lat),
                            shrink * turn_between(back.fix.place.lon, flight.fix.place.lon)});
    const double turned = turn_between(back.fix.course->degrees, flight.fix.course->degrees);
    course_error = std::max(course_error, shrink * turned);
    speed_error = std::max(speed_error, std::abs(back.fix.course->speed - flight.fix.course->speed));
    height_error = std::max(height_error, std::abs(back.height - flight.height));
    climb_error = std::max(climb_error, std::abs(back.climb - flight.climb));
  }
  EXPECT_LT(place_error, 1e-11);
  EXPECT_LT(course_error, 1e-9);
  EXPECT_LT(speed_error, 1e-9);
  EXPECT_LT(height_error, 1e-7);
  EXPECT_LT(climb_error, 1e-9);
}

/// The bits of to_globe; an object at rest climbs alone.
TEST(Frames, StoreTheGlobe) {
  const Frame frame{.kind = FrameKind::globe, .unit = SpeedUnit::knots};
  const Metres stored = frame.to_metres({{{50, 8.6}, Course{480, 270}}, 11000, 3});
  const OnGlobe expected = to_globe({{{50, 8.6}, Course{480.0 * 1852 / 3600, 270}}, 11000, 3});
  EXPECT_EQ(stored.x, expected.x);
  EXPECT_EQ(stored.motion->v, expected.motion->v);
  EXPECT_EQ(stored.motion->a, expected.motion->a);
  const Metres rising = frame.to_metres({{{50, 8.6}, {}}, 11000, 3});
  EXPECT_EQ(rising.motion->v, to_globe({{{50, 8.6}, Course{0, 0}}, 11000, 3}).motion->v);
  const Flight shown = frame.shown(rising);
  EXPECT_EQ(shown.fix.course->speed, 0);
  EXPECT_TRUE(std::isnan(shown.fix.course->degrees));
  EXPECT_EQ(shown.height, 11000);
  EXPECT_EQ(shown.climb, 3);
  EXPECT_FALSE(frame.to_metres({{{50, 8.6}, {}}}).motion);
  EXPECT_EQ(frame.shown(frame.to_metres({{{-90, 55}, Course{3, 10}}})).fix.place.lat, -90);
}

TEST(Frames, ReadOriginsFromText) {
  EXPECT_EQ(origin_text({53.9, 7.9}), "53.9 7.9");
  EXPECT_EQ(parse_origin("53.9 7.9")->lat, 53.9);
  EXPECT_EQ(parse_origin("-90 -180")->lon, -180);
  for (const char* text : {"", " ", "53.9", "53.9 ", " 7.9", "53.9  7.9", "53.9,7.9", "53.9 7.9 1", "91 0",
                           "0 181", "nan 0", "0 inf", "1e999 0", "0x1 2", "53.9 7.9x", "globe"})
    EXPECT_FALSE(parse_origin(text)) << text;
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const LatLon place{random.in(-90, 90), random.in(-180, 180)};
    EXPECT_EQ(parse_origin(origin_text(place))->lat, place.lat);
    EXPECT_EQ(parse_origin(origin_text(place))->lon, place.lon);
  }
  EXPECT_EQ(origin_text(origin_near({53.949, -7.951})), "53.9 -8");
  EXPECT_EQ(origin_text(origin_near({-0.04, 0.04})), "0 0");
  EXPECT_EQ(origin_text(origin_near({90, -180})), "90 180");
  EXPECT_EQ(origin_text(origin_near({-17, -179.97})), "-17 180");
  EXPECT_EQ(origin_text(origin_near({-17, -179.94})), "-17 -179.9");
}

TEST(Frames, ConflictUnlessTheirMetresAreTheSame) {
  const Frame plain, harbour{.text = "harbour"}, yard{.text = "o'yard"},
      a = degrees_about({53.9, 7.9}), b = degrees_about({54, 8}, SpeedUnit::knots),
      a_in_knots = degrees_about({53.9, 7.9}, SpeedUnit::knots), unknown{.kind = FrameKind::degrees};
  const auto conflict = [](const Frame& x, const Frame& y) { return frame_conflict("ships", x, "zones", y); };
  EXPECT_EQ(conflict(plain, plain), "");
  EXPECT_EQ(conflict(harbour, harbour), "");
  EXPECT_EQ(conflict(a, a_in_knots), "");
  EXPECT_EQ(conflict(a, unknown), "");
  EXPECT_EQ(conflict(unknown, b), "");
  EXPECT_EQ(conflict(unknown, unknown), "");
  EXPECT_EQ(conflict(a, plain),
            "ships has lat, lon, zones has x, y: their coordinates do not match; create zones with lat, lon "
            "and origin "
            "= '53.9 7.9'");
  EXPECT_EQ(conflict(harbour, b),
            "zones has lat, lon, ships has x, y: their coordinates do not match; create ships with lat, lon "
            "and origin "
            "= '54 8'");
  EXPECT_EQ(conflict(unknown, plain),
            "ships has lat, lon, zones has x, y: their coordinates do not match; create zones with lat, lon "
            "and an origin");
  EXPECT_EQ(conflict(a, b),
            "ships has origin '53.9 7.9', zones has '54 8': their coordinates do not match; create zones "
            "with origin = "
            "'53.9 7.9'");
  const Frame globe{.kind = FrameKind::globe},
      globe_in_knots{.kind = FrameKind::globe, .unit = SpeedUnit::knots};
  EXPECT_EQ(conflict(globe, globe_in_knots), "");
  EXPECT_EQ(conflict(globe, plain),
            "ships has lat, lon, zones has x, y: their coordinates do not match; create zones with lat, lon "
            "and origin "
            "= globe");
  EXPECT_EQ(conflict(globe, a),
            "ships has origin globe, zones has '53.9 7.9': their coordinates do not match; create zones with "
            "origin = "
            "globe");
  EXPECT_EQ(conflict(unknown, globe),
            "ships has origin none, zones has globe: their coordinates do not match; create ships with "
            "origin = globe");
  EXPECT_EQ(conflict(harbour, yard),
            "ships has frame 'harbour', zones has 'o''yard': their coordinates do not match; create zones "
            "with frame = "
            "'harbour'");
  EXPECT_EQ(conflict(plain, yard),
            "ships has frame none, zones has 'o''yard': their coordinates do not match; create ships with "
            "frame = 'o''yard'");
  EXPECT_EQ(conflict(yard, plain),
            "ships has frame 'o''yard', zones has none: their coordinates do not match; create zones with "
            "frame = 'o''yard'");
}

TEST(Frames, HaveNames) {
  EXPECT_EQ(Frame{}.name(), "plane");
  EXPECT_EQ((Frame{.text = "harbour"}).name(), "harbour");
  EXPECT_EQ(degrees_about({1, 2}).name(), "degrees");
  EXPECT_EQ((Frame{.kind = FrameKind::globe}).name(), "globe");
  EXPECT_FALSE((Frame{.kind = FrameKind::globe}) == (Frame{.kind = FrameKind::degrees}));
  EXPECT_TRUE(degrees_about({1, 2}) == degrees_about({1, 2}));
  EXPECT_FALSE(degrees_about({1, 2}) == degrees_about({1, 3}));
  EXPECT_FALSE(degrees_about({1, 2}) == Frame{});
}

}  // namespace
}  // namespace foresee
