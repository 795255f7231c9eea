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
    if (axes == 3) question.within_z = std::abs(number(1));
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
TEST(OutlineLaws, APrismThatIsABoxMeetsCylindersAsTheBoxDoes) {
  compare_boxes(3, Shape::cylinder, true, scaled_count(400));
}

}  // namespace
}  // namespace foresee::contact
