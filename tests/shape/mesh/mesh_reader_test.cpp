// The reader and writer of meshes as well-known text, and the errors of invalid texts.
#include <gtest/gtest.h>

#include <chrono>

#include "base/error.h"
#include "shape/mesh/mesh_text.h"
#include "shape/mesh/test_meshes.h"

namespace foresee {
namespace {

/// The error of the reader for this text; "" if it reads it.
std::string refusal(std::string_view text) {
  try {
    read_mesh(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(MeshReader, ReadsFacesAndWeldsTheirCorners) {
  const Mesh mesh = read_mesh("TIN Z(((0 0 3, 4 0 3, 0 5 4, 0 0 3)), ((4 0 3, 0 0 3, 0 -5 4, 4 0 3)))");
  EXPECT_EQ(mesh.kind(), Mesh::Kind::surface);
  ASSERT_EQ(mesh.corners().size(), 4u);
  EXPECT_EQ(mesh.corners()[3], (SpaceCorner{0, -5, 4}));
  ASSERT_EQ(mesh.triangles().size(), 2u);
  EXPECT_EQ(mesh.triangles()[1], (Triangle{1, 0, 3}));
  EXPECT_EQ(mesh.extents().upper[2], 4);
}

TEST(MeshReader, TheWordSaysWhatIsASolid) {
  const std::string closed = std::string(tetrahedron).substr(19), open = "(((0 0 0, 1 0 0, 0 1 0, 0 0 0)))";
  EXPECT_TRUE(read_mesh("POLYHEDRALSURFACE Z" + closed).is_solid());
  EXPECT_TRUE(read_mesh("MULTIPOLYGON Z" + closed).is_solid());
  EXPECT_FALSE(read_mesh("MULTIPOLYGON Z" + open).is_solid());
  EXPECT_FALSE(read_mesh("TIN Z" + closed).is_solid());
}

TEST(MeshReader, TakesAnyCaseWhiteSpaceAndSrid) {
  const Mesh mesh = read_mesh("TIN Z(((0 0 0,1 0 0,0 1 0,0 0 0)))");
  EXPECT_EQ(read_mesh("srid = 32632 ; \n tin\tz ( ( (0\r0 0, 1 0 0,0  1 0\f,\v0 0 0 ) ) ) \n"), mesh);
  EXPECT_EQ(refusal("SRID=4326;TIN Z(((0 0 0,1 0 0,0 1 0,0 0 0)))"),
            "at character 6: SRID 4326 is in degrees: project to metres first");
}

TEST(MeshReader, MinusZeroIsZero) {
  const Mesh mesh =
      read_mesh("TIN Z(((-0 0 0, 1 0 -0.0, 0 1 0, 0 0 0)), ((0 -0 0, 1 -0 0, 0 -1 0, 0 0 -0)))");
  EXPECT_EQ(mesh.corners().size(), 4u);
  for (const SpaceCorner& corner : mesh.corners())
    EXPECT_FALSE(std::signbit(corner.x) || (std::signbit(corner.y) && corner.y == 0) ||
                 std::signbit(corner.z));
}

TEST(MeshReader, OtherKindsAreRefusedWithWhatToWrite) {
  EXPECT_EQ(
      refusal("POLYGON((0 0, 4 0, 0 3, 0 0))"),
      "at character 1: POLYGON is a flat outline, which needs hz: declare hz in the table, or write TIN "
      "Z, POLYHEDRALSURFACE Z or MULTIPOLYGON Z");
  EXPECT_EQ(refusal("MULTIPOLYGON(((0 0, 4 0, 0 3, 0 0)))"),
            "at character 13: corners of a mesh have three numbers: write MULTIPOLYGON Z, or declare hz in "
            "the table for flat outlines");
  for (const char* text : {"TIN(((0 0 0, 1 0 0, 0 1 0, 0 0 0)))", "TIN M(((0 0 0, 1 0 0, 0 1 0, 0 0 0)))",
                           "TIN ZM(((0 0 0 1, 1 0 0 1, 0 1 0 1, 0 0 0 1)))"})
    EXPECT_NE(refusal(text).find("corners of a mesh have three numbers: write TIN Z"), std::string::npos);
  EXPECT_EQ(refusal("BOX3D(0 0 0, 1 1 1)"),
            "at character 1: expected TIN Z, POLYHEDRALSURFACE Z or MULTIPOLYGON Z, found 'BOX3D'");
  EXPECT_EQ(refusal("TIN EMPTY"), "at character 5: EMPTY is no mesh: write NULL for a point");
  EXPECT_EQ(refusal("TIN Z EMPTY"), "at character 7: EMPTY is no mesh: write NULL for a point");
}

TEST(MeshReader, FacesAreClosedTriangles) {
  EXPECT_EQ(refusal("TIN Z(((0 0 0, 1 0 0, 0 1 0)))"),
            "face 1 is not closed: write the first corner (0 0 0) again at its end");
  EXPECT_EQ(refusal("TIN Z(((0 0 0, 1 0 0, 0 1 0, 0 0 0)), ((0 0 0, 1 0 0, 1 1 0, 0 1 0, 0 0 0)))"),
            "face 2 has 4 corners: write triangles, of three corners each");
  EXPECT_EQ(refusal("TIN Z(((0 0 0, 1 0 0, 0 0 0)))"),
            "face 1 has 2 corners: write triangles, of three corners each");
  EXPECT_EQ(refusal("TIN Z(((0 0 0)))"), "face 1 has 1 corner: write triangles, of three corners each");
  EXPECT_EQ(refusal("TIN Z(((0 0 0, 9 0 0, 0 9 0, 0 0 0), (1 1 0, 2 1 0, 1 2 0, 1 1 0)))"),
            "face 1 has a second ring: write triangles, of one ring each");
}

TEST(MeshReader, CornersHaveThreeNumbers) {
  EXPECT_EQ(refusal("TIN Z(((0 0, 1 0, 0 1, 0 0)))"),
            "at character 12: corners of a mesh have three numbers: x y z");
  EXPECT_EQ(refusal("TIN Z(((0 0 0, 1 0, 0 1, 0 0)))"),
            "at character 19: corners of a mesh have three numbers: x y z");
  EXPECT_EQ(refusal("TIN Z(((0 0 0 7, 1 0 0 7, 0 1 0 7, 0 0 0 7)))"),
            "at character 15: a fourth number: corners of a mesh have three: leave m out");
  EXPECT_EQ(refusal("TIN Z(((0 0 nan, 1 0 0, 0 1 0, 0 0 nan)))"),
            "at character 13: expected a number, found 'nan'");
  EXPECT_EQ(refusal("TIN Z(((0 0 1e999, 1 0 0, 0 1 0, 0 0 0)))"), "at character 13: no double is near 1e999");
}

TEST(MeshReader, EveryCutTextIsRefused) {
  const std::string text = "SRID=1;TIN Z(((0 0 0, 1 0 0, 0 1 0, 0 0 0)), ((0 0 0, 1 0 0, 0 -1 0, 0 0 0)))";
  for (std::size_t length = 0; length < text.size(); ++length)
    EXPECT_NE(refusal(text.substr(0, length)), "") << length;
  EXPECT_EQ(refusal(text + ")"), "at character 78: expected the end, found ')'");
}

TEST(MeshReader, ThereAreAtMostSoManyTriangles) {
  EXPECT_EQ(refusal(fan("TIN Z", max_triangles)), "");
  EXPECT_EQ(refusal(fan("TIN Z", max_triangles + 1)), "65537 triangles; at most 65536: simplify the mesh");
  EXPECT_EQ(refusal(fan("TIN Z", 70000)), "70000 triangles; at most 65536: simplify the mesh");
  // What follows is not read any more.
  EXPECT_EQ(refusal(fan("TIN Z", max_triangles + 1) + " nonsense").substr(0, 5), "65537");
}

// Unlike a table of hashes: no text makes corners collide.
TEST(MeshReader, TakesNoLongerThanTheTextIsLong) {
  const auto begin = std::chrono::steady_clock::now();
  std::string open(4'000'000, '(');
  EXPECT_NE(refusal("TIN Z" + open), "");
  std::string many = "TIN Z(((0 0 0";
  for (int i = 0; i < 300'000; ++i) many += ", 0 0 0";
  EXPECT_EQ(refusal(many + ")))"), "face 1 has 300000 corners: write triangles, of three corners each");
  EXPECT_EQ(refusal(fan("MULTIPOLYGON Z", max_triangles)), "");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST(MeshWriter, WritesWhatReadsBackTheSame) {
  for (const std::string& text :
       {std::string(tetrahedron), std::string("TIN Z(((0.1 1e-300 -7, 4 0 3, 0 5 1e+22, 0.1 1e-300 -7)))"),
        fan("MULTIPOLYGON Z", 50)}) {
    EXPECT_EQ(write_mesh(read_mesh(text)), text);
    EXPECT_EQ(read_mesh(write_mesh(read_mesh(text))), read_mesh(text));
  }
}

}  // namespace
}  // namespace foresee
