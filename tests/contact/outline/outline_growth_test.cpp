// Outlines that grow with time: by hand, as prisms, and against the same outlines of the size that they have
// in the end.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "contact/case_count.h"
#include "contact/outline/outline_scenes.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

const Ring growing_square{0, 0, 1, 0, 1, 1, 0, 1};
/// Ten long and high, with a hole from 2 to 8.
const std::vector<Ring> rims{{0, 0, 10, 0, 10, 10, 0, 10}, {2, 2, 8, 2, 8, 8, 2, 8}};

OutlinedObject outlined(const std::vector<Ring>& rings, double x, double y, double growth, double t = 0) {
  OutlinedObject o{object(2, Shape::point), {}};
  o.row.layout.law = Law::uniform, o.row.layout.has_growth = true;
  o.row.x[0] = x, o.row.x[1] = y, o.row.t = t, o.row.growth = growth;
  if (!rings.empty()) o.outline = outline_of({rings});
  return o;
}

std::optional<ContactTimes> queried(const OutlinedObject& a, const OutlinedObject& b, double now, double h) {
  return outline_contact({a, b, {.horizon = {now, h}}});
}

void expect_begin(const std::optional<ContactTimes>& found, double t) {
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->t, t);
}

TEST(OutlineGrowth, ClosesTheGapBetweenWhatIsAtRest) {
  expect_begin(queried(outlined({growing_square}, 0, 0, 0.25), outlined({growing_square}, 4, 0, 0.5), 0, 10),
               4);
  // Corner to corner: 3-4-5.
  expect_begin(queried(outlined({growing_square}, 0, 0, 0.5), outlined({growing_square}, 4, 5, 0.5), 0, 10),
               5);
  EXPECT_FALSE(queried(outlined({growing_square}, 0, 0, 0.5), outlined({growing_square}, 4, 5, 0.5), 0,
                       std::nextafter(5, 0)));
}

TEST(OutlineGrowth, CountsFromEachReport) {
  // At 10 one has grown by 2.5 for ten, the other for two.
  expect_begin(
      queried(outlined({growing_square}, 0, 0, 0.25), outlined({growing_square}, 5, 0, 0.5, 8), 10, 10),
      32.0 / 3);
  // An object that has just started to exist has not grown.
  expect_begin(queried(outlined({growing_square}, 0, 0, 0), outlined({growing_square}, 3, 0, 1, 15), 10, 10),
               17);
}

TEST(OutlineGrowth, LeavesAPointInAHoleAloneUntilItsRimComes) {
  expect_begin(queried(outlined(rims, 0, 0, 0.5), outlined({}, 5, 5, 0), 0, 10), 6);
  expect_begin(queried(outlined(rims, 0, 0, 0.5), outlined({}, 5, 5, 0.25), 0, 10), 4);
}

TEST(OutlineGrowth, OfPrismsIsApartAlongZ) {
  const auto prism = [](double x, double z, double growth, double growth_z) {
    OutlinedObject o = outlined({growing_square}, x, 0, growth);
    o.row.layout.axes = 3, o.row.layout.shape = Shape::cylinder, o.row.layout.has_growth_z = true;
    o.row.x[2] = z, o.row.hz = 1, o.row.growth_z = growth_z;
    return o;
  };
  expect_begin(queried(prism(0, 0, 0, 0.25), prism(0, 4, 0, 0.25), 0, 10), 4);
  EXPECT_FALSE(queried(prism(0, 0, 9, 0), prism(0, 4, 9, 0), 0, 10));
  expect_begin(queried(prism(0, 0, 0.5, 0.25), prism(6, 4, 0.5, 0.25), 0, 10), 5);
}

/// A growing outline is smaller before the end: an object that touches it touches the largest.
TEST(OutlineGrowth, IsNeverMoreThanWhatItBecomes) {
  int both = 0, largest_alone = 0;
  for (const OutlineFamily& family : outline_families())
    for (int seed = 0; seed < std::max(8, scaled_count(8)); ++seed) {
      if (family.lives || family.ages > 100) continue;
      OutlineScene scene =
          draw_scene(family, OutlinePairing::outlines, static_cast<std::uint64_t>(seed) + 77);
      const double unit = std::ldexp(1.0, family.scale), end = scene.question.horizon.now + 8;
      OutlineScene largest = scene;
      scene.a.row.layout.has_growth = true;
      scene.a.row.growth = unit * (1 + seed % 5) / 16;
      largest.question.within += (end - scene.a.row.t) * scene.a.row.growth * (1 + 0x1p-50);
      const auto grows = outline_contact(scene), touches_largest = outline_contact(largest);
      ASSERT_TRUE(touches_largest || !grows) << family.name << ' ' << seed << '\n' << described(scene);
      if (grows) {
        ASSERT_GE(grows->dt, touches_largest->dt);
      }
      both += grows.has_value(), largest_alone += touches_largest && !grows;
    }
  EXPECT_GT(both, 20);
  EXPECT_GT(largest_alone, 0);
}

TEST(OutlineGrowth, HasNoDistanceToABoxThatGrowsOrAMesh) {
  const auto refusal = [](const Layout& a, const Layout& b) -> std::string {
    try {
      make_contact(Bodies(a, nullptr, 0), Bodies(b, nullptr, 0), {}, "hulls", "crates");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const Layout hulls{.axes = 2, .shape = Shape::outline},
      discs{.axes = 2, .shape = Shape::ball, .has_growth = true},
      crates{.axes = 2, .shape = Shape::box, .has_growth = true};
  EXPECT_EQ(refusal(hulls, discs), "");
  EXPECT_EQ(refusal(hulls, crates),
            "no distance is defined between outlines and boxes that grow: declare r and growth in crates in "
            "place of "
            "hx and hy");
  EXPECT_EQ(
      refusal({.axes = 3, .shape = Shape::mesh}, {.axes = 3, .shape = Shape::ball, .has_growth = true}),
      "no distance is defined between meshes and what grows: leave growth out of crates, or write within");
}

}  // namespace
}  // namespace foresee
