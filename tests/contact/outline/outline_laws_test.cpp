// What must hold whatever the numbers are: an outline that is a box is that box, grown ones and prisms too;
// exchanging and mirroring change nothing; an outline is the union of its pieces.
#include <gtest/gtest.h>

#include "contact/case_count.h"
#include "contact/outline/outline_scenes.h"
#include "contact/outline_contact.h"

namespace foresee::contact {
namespace {

using namespace testing_by_hand;

/// Halves of whole numbers, so that touches, ties and grazes come up; or any.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed), whole_(seed % 3 != 0) {}

  double operator()(double range) {
    const double any = std::uniform_real_distribution<double>(-range, range)(random_);
    return whole_ ? std::round(2 * any) / 2 : any;
  }
  bool often() { return random_() % 2 == 0; }

 private:
  std::mt19937_64 random_;
  bool whole_;
};

Object moving(Numbers& number, int axes, Shape shape, bool bent) {
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

void expect_same(const std::optional<ContactTimes>& one, const std::optional<ContactTimes>& other,
                 const std::string& what) {
  ASSERT_EQ(one.has_value(), other.has_value()) << what;
  if (!one) return;
  ASSERT_EQ(one->dt, other->dt) << what;
  ASSERT_EQ(one->t, other->t) << what;
  ASSERT_EQ(one->dt_end, other->dt_end) << what;
  ASSERT_EQ(one->t_end, other->t_end) << what;
}

/// A box and an object of `shape`: as they are, and with the box as an outline.
void compare_boxes(int axes, Shape shape, bool grown, int cases) {
  int contacts = 0;
  for (int seed = 0; seed < cases; ++seed) {
    Numbers number(static_cast<std::uint64_t>(seed));
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

/// Draws scenes of all families, some of them grown and accelerated.
template <class Check>
void for_each_scene(int seeds, Check&& check) {
  for (OutlineFamily family : outline_families())
    for (const auto pairing :
         {OutlinePairing::outlines, OutlinePairing::outline_and_point, OutlinePairing::outline_and_box})
      for (int seed = 1000; seed < 1000 + seeds; ++seed) {
        if (seed % 3 == 0) family.bent = true;
        OutlineScene scene = draw_scene(family, pairing, static_cast<std::uint64_t>(seed));
        if (seed % 2 == 0) scene.question.within = std::ldexp(0.5, family.scale);
        ASSERT_NO_FATAL_FAILURE(check(scene, outline_contact(scene))) << family.name << '\n'
                                                                      << described(scene);
      }
}

OutlineScene stretched(OutlineScene scene, Corner factor) {
  for (OutlinedObject* o : {&scene.a, &scene.b}) {
    for (double* list : {o->row.x, o->row.v, o->row.a}) list[0] *= factor.x, list[1] *= factor.y;
    o->row.half[0] *= std::abs(factor.x), o->row.half[1] *= std::abs(factor.y);
    o->outline = changed(o->outline, factor);
  }
  scene.question.within *= std::abs(factor.y);
  return scene;
}

TEST(OutlineLaws, ExchangingTheTwoChangesNothing) {
  for_each_scene(scaled_count(10), [](const OutlineScene& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, outline_contact({scene.b, scene.a, scene.question}), "exchanged");
  });
}

TEST(OutlineLaws, AMirrorChangesNothing) {
  for_each_scene(scaled_count(10), [](const OutlineScene& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, outline_contact(stretched(scene, {-1, 1})), "mirrored");
  });
}

TEST(OutlineLaws, LengthsInAnotherUnitChangeNothing) {
  for_each_scene(scaled_count(10), [](const OutlineScene& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, outline_contact(stretched(scene, {0x1p20, 0x1p20})), "scaled");
    // Where squares vanish, what is near is left to exact numbers. Of a subnormal number digits would.
    for (const double x : scene.b.row.x)
      if (x != 0 && std::abs(x) < 0x1p-700) return;
    expect_same(answer, outline_contact(stretched(scene, {0x1p-290, 0x1p-290})), "made small");
  });
}

TEST(OutlineLaws, AnOutlineIsTouchedWhenTheFirstOfItsPiecesIs) {
  for_each_scene(scaled_count(10), [](const OutlineScene& scene, const std::optional<ContactTimes>& answer) {
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
  for_each_scene(scaled_count(10), [](const OutlineScene& scene, const std::optional<ContactTimes>& answer) {
    if (scene.b.row.layout.shape == Shape::box) return;
    OutlineScene prisms = scene;
    for (OutlinedObject* o : {&prisms.a, &prisms.b}) {
      o->row.layout.axes = 3, o->row.layout.shape = Shape::cylinder;
      o->row.hz = 0x1p300;
    }
    expect_same(answer, outline_contact(prisms), "as prisms");
  });
}

TEST(OutlineLaws, AGreaterDistanceIsReachedNoLater) {
  for_each_scene(scaled_count(10), [](OutlineScene scene, const std::optional<ContactTimes>& answer) {
    if (!answer) return;
    scene.question.within += 0x1p-300;
    const auto grown = outline_contact(scene);
    ASSERT_TRUE(grown.has_value());
    EXPECT_LE(grown->dt, answer->dt);
  });
}

}  // namespace
}  // namespace foresee::contact
