// A mesh that is a box meets others as that box does, one that is an upright prism as that prism does.
#include <gtest/gtest.h>

#include "contact/form_laws.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

Object moving_object(DrawnNumbers& number, Shape shape, bool bent) {
  Object o = object(3, shape);
  if (!bent) o.layout.law = Law::uniform;
  for (int j = 0; j < 3; ++j) {
    o.x[j] = number(4), o.v[j] = number(2), o.a[j] = bent ? number(2) : 0;
    o.half[j] = std::abs(number(3));
  }
  return o;
}

MeshObject as_mesh(const Object& box) {
  const double x = box.half[0], y = box.half[1], z = box.half[2];
  MeshObject o{box, solid_of(box_between({-x, -y, -z}, {x, y, z}))};
  o.row.layout.shape = Shape::mesh;
  o.row.layout.has_radius = true;
  return o;
}

/// A box and an object of `shape`: as they are, and with the box as a mesh, or both.
void compare_boxes(Shape shape, bool grown, int cases) {
  int contacts = 0;
  for (int seed = 0; seed < cases; ++seed) {
    DrawnNumbers number(static_cast<std::uint64_t>(seed));
    const bool bent = number.often();
    Object box = moving_object(number, Shape::box, bent), other = moving_object(number, shape, bent);
    for (double& half : box.half) half += 0.5;
    for (double& half : other.half) half += 0.5;
    ContactQuestion question{.horizon = {.now = 0, .h = 6}};
    if (grown) other.r = std::abs(number(2)), question.within = std::abs(number(1));
    const auto expected = contact(box, other, question);
    contacts += expected.has_value();
    const std::string what = "seed " + std::to_string(seed);
    const MeshObject mesh = as_mesh(box);
    ASSERT_NO_FATAL_FAILURE(expect_same(expected, mesh_contact({mesh, {other, {}}, question}), what));
    ASSERT_NO_FATAL_FAILURE(expect_same(expected, mesh_contact({{other, {}}, mesh, question}), what));
    if (shape != Shape::box) continue;
    ASSERT_NO_FATAL_FAILURE(expect_same(expected, mesh_contact({mesh, as_mesh(other), question}), what));
  }
  EXPECT_GT(contacts, cases / 10);
}

TEST(MeshAsBox, MeetsPointsAsTheBoxDoes) {
  compare_boxes(Shape::point, false, scaled_count(400));
}
TEST(MeshAsBox, MeetsBoxesAsTheBoxDoes) {
  compare_boxes(Shape::box, false, scaled_count(400));
}
TEST(MeshAsBox, MeetsBallsAsTheBoxDoes) {
  compare_boxes(Shape::ball, true, scaled_count(400));
}

/// An outline with a reflex corner, around the origin.
std::vector<Corner> arrow(DrawnNumbers& number) {
  const double w = 1 + std::abs(number(3)), h = 1 + std::abs(number(3));
  return {{0, 0}, {w, -h}, {0, 2 * h}, {-w, -h}};
}

/// As an upright prism, and as a mesh.
struct Upright {
  OutlinedObject prism;
  MeshObject mesh;
};

Upright upright(DrawnNumbers& number, bool bent) {
  Object row = moving_object(number, Shape::cylinder, bent);
  row.hz = 0.5 + row.half[2];
  const std::vector<Corner> ring = arrow(number);
  Ring numbers;
  for (const Corner& corner : ring) numbers.push_back(corner.x), numbers.push_back(corner.y);
  Upright both{{row, outline_of({{numbers}})}, {row, solid_of(prism(ring, ring[0], -row.hz, row.hz))}};
  both.mesh.row.layout.shape = Shape::mesh;
  both.mesh.row.layout.has_radius = true;
  return both;
}

TEST(MeshAsBox, AMeshThatIsAPrismMeetsOthersAsThePrismDoes) {
  const int cases = scaled_count(400);
  int contacts = 0;
  for (int seed = 0; seed < cases; ++seed) {
    DrawnNumbers number(static_cast<std::uint64_t>(seed));
    const bool bent = number.often();
    const Upright a = upright(number, bent), b = upright(number, bent);
    const ContactQuestion question{.horizon = {.now = 0, .h = 6}};
    const auto expected = outline_contact({a.prism, b.prism, question});
    contacts += expected.has_value();
    ASSERT_NO_FATAL_FAILURE(
        expect_same(expected, mesh_contact({a.mesh, b.mesh, question}), "seed " + std::to_string(seed)));
  }
  EXPECT_GT(contacts, cases / 10);
}

}  // namespace
}  // namespace foresee
