// Contact of outlines against the judge of rational numbers: the decision, and both times to the last bit.
#include <gtest/gtest.h>

#include "contact/case_count.h"
#include "contact/outline/outline_scenes.h"
#include "contact/outline/rational_oracle.h"
#include "contact/outline/staged_pair.h"

namespace foresee {
namespace {

using namespace testing_by_hand;
using oracle::Encounter;
using oracle::Rational;
using oracle::RationalInterval;
using oracle::Region;

Region region_of(const OutlinedObject& o) {
  Region region;
  for (std::size_t r = 0; r < o.outline.rings(); ++r)
    region.emplace_back(o.outline.ring(r).begin(), o.outline.ring(r).end());
  if (!region.empty()) return region;
  const double x = o.row.half[0], y = o.row.half[1];
  if (x == 0 && y == 0) return {{{0, 0}}};
  return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
}

Encounter encounter_of(const OutlineScene& scene) {
  return {scene.a.row, scene.b.row, scene.question};
}

/// Empty if the answer is right, else what is wrong.
std::string judged(const OutlineScene& scene, const std::optional<ContactTimes>& answer) {
  const Encounter encounter = encounter_of(scene);
  const RationalInterval queried = encounter.queried();
  std::optional<RationalInterval> exact;
  if (queried.begin <= queried.end)
    exact = oracle::first_contact(region_of(scene.a), region_of(scene.b),
                                  {encounter.place(0, 0), encounter.place(1, 0)},
                                  {encounter.velocity(0), encounter.velocity(1)}, queried);
  return oracle::compared(exact, answer, scene.question.horizon.now);
}

TEST(OutlineContact, IsThatOfRationalNumbers) {
  int cases = 0, contacts = 0;
  for (const OutlineFamily& family : outline_families())
    for (const auto pairing :
         {OutlinePairing::outlines, OutlinePairing::outline_and_point, OutlinePairing::outline_and_box})
      for (int seed = 0; seed < scaled_count(32); ++seed) {
        const OutlineScene scene = draw_scene(family, pairing, static_cast<std::uint64_t>(seed));
        const auto answer = outline_contact(scene);
        ++cases, contacts += answer.has_value();
        ASSERT_EQ(judged(scene, answer), "")
            << family.name << " pairing " << static_cast<int>(pairing) << " seed " << seed << '\n'
            << described(scene);
      }
  EXPECT_GE(4 * contacts, cases);
}

/// The same, of any radius and motion.
std::string judged_by_times(const OutlineScene& scene, const std::optional<ContactTimes>& answer) {
  const Encounter encounter = encounter_of(scene);
  const Region a = region_of(scene.a), b = region_of(scene.b);
  const auto touch = [&](const Rational& time) {
    return oracle::touch_at(a, b, {encounter.place(0, time), encounter.place(1, time)},
                            encounter.radius(time));
  };
  return oracle::judged_by_times(touch, scene.question.horizon.h, answer);
}

TEST(OutlineContact, OfAnyRadiusAndMotionIsRightAtEveryTime) {
  int cases = 0, contacts = 0;
  for (OutlineFamily family : outline_families())
    for (const auto pairing :
         {OutlinePairing::outlines, OutlinePairing::outline_and_point, OutlinePairing::outline_and_box})
      for (int seed = 0; seed < scaled_count(4); ++seed) {
        family.bent = seed % 2 == 1;
        if (family.lives || family.ages > 100) continue;
        OutlineScene scene = draw_scene(family, pairing, static_cast<std::uint64_t>(seed));
        const double unit = std::ldexp(1.0, family.scale);
        if (seed % 3 > 0) scene.question.within = unit * (seed % 5) / 2;
        if (scene.b.row.layout.shape == Shape::point) {
          scene.b.row.layout.shape = Shape::ball;
          scene.b.row.r = unit * (seed % 4) / 3;
        }
        for (Object* o : {&scene.a.row, &scene.b.row}) {
          if (o->layout.shape == Shape::box || (seed + family.ulps) % 3 == 0) continue;
          o->layout.has_growth = true;
          o->growth = unit * (seed % 7) / 8;
        }
        const bool grows = scene.a.row.growth > 0 || scene.b.row.growth > 0;
        if (!family.bent && !grows && scene.question.within + scene.b.row.r == 0) continue;  // judged above
        const auto answer = outline_contact(scene);
        ++cases, contacts += answer.has_value();
        ASSERT_EQ(judged_by_times(scene, answer), "")
            << family.name << " pairing " << static_cast<int>(pairing) << " seed " << seed << '\n'
            << described(scene);
      }
  EXPECT_GE(4 * contacts, cases);
}

TEST(OutlineContact, OfRandomPairsIsDecidedByDoubles) {
  const OutlineFamily any{.name = "any", .whole = false};
  int contacts = 0, in_doubt = 0;
  for (int seed = 0; seed < 1000; ++seed) {
    StagedScene staged(draw_scene(any, OutlinePairing::outlines, static_cast<std::uint64_t>(seed)));
    UnionPair<FlatTraits<2, 1>> pair = staged.pair(true);
    const Verdict touches = pair.first_contact().touches;
    contacts += touches == Verdict::yes;
    in_doubt += touches == Verdict::uncertain || (touches == Verdict::yes && !pair.end_of_contact().known());
  }
  EXPECT_GT(contacts, 200);
  EXPECT_LE(in_doubt, 2);
}

}  // namespace
}  // namespace foresee
