// CREATE VIRTUAL TABLE: the meaning of each declaration, and the error of each wrong one.
#include "sqlite/table/table_declaration.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.h"

namespace foresee {
namespace {

using Arguments = std::vector<std::string_view>;

std::string error_of(const Arguments& arguments, std::string_view table = "ships") {
  try {
    parse_declaration(table, arguments);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

Layout layout_of(const Arguments& arguments) {
  return parse_declaration("ships", arguments).layout;
}

TEST(Declare, TheExamplesOfTheReference) {
  const Declaration ships = parse_declaration("ships", {"id", "t", "x", "y", "vx", "vy", "r", "+name TEXT"});
  EXPECT_EQ(
      ships.layout,
      (Layout{.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true, .has_until = false}));
  ASSERT_EQ(ships.auxiliaries.size(), 1u);
  EXPECT_EQ(ships.auxiliaries[0].name, "name");
  EXPECT_EQ(ships.auxiliaries[0].type, "TEXT");
  EXPECT_EQ(ships.horizon, 60);
  EXPECT_EQ(
      layout_of({"id", "t", "x", "y", "z", "vx", "vy", "vz", "ax", "ay", "az", "hx", "hy", "hz"}),
      (Layout{.axes = 3, .law = Law::accelerated, .shape = Shape::box, .has_t = true, .has_until = false}));
  EXPECT_EQ(layout_of({"id", "x", "y", "hx", "hy"}),
            (Layout{.axes = 2, .law = Law::rest, .shape = Shape::box, .has_t = false, .has_until = false}));
}

TEST(Declare, EveryLawAndShape) {
  EXPECT_EQ(layout_of({"id", "x"}).law, Law::rest);
  EXPECT_EQ(layout_of({"id", "x"}).shape, Shape::point);
  EXPECT_EQ(layout_of({"id", "x", "vx"}).law, Law::uniform);
  EXPECT_EQ(layout_of({"id", "x", "vx", "ax"}).law, Law::accelerated);
  EXPECT_EQ(layout_of({"id", "x", "ax"}).law, Law::accelerated) << "from rest";
  EXPECT_EQ(layout_of({"id", "x", "vx", "fx", "m"}).law, Law::forced);
  EXPECT_EQ(layout_of({"id", "x", "r"}).shape, Shape::ball);
  EXPECT_EQ(layout_of({"id", "x", "y", "z", "r"}).shape, Shape::ball);
  EXPECT_EQ(layout_of({"id", "x", "y", "z", "r", "hz"}).shape, Shape::cylinder);
  EXPECT_EQ(layout_of({"id", "x", "y", "z", "hx", "hy", "hz"}).shape, Shape::box);
  EXPECT_TRUE(layout_of({"id", "x", "until"}).has_until);
}

TEST(Declare, ColumnsStandInAnyOrderAfterTheId) {
  const Declaration d = parse_declaration("ships", {"ID", "until", "VY", "Y", "r", "X", "vx", "T"});
  const Offsets at = record_offsets(d.layout);
  const std::vector<std::pair<std::string, int>> expected = {
      {"until", at.until}, {"vy", at.v + 1}, {"y", at.x + 1}, {"r", at.r},
      {"x", at.x},         {"vx", at.v},     {"t", at.t}};
  ASSERT_EQ(d.columns.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(d.columns[i].name, expected[i].first);
    EXPECT_EQ(d.columns[i].place, expected[i].second) << expected[i].first;
  }
}

TEST(Declare, EveryColumnHasItsOwnPosition) {
  for (const Arguments& arguments :
       {Arguments{"id", "t", "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz", "m", "hx", "hy", "hz",
                  "until"},
        Arguments{"id", "t", "x", "y", "z", "vx", "vy", "vz", "ax", "ay", "az", "r", "hz", "until"}}) {
    const Declaration d = parse_declaration("ships", arguments);
    std::vector<int> taken(static_cast<std::size_t>(record_offsets(d.layout).size), 0);
    for (const MotionColumn& column : d.columns) ++taken.at(static_cast<std::size_t>(column.place));
    for (int times : taken) EXPECT_EQ(times, 1);
  }
}

TEST(Declare, NamesMayBeQuotedAndTyped) {
  const Declaration d = parse_declaration(
      "ships", {"\"id\" INTEGER PRIMARY KEY", "[x] REAL", "`y` double precision", "'vx' FLOAT",
                "vy /* north */ REAL", "+\"full \"\"name\"\"\" VARCHAR(20, 2) COLLATE NOCASE", "+ plain"});
  EXPECT_EQ(d.columns.size(), 4u);
  EXPECT_EQ(d.auxiliaries[0].name, "full \"name\"");
  EXPECT_EQ(d.auxiliaries[0].type, "VARCHAR(20,2) COLLATE NOCASE");
  EXPECT_EQ(d.auxiliaries[1].name, "plain");
  EXPECT_EQ(d.auxiliaries[1].type, "");
}

TEST(Declare, HorizonIsAnOptionAnywhereAfterTheId) {
  EXPECT_EQ(parse_declaration("ships", {"id", "x", "horizon = 600"}).horizon, 600);
  EXPECT_EQ(parse_declaration("ships", {"id", "HORIZON=1.5e-3", "x"}).horizon, 1.5e-3);
  EXPECT_EQ(parse_declaration("ships", {"id", "x", "+n", "horizon = '.25'"}).horizon, 0.25);
}

TEST(Declare, TheSchemaHasTheColumnsInTheirOrderAndTheCommandColumn) {
  const Declaration d = parse_declaration("my \"ships\"", {"id", "y", "x", "+name TEXT", "+\"a b\""});
  EXPECT_EQ(declared_schema(d, "my \"ships\""),
            "CREATE TABLE x(id INTEGER PRIMARY KEY, \"y\" REAL, \"x\" REAL, \"name\" TEXT, \"a b\" , "
            "\"my \"\"ships\"\"\" HIDDEN)");
}

struct Wrong {
  Arguments arguments;
  std::string message;
};

void expect_errors(const std::vector<Wrong>& cases) {
  for (const Wrong& wrong : cases) EXPECT_EQ(error_of(wrong.arguments), "ships: " + wrong.message);
}

TEST(DeclareErrors, IdAndPosition) {
  expect_errors({
      {{}, "no columns are declared; write for example moving_objects(id, t, x, y, vx, vy, r)"},
      {{"x", "y"}, "\"x\": the first column must be id; write moving_objects(id, ...)"},
      {{"mmsi", "x"},
       "\"mmsi\": the first column is the key and must be called id; write id in place of mmsi"},
      {{"+id", "x"}, "\"+id\": the first column must be id; write moving_objects(id, ...)"},
      {{"id TEXT", "x"}, "\"id TEXT\": the id is an INTEGER PRIMARY KEY; write id"},
      {{"id"},
       "no position is declared; add x (and y, z for two or three axes), as in moving_objects(id, x, y, vx, "
       "vy)"},
      {{"id", "vx"},
       "no position is declared; add x (and y, z for two or three axes), as in moving_objects(id, x, y, vx, "
       "vy)"},
      {{"id", "y"}, "\"y\": there is no x; axes are declared in the order x, y, z"},
      {{"id", "x", "z"}, "\"z\": there is no y; axes are declared in the order x, y, z"},
      {{"id", "x", "id"}, "\"id\": id is declared twice; leave this one out"},
  });
}

TEST(DeclareErrors, AxesAndHalves) {
  expect_errors({
      {{"id", "x", "y", "vx"}, "\"vx\": velocity is declared for all axes or none; add vy"},
      {{"id", "x", "y", "z", "vy REAL"},
       "\"vy REAL\": velocity is declared for all axes or none; add vx, vz"},
      {{"id", "x", "vx", "vy"}, "\"vy\": there is no axis y; add y or leave vy out"},
      {{"id", "x", "y", "vx", "vy", "vz"}, "\"vz\": there is no axis z; add z or leave vz out"},
      {{"id", "x", "y", "vx", "vy", "ay"}, "\"ay\": acceleration is declared for all axes or none; add ax"},
      {{"id", "x", "y", "fx", "m"}, "\"fx\": force is declared for all axes or none; add fy"},
      {{"id", "x", "y", "hx"}, "\"hx\": half extent is declared for all axes or none; add hy"},
      {{"id", "x", "y", "r", "hz"}, "\"hz\": there is no axis z; add z or leave hz out"},
  });
}

TEST(DeclareErrors, MixturesOfLaws) {
  expect_errors({
      {{"id", "x", "y", "ax", "ay", "fx", "fy", "m"},
       "\"fx\": a table has either acceleration (ax, ay) or force and mass (fx, fy, m); leave one out"},
      {{"id", "x", "vx", "fx"}, "\"fx\": a force needs a mass; add m"},
      {{"id", "x", "y", "vx", "vy", "m"}, "\"m\": a mass needs a force; add fx, fy or leave m out"},
      {{"id", "x", "ax", "m"}, "\"m\": a mass goes with a force (fx), not with an acceleration; leave m out"},
  });
}

TEST(DeclareErrors, MixturesOfShapes) {
  expect_errors({
      {{"id", "x", "y", "r", "hx", "hy"},
       "\"r\": a shape is either a box (hx, hy) or round (r); leave one out"},
      {{"id", "x", "y", "z", "hx", "hy", "hz", "r"},
       "\"r\": a shape is either a box (hx, hy, hz) or round (r, or r and hz for an upright cylinder); leave "
       "one out"},
      {{"id", "x", "y", "z", "hz"},
       "\"hz\": hz alone is no shape; add hx, hy for a box, r for an upright cylinder, or shape for a prism"},
      {{"id", "x", "y", "z", "hy", "hz"}, "\"hy\": half extent is declared for all axes or none; add hx"},
  });
}

TEST(Declare, AGrowingObjectHasAShape) {
  const auto layout = [](const Arguments& arguments) { return parse_declaration("ships", arguments).layout; };
  for (const Arguments& arguments : {Arguments{"id", "x", "growth"}, Arguments{"id", "x", "y", "growth"},
                                     Arguments{"id", "x", "y", "z", "growth"}}) {
    EXPECT_EQ(layout(arguments).shape, Shape::ball);
    EXPECT_TRUE(layout(arguments).starts_as_point);
    EXPECT_EQ(record_offsets(layout(arguments)).size, layout(arguments).axes + 1);  // no r is stored
  }
  EXPECT_FALSE(layout({"id", "x", "y", "r", "growth"}).starts_as_point);
  EXPECT_EQ(layout({"id", "x", "y", "hx", "hy", "growth"}).shape, Shape::box);
  EXPECT_EQ(layout({"id", "x", "y", "shape", "growth"}).shape, Shape::outline);
  EXPECT_EQ(layout({"id", "x", "y", "z", "shape", "hz", "growth", "growth_z"}).shape, Shape::outline);
  const Layout column = layout({"id", "x", "y", "z", "growth", "growth_z"});
  EXPECT_EQ(column.shape, Shape::cylinder);
  EXPECT_TRUE(column.starts_as_point);
  EXPECT_TRUE(layout({"id", "x", "y", "z", "r", "hz", "growth_z"}).has_growth_z);
}

TEST(DeclareErrors, Growth) {
  expect_errors({
      {{"id", "x", "y", "z", "shape", "growth"},
       "\"growth\": no distance is defined to a mesh that grows; declare hz to make prisms, or leave shape "
       "out and declare r, a ball around each mesh"},
      {{"id", "x", "y", "growth", "growth_z"},
       "\"growth_z\": there is no axis z; add z or leave growth_z out"},
      {{"id", "x", "y", "z", "r", "growth_z"},
       "\"growth_z\": a ball grows alike on all sides; add hz for an upright cylinder, or leave growth_z "
       "out"},
      {{"id", "x", "y", "z", "growth_z"},
       "\"growth_z\": a point that grows along z alone is no shape; add growth"},
      {{"id", "x", "growht"},
       "\"growht\": no such column; did you mean growth? a column of your own is written +growht"},
  });
}

TEST(DeclareErrors, UnknownNamesSuggestTheNearest) {
  const std::string known =
      "; known: id, t, x, y, z, vx, vy, vz, ax, ay, az, fx, fy, fz, m, hx, hy, hz, r, shape, heading, "
      "growth, growth_z, until, category, mask, plan, lat, lon, speed, course, zone;"
      " a column of your own is written +";
  const std::string own = " a column of your own is written +";
  expect_errors({
      {{"id", "x", "vxx"}, "\"vxx\": no such column; did you mean vx?" + own + "vxx"},
      {{"id", "x", "untill REAL"}, "\"untill REAL\": no such column; did you mean until?" + own + "untill"},
      {{"id", "x", "name TEXT"}, "\"name TEXT\": no such column" + known + "name"},
      {{"id", "w"}, "\"w\": no such column" + known + "w"},
      {{"id", "x", "\"my name\""}, "\"\"my name\"\": no such column" + known + "\"my name\""},
      {{"id", "x", "\"+my name\""}, "\"\"+my name\"\": no such column" + known + "\"my name\""},
      {{"id", "x", "\"+name\" TEXT"}, "\"\"+name\" TEXT\": no such column" + known + "name"},
      {{"id", "x", "\"+\""}, "\"\"+\"\": no such column" + known + "name"},
  });
}

TEST(DeclareErrors, NamesFromReportsSuggestColumns) {
  const std::string own = " a column of your own is written +";
  expect_errors({
      {{"id", "t", "Latitude"}, "\"Latitude\": no such column; did you mean lat?" + own + "Latitude"},
      {{"id", "t", "longitude"}, "\"longitude\": no such column; did you mean lon?" + own + "longitude"},
      {{"id", "t", "lng"}, "\"lng\": no such column; did you mean lon?" + own + "lng"},
      {{"id", "x", "SOG"},
       "\"SOG\": no such column; did you mean speed, with speed_unit = knots?" + own + "SOG"},
      {{"id", "x", "cog"}, "\"cog\": no such column; did you mean course?" + own + "cog"},
      {{"id", "x", "velocity"},
       "\"velocity\": no such column; did you mean speed and course, or vx and vy?" + own + "velocity"},
      {{"id", "x", "radius"}, "\"radius\": no such column; did you mean r?" + own + "radius"},
      {{"id", "time", "x"}, "\"time\": no such column; did you mean t?" + own + "time"},
      {{"id", "x", "mmsi"}, "\"mmsi\": no such column; did you mean id?" + own + "mmsi"},
      {{"id", "x", "width"}, "\"width\": no such column; did you mean hx, half of it?" + own + "width"},
  });
}

TEST(DeclareErrors, DuplicatesAndOrder) {
  expect_errors({
      {{"id", "x", "X"}, "\"X\": a column named X is declared already; choose another name"},
      {{"id", "x", "+x"}, "\"+x\": a column named x is declared already; choose another name"},
      {{"id", "x", "+ID"}, "\"+ID\": a column named ID is declared already; choose another name"},
      {{"id", "x", "+n", "+N TEXT"},
       "\"+N TEXT\": a column named N is declared already; choose another name"},
      {{"id", "x", "+n", "vx"},
       "\"vx\": motion columns come before the auxiliary columns; move it before +n"},
  });
}

TEST(DeclareErrors, TypesAndSyntax) {
  expect_errors({
      {{"id", "x TEXT"}, "\"x TEXT\": x holds a double; write x or x REAL"},
      {{"id", "x REAL NOT NULL"}, "\"x REAL NOT NULL\": x holds a double; write x or x REAL"},
      {{"id", "x", "+"}, "\"+\": a name must follow the +, as in +name TEXT"},
      {{"id", "x", "+\"\""}, "\"+\"\"\": a name must follow the +, as in +name TEXT"},
      {{"id", "x", "7"}, "\"7\": not a column; write a name, +name for a column of your own, or key = value"},
      {{"id", "x", ""}, "\"\": not a column; write a name, +name for a column of your own, or key = value"},
      {{"id", "x", "+n TEXT; DROP"},
       "\"+n TEXT; DROP\": ';' is not part of a type; write the name and a type"},
      {{"id", "x", "+n TEXT NOT NULL"},
       "\"+n TEXT NOT NULL\": an auxiliary column takes a name, a type and COLLATE, but no NOT"},
      {{"id", "x", "+n = 5"}, "\"+n = 5\": '=' is not part of a type; write the name and a type"},
  });
}

TEST(DeclareErrors, Options) {
  const std::string rule = ": horizon must be a number greater than 0; write for example horizon = 60";
  for (std::string_view option : {"horizon = 0", "horizon = -5", "horizon = inf", "horizon = nan",
                                  "horizon = 1e999", "horizon = abc", "horizon =", "horizon = 60 s"})
    EXPECT_EQ(error_of({"id", "x", option}), "ships: \"" + std::string(option) + "\"" + rule);
  expect_errors({
      {{"id", "x", "horzon = 3"},
       "\"horzon = 3\": no such option; known: horizon, origin, speed_unit and frame, as in horizon = 60"},
      {{"id", "x", "horizon = 3", "horizon = 4"}, "\"horizon = 4\": horizon is given twice; leave one out"},
  });
}

TEST(DeclareErrors, ATableIsNotNamedLikeOneOfItsColumns) {
  const std::string rest =
      ": a table cannot be named like one of its columns (commands go to a column named like the table);"
      " choose another name than ";
  EXPECT_EQ(error_of({"id", "x"}, "X"), "X" + rest + "X");
  EXPECT_EQ(error_of({"id", "x"}, "id"), "id" + rest + "id");
  EXPECT_EQ(error_of({"id", "x", "+name"}, "name"), "name" + rest + "name");
  EXPECT_EQ(error_of({"id", "x"}, "y"), "");
}

}  // namespace
}  // namespace foresee
