// Validity of meshes: every triangle has an area, a solid is closed, and both also after a rotation.

#include <gtest/gtest.h>

#include "base/error.h"
#include "shape/mesh/mesh.h"
#include "shape/mesh/mesh_text.h"
#include "shape/mesh/test_meshes.h"

namespace foresee {
namespace {

std::string flaw(const std::string& text) {
  try {
    const Mesh mesh = read_mesh(text);
    check_mesh(mesh);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string turned_flaw(const std::string& text, double heading) {
  const Mesh mesh = read_mesh(text);
  EXPECT_TRUE(is_sound(mesh));
  try {
    check_turned(mesh, turned(mesh, heading), heading);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(MeshCheck, TrianglesHaveAnAreaByExactSigns) {
  EXPECT_EQ(flaw("TIN Z(((0 0 0, 4 0 3, 0 5 4, 0 0 0)), ((0 0 0, 1 1 1, 3 3 3, 0 0 0)))"),
            "face 2 (0 0 0, 1 1 1, 3 3 3) has no area: its corners lie on one line");
  EXPECT_EQ(flaw("TIN Z(((1 2 3, 1 2 3, 0 5 4, 1 2 3)))"),
            "face 1 (1 2 3, 1 2 3, 0 5 4) has no area: its corners lie on one line");
  // Upright along each axis, and an ulp off a line.
  for (const char* text :
       {"TIN Z(((0 0 0, 0 1 0, 0 0 1, 0 0 0)))", "TIN Z(((0 0 0, 1 0 0, 0 0 1, 0 0 0)))",
        "TIN Z(((0 0 0, 1 0 0, 0 1 0, 0 0 0)))", "TIN Z(((0 0 0, 1 1 1, 3 3 3.0000000000000004, 0 0 0)))",
        "TIN Z(((0 0 0, 1e300 0 0, 0 1e300 1e-300, 0 0 0)))",
        "TIN Z(((0 0 0, 5e-324 0 0, 0 0 5e-324, 0 0 0)))"})
    EXPECT_EQ(flaw(text), "") << text;
}

TEST(MeshCheck, AnEdgeOfASolidBelongsToTwoTriangles) {
  EXPECT_EQ(flaw(tetrahedron), "");
  const std::string text = tetrahedron;
  const std::string without_last = text.substr(0, text.rfind(", ((")) + ")";
  EXPECT_EQ(flaw(without_last),
            "edge (0 1 0, 1 0 0) belongs to 1 triangle, in a solid to two: write equal corners "
            "with equal numbers, or TIN Z for a surface");
  EXPECT_EQ(flaw(text.substr(0, text.size() - 1) + ", ((1 0 0, 0 1 0, 5 5 5, 1 0 0)))").substr(0, 50),
            "edge (0 1 0, 1 0 0) belongs to 3 triangles, in a s");
  EXPECT_EQ(flaw("MULTIPOLYGON Z" + without_last.substr(19)), "");
  EXPECT_EQ(flaw("TIN Z" + without_last.substr(19)), "");
}

// One corner is off by an ulp: to the eye the tetrahedron is closed.
TEST(MeshCheck, AnEdgeThatIsNotWeldedIsNamed) {
  std::string text = tetrahedron;
  const std::size_t last = text.rfind("0 0 1");
  EXPECT_EQ(flaw(text.replace(last, 5, "0 0 1.0000000000000002")).substr(0, 48),
            "edge (1 0 0, 0 0 1) belongs to 1 triangle, in a ");
}

TEST(MeshCheck, TrianglesMayTouchAndCross) {
  EXPECT_EQ(flaw("TIN Z(((0 0 0, 4 0 0, 0 4 0, 0 0 0)), ((1 1 -1, 1 1 1, 2 1 0, 1 1 -1)), "
                 "((0 0 0, 4 0 0, 0 4 0, 0 0 0)))"),
            "");
}

TEST(MeshCheck, ATurnMayNeitherJoinCornersNorFlattenTriangles) {
  EXPECT_EQ(turned_flaw(tetrahedron, 37.5), "");
  const std::string near = "TIN Z(((1e-320 3e15 0, 0 3e15 0, 1 2 9, 1e-320 3e15 0)))";
  EXPECT_EQ(turned_flaw(near, 90), "");
  EXPECT_EQ(turned_flaw(near, 37.5),
            "turned by 37.5 degrees its corners (1e-320 3000000000000000 0, "
            "0 3000000000000000 0) become one: they are closer than "
            "doubles resolve");
  const std::string thin = "TIN Z(((0 0 0, 4 0 0, 1 1e-30 0, 0 0 0)))";
  EXPECT_EQ(turned_flaw(thin, -270), "");
  EXPECT_EQ(turned_flaw(thin, 45),
            "turned by 45 degrees its face 1 (0 0 0, 4 0 0, 1 1e-30 0) has no area between its corners: they "
            "are closer than doubles resolve");
}

TEST(TurnedMesh, TurnsAroundTheUprightAxis) {
  const Mesh mesh = turned(read_mesh("TIN Z(((0 10 1, 3 0 2, 0 0 -3, 0 10 1)))"), 90);
  EXPECT_EQ(mesh.corners()[0], (SpaceCorner{10, 0, 1}));  // clockwise from the y axis
  EXPECT_EQ(mesh.corners()[1], (SpaceCorner{0, -3, 2}));
  EXPECT_EQ(mesh.corners()[2], (SpaceCorner{0, 0, -3}));
  EXPECT_THROW(turned(read_mesh("TIN Z(((1.7e308 1.7e308 0, 3 0 2, 0 0 -3, 1.7e308 1.7e308 0)))"), 45),
               Error);
}

}  // namespace
}  // namespace foresee
