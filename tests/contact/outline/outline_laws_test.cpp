// Laws of contact between outlines: a box given as an outline has the contacts of that box, also grown or
// as a prism. An outline is the union of its pieces. Laws that meshes share: form_laws_test.cpp.
#include <gtest/gtest.h>

#include "contact/form_laws.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

Object moving(DrawnNumbers& number, int axes, Shape shape, bool bent) {
  Object o = object(axes, shape);
  if (!bent) o.layout.law = Law::uniform;
  for (int j = 0; j < axes; ++j) {
    o.x[j] = number(6), o.v[j] = number(3), o.a[j] = bent ? number(2) : 0;
    o.half[j] = std::abs(number(3));
  }
  return o;
}

/// The same box as an outline around its position; upright, if there are three axes.
OutlinedObject as_outline(const Object& box) {
  OutlinedObject o{box, {}};
  const double x = box.half[0], y = box.half[1];
  o.outline = outline_of({{{-x, -y, x, -y, x, y, -x, y}}});
  o.row.layout.shape = box.layout.axes == 3 ? Shape::cylinder : Shape::point;
  o.row.hz = box.half[2], o.row.r = 0;
  return o;
}

/// A box and an object of `shape`: as they are, and with the box as an outline.
void compare_boxes(int axes, Shape shape, bool grown, int cases) {
  int contacts = 0;
  for (int seed = 0; seed < cases; ++seed) {
    DrawnNumbers number(static_cast<std::uint64_t>(seed));
    const bool bent = number.often();
    Object box = moving(number, axes, Shape::box, bent), other = moving(number, axes, shape, bent);
    for (int j = 0; j < 2; ++j) box.half[j] += 0.5;
    if (grown) other.r = std::abs(number(2));
    other.hz = other.half[2];
    ContactQuestion question{.horizon = {.now = 0, .h = 6}};
    if (grown) question.within = std::abs(number(1));
    if (shape == Shape::cylinder) question.within_z = std::abs(number(1));
    const auto expected = contact(box, other, question);
    contacts += expected.has_value();
    const OutlineScene scene{as_outline(box), {other, {}}, question};
    ASSERT_NO_FATAL_FAILURE(expect_same(expected, outline_contact(scene), "seed " + std::to_string(seed)));
    const OutlineScene exchanged{scene.b, scene.a, question};
    ASSERT_NO_FATAL_FAILURE(
        expect_same(expected, outline_contact(exchanged), "seed " + std::to_string(seed)));
  }
  EXPECT_GT(contacts, cases / 10);
}

TEST(OutlineLaws, AnOutlineThatIsABoxMeetsPointsAsTheBoxDoes) {
  compare_boxes(2, Shape::point, false, scaled_count(400));
}
TEST(OutlineLaws, AnOutlineThatIsABoxMeetsBoxesAsTheBoxDoes) {
  compare_boxes(2, Shape::box, false, scaled_count(400));
}
TEST(OutlineLaws, AnOutlineThatIsABoxMeetsDiscsAsTheBoxDoes) {
  compare_boxes(2, Shape::ball, true, scaled_count(400));
}
TEST(OutlineLaws, APrismThatIsABoxMeetsBoxesAsTheBoxDoes) {
  compare_boxes(3, Shape::box, false, scaled_count(400));
}
TEST(OutlineLaws, APrismThatIsABoxMeetsCylindersAsTheBoxDoes) {
  compare_boxes(3, Shape::cylinder, true, scaled_count(400));
}

TEST(OutlineLaws, ContactOfAnOutlineStartsWithItsFirstPiece) {
  for_each_scene<OutlineForms>([](const OutlineScene& scene, const std::optional<ContactTimes>& answer) {
    std::optional<ContactTimes> first;
    const ConvexPieces pieces = convex_pieces(scene.a.outline);
    for (std::size_t p = 0; p < pieces.count(); ++p) {
      OutlineScene alone = scene;
      alone.a.outline = Outline();
      alone.a.outline.begin_part();
      for (const Corner& corner : pieces.corners(p)) alone.a.outline.add(corner);
      const auto found = outline_contact(alone);
      if (found && !(first && first->dt <= found->dt)) first = found;
    }
    ASSERT_EQ(first.has_value(), answer.has_value());
    if (!first) return;
    ASSERT_EQ(first->dt, answer->dt);
    EXPECT_EQ(first->t, answer->t);
    EXPECT_LE(first->dt_end, answer->dt_end);
  });
}

TEST(OutlineLaws, AnUprightPrismWithoutEndIsItsOutline) {
  for_each_scene<OutlineForms>([](const OutlineScene& scene, const std::optional<ContactTimes>& answer) {
    if (scene.b.row.layout.shape == Shape::box) return;
    OutlineScene prisms = scene;
    for (OutlinedObject* o : {&prisms.a, &prisms.b}) {
      o->row.layout.axes = 3, o->row.layout.shape = Shape::cylinder;
      o->row.hz = 0x1p300;
    }
    expect_same(answer, outline_contact(prisms), "as prisms");
  });
}

}  // namespace
}  // namespace foresee
