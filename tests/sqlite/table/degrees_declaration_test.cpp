// CREATE VIRTUAL TABLE with lat, lon, and the options of frames: the meaning of each declaration, each refusal.
#include <gtest/gtest.h>

#include "base/error.h"
#include "format/features.h"
#include "sqlite/table/table_declaration.h"
#include "storage/rows/shadow_schema.h"

namespace foresee {
namespace {

using Arguments = std::vector<std::string_view>;

std::string refusal_of(const Arguments& arguments, std::string_view table = "ships") {
  try {
    parse_declaration(table, arguments);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

void expect_refusals(const std::vector<std::pair<Arguments, std::string>>& cases) {
  for (const auto& [arguments, error] : cases) {
    EXPECT_EQ(refusal_of(arguments), "ships: " + error);
    EXPECT_LE(("ships: " + error).size(), 160u);
  }
}

TEST(DeclareDegrees, HaveTheLayoutOfThePlane) {
  const Declaration ships =
      parse_declaration("ships", {"id", "t", "LAT", "lon", "z", "Speed", "course", "vz", "r", "+name TEXT",
                                  "ORIGIN = '53.9 -7.9'", "speed_unit = KNOTS", "horizon = 600"});
  EXPECT_EQ(ships.layout, (Layout{.axes = 3, .law = Law::uniform, .shape = Shape::ball, .has_t = true}));
  EXPECT_TRUE(ships.frame.in_degrees());
  EXPECT_EQ(ships.frame.origin->lat, 53.9);
  EXPECT_EQ(ships.frame.origin->lon, -7.9);
  EXPECT_EQ(ships.frame.unit, SpeedUnit::knots);
  EXPECT_EQ(ships.horizon, 600);
  EXPECT_EQ(ships.columns[1].name, "lat");
  EXPECT_EQ(ships.columns[1].geo, GeoColumn::lat);
  EXPECT_EQ(ships.columns[1].place, record_offsets(ships.layout).x);
  EXPECT_EQ(ships.columns[5].geo, GeoColumn::course);
  EXPECT_EQ(ships.columns[5].place, record_offsets(ships.layout).v + 1);
  EXPECT_EQ(ships.columns[3].geo, GeoColumn::none);
  EXPECT_EQ(declared_schema(ships, "ships"),
            "CREATE TABLE x(id INTEGER PRIMARY KEY, \"t\" REAL, \"lat\" REAL, \"lon\" REAL, \"z\" REAL, "
            "\"speed\" REAL, "
            "\"course\" REAL, \"vz\" REAL, \"r\" REAL, \"name\" TEXT, \"ships\" HIDDEN, x REAL HIDDEN, y "
            "REAL HIDDEN, "
            "vx REAL HIDDEN, vy REAL HIDDEN)");
  EXPECT_EQ(describe_columns(ships), "id, t, lat, lon, z, speed, course, vz, r, +name");
  EXPECT_EQ(features_of(ships), "blocks,degrees");
}

TEST(DeclareDegrees, TakeEveryShape) {
  for (const Arguments& arguments :
       {Arguments{"id", "lat", "lon"}, Arguments{"id", "lat", "lon", "hx", "hy"},
        Arguments{"id", "shape", "lat", "lon"}, Arguments{"id", "until", "lat", "t", "lon", "r", "growth"},
        Arguments{"id", "lat", "lon", "z", "r", "hz"}, Arguments{"id", "lat", "lon", "z", "shape", "heading"},
        Arguments{"id", "z", "lat", "lon"}})
    EXPECT_EQ(refusal_of(arguments), "");
  const Declaration zones = parse_declaration("zones", {"id", "lat", "lon", "r"});
  EXPECT_EQ(declared_schema(zones, "zones"),
            "CREATE TABLE x(id INTEGER PRIMARY KEY, \"lat\" REAL, \"lon\" REAL, \"r\" REAL, \"zones\" "
            "HIDDEN, x REAL "
            "HIDDEN, y REAL HIDDEN)");
  EXPECT_FALSE(zones.frame.origin);
  EXPECT_EQ(zones.frame.unit, SpeedUnit::mps);
}

TEST(DeclareDegrees, PlainTablesMayNameTheirFrame) {
  const Declaration named = parse_declaration("ships", {"id", "x", "frame = 'it''s mine'"});
  EXPECT_EQ(named.frame.text, "it's mine");
  EXPECT_EQ(features_of(named), "blocks,frame");
  EXPECT_EQ(parse_declaration("ships", {"id", "x", "frame = harbour"}).frame.text, "harbour");
  EXPECT_EQ(features_of(parse_declaration("ships", {"id", "x"})), "blocks");
}

/// Three axes with or without z, the curvature as acceleration, discs as balls.
TEST(DeclareGlobe, HasTheLayoutOfTheGlobe) {
  const Declaration ships = parse_declaration(
      "ships", {"id", "t", "lat", "lon", "speed", "course", "r", "origin = GLOBE", "speed_unit = knots"});
  EXPECT_EQ(ships.layout, (Layout{.axes = 3, .law = Law::accelerated, .shape = Shape::ball, .has_t = true}));
  EXPECT_TRUE(ships.frame.on_globe());
  EXPECT_FALSE(ships.frame.origin);
  EXPECT_EQ(describe_columns(ships), "id, t, lat, lon, speed, course, r");
  EXPECT_EQ(features_of(ships), "blocks,globe");
  EXPECT_EQ(declared_schema(ships, "ships"),
            "CREATE TABLE x(id INTEGER PRIMARY KEY, \"t\" REAL, \"lat\" REAL, \"lon\" REAL, \"speed\" REAL, "
            "\"course\" REAL, \"r\" REAL, \"ships\" HIDDEN, gx REAL HIDDEN, gy REAL HIDDEN, gz REAL HIDDEN, "
            "gvx REAL HIDDEN, gvy REAL HIDDEN, gvz REAL HIDDEN, gax REAL HIDDEN, gay REAL HIDDEN, gaz REAL "
            "HIDDEN)");
  const Declaration flights = parse_declaration(
      "flights", {"id", "lat", "lon", "z", "speed", "course", "vz", "until", "category", "origin = globe"});
  EXPECT_EQ(flights.layout.axes, 3);
  EXPECT_EQ(flights.layout.law, Law::accelerated);
  EXPECT_EQ(flights.columns[2].geo, GeoColumn::height);
  EXPECT_EQ(flights.columns[5].geo, GeoColumn::climb);
  EXPECT_EQ(describe_columns(flights), "id, lat, lon, z, speed, course, vz, until, category");
  const Declaration buoys = parse_declaration("buoys", {"id", "lat", "lon", "growth", "origin = globe"});
  EXPECT_EQ(buoys.layout.law, Law::rest);
  EXPECT_EQ(buoys.layout.shape, Shape::ball);
  EXPECT_EQ(hidden_columns(buoys).size(), 3u);
}

TEST(DeclareGlobe, Refuses) {
  const auto no_up = [](const std::string& word) {
    return '"' + word +
           "\": no axis of the globe points up, so a table on the globe has points and balls (r) only; "
           "leave " +
           word + " out, or write origin = 'LAT LON'";
  };
  const std::string_view globe = "origin = globe";
  expect_refusals({
      {{"id", "lat", "lon", "z", "r", "hz", globe}, no_up("hz")},
      {{"id", "lat", "lon", "hx", "hy", globe}, no_up("hx")},
      {{"id", "lat", "lon", "shape", globe}, no_up("shape")},
      {{"id", "lat", "lon", "heading", globe}, no_up("heading")},
      {{"id", "lat", "lon", "z", "growth", "growth_z", globe}, no_up("growth_z")},
      {{"id", "zone", globe},
       "\"origin = globe\": zones lie on a plane; write an origin within 1500 km, as in origin = '53.9 7.9'"},
      {{"id", "x", "y", globe},
       "\"origin = globe\": origin is for tables in degrees; write lat, lon in place of x, y, or leave it "
       "out"},
      {{"id", "lat", "lon", globe, "origin = '1 2'"},
       "\"origin = '1 2'\": origin is given twice; leave one out"},
      {{"id", "lat", "lon", "frame = a", globe},
       "\"frame = a\": the frame of a table with lat, lon is its origin; leave frame out"},
      {{"id", "lat", "lon", "x", globe},
       "\"x\": a table with lat, lon has lat instead, and gx as a hidden column to read; leave it out"},
      {{"id", "lat", "lon", "speed", "course", "ax", globe},
       "\"ax\": the acceleration on the globe is its curvature; leave it out, or use x, y, z and "
       "geo_to_globe"},
      {{"id", "lat", "lon", "z", "speed", "course", globe},
       "\"speed\": velocity is declared for all axes or none; add vz"},
      {{"id", "lat", "lon", "speed", "course", "+GAZ", globe},
       "\"+GAZ\": a table with lat, lon has a hidden column GAZ already; choose another name"},
  });
}

TEST(DeclareDegreesErrors, Columns) {
  const std::string no_acceleration =
      ": an acceleration would follow the axes of the plane, not east and north; leave it out, or use x, y "
      "and geo_to_plane";
  expect_refusals({
      {{"id", "lat"}, "\"lat\": lat, lon go together; add lon"},
      {{"id", "lon REAL", "r"}, "\"lon REAL\": lat, lon go together; add lat"},
      {{"id", "lon", "lat"}, "\"lon\": lat comes before lon; write lat, lon"},
      {{"id", "lat", "lon", "course"}, "\"course\": speed, course go together; add speed"},
      {{"id", "lat", "lon", "course", "speed"}, "\"course\": speed comes before course; write speed, course"},
      {{"id", "x", "y", "speed", "course"},
       "\"speed\": speed, course go with lat, lon; write lat, lon in place of x, y, or vx, vy in place of "
       "these two"},
      {{"id", "x", "y", "course"},
       "\"course\": speed, course go with lat, lon; write lat, lon in place of x, y, or vx, vy in place of "
       "these two"},
      {{"id", "lat", "lon", "x"},
       "\"x\": a table with lat, lon has lat instead, and x as a hidden column to read; leave it out"},
      {{"id", "y", "lat", "lon"},
       "\"y\": a table with lat, lon has lon instead, and y as a hidden column to read; leave it out"},
      {{"id", "lat", "lon", "vx", "vy"},
       "\"vx\": a table with lat, lon has speed instead, and vx as a hidden column to read; leave it "
       "out"},
      {{"id", "lat", "lon", "speed", "course", "ax", "ay"}, "\"ax\"" + no_acceleration},
      {{"id", "lat", "lon", "speed", "course", "fx", "fy", "m"}, "\"fx\"" + no_acceleration},
      {{"id", "lat", "lon", "z", "az"}, "\"az\"" + no_acceleration},
      {{"id", "lat", "lon", "m"}, "\"m\"" + no_acceleration},
      {{"id", "lat", "lon", "z", "speed", "course"},
       "\"speed\": velocity is declared for all axes or none; add vz"},
      {{"id", "lat", "lon", "z", "vz"},
       "\"vz\": velocity is declared for all axes or none; add speed, course"},
      {{"id", "lat", "lon", "vz"}, "\"vz\": there is no axis z; add z or leave vz out"},
      {{"id", "lat", "lon", "lat"}, "\"lat\": a column named lat is declared already; choose another name"},
      {{"id", "lat", "lon", "+x"},
       "\"+x\": a table with lat, lon has a hidden column x already; choose another name"},
      {{"id", "+VY", "lat"}, "\"lat\": motion columns come before the auxiliary columns; move it before +VY"},
  });
  EXPECT_EQ(refusal_of({"id", "lat", "lon", "+vx"}), "") << "nothing moves, so it has no hidden vx";
  EXPECT_EQ(refusal_of({"id", "lat", "lon", "speed", "course", "+VY"}),
            "ships: \"+VY\": a table with lat, lon has a hidden column VY already; choose another name");
  EXPECT_EQ(refusal_of({"id", "lat", "lon"}, "Y").substr(0, 29), "Y: a table cannot be named li");
  EXPECT_EQ(refusal_of({"id", "lat", "lon"}, "lat").substr(0, 31), "lat: a table cannot be named li");
}

TEST(DeclareDegreesErrors, Options) {
  const std::string origin =
      ": an origin is a latitude within 90 and a longitude within 180 degrees, or globe; write for example "
      "origin = '53.9 7.9'";
  for (const std::string_view option :
       {"origin = 5", "origin = '91 8'", "origin = '54 -181'", "origin = '54, 8'", "origin = ''",
        "origin = 54 8 0", "origin =", "origin = '54 8 0'", "origin = 'nan 8'"})
    EXPECT_EQ(refusal_of({"id", "lat", "lon", option}), "ships: \"" + std::string(option) + "\"" + origin);
  const std::string unit =
      ": no such unit; known: mps (the default), knots and kmh, as in speed_unit = knots";
  for (const std::string_view option : {"speed_unit = kn", "speed_unit = m/s", "speed_unit ="})
    EXPECT_EQ(refusal_of({"id", "lat", "lon", option}), "ships: \"" + std::string(option) + "\"" + unit);
  const std::string own = ": plane, degrees and globe are foresee's own frames; write another text";
  for (const std::string_view option : {"frame = plane", "frame = 'DEGREES'", "frame = globe"})
    EXPECT_EQ(refusal_of({"id", "x", option}), "ships: \"" + std::string(option) + "\"" + own);
  expect_refusals({
      {{"id", "x", "frame = ''"}, "\"frame = ''\": the text is empty; write for example frame = 'harbour'"},
      {{"id", "x", "frame = a", "frame = b"}, "\"frame = b\": frame is given twice; leave one out"},
      {{"id", "lat", "lon", "frame = a"},
       "\"frame = a\": the frame of a table with lat, lon is its origin; leave frame out"},
      {{"id", "lat", "lon", "origin = '1 2'", "origin = '1 2'"},
       "\"origin = '1 2'\": origin is given twice; leave one out"},
      {{"id", "x", "origin = '1 2'"},
       "\"origin = '1 2'\": origin is for tables in degrees; write lat, lon in place of x, y, or leave it "
       "out"},
      {{"id", "x", "speed_unit = mps"},
       "\"speed_unit = mps\": speed_unit is for tables in degrees; write lat, lon in place of x, y, or leave "
       "it out"},
  });
}

}  // namespace
}  // namespace foresee
