// Contact of outlines against the judge of rational numbers: the decision, and both times to the last bit.
#include <gtest/gtest.h>

#include "contact/case_count.h"
#include "contact/outline/outline_scenes.h"
#include "contact/outline/rational_oracle.h"
#include "contact/outline/staged_pair.h"

namespace foresee::contact {
namespace {

using namespace testing_by_hand;
using oracle::Place;
using oracle::Rational;
using oracle::Region;
using oracle::Stretch;

Region region_of(const OutlinedObject& o) {
  Region region;
  for (std::size_t r = 0; r < o.outline.rings(); ++r)
    region.emplace_back(o.outline.ring(r).begin(), o.outline.ring(r).end());
  if (!region.empty()) return region;
  const double x = o.row.half[0], y = o.row.half[1];
  if (x == 0 && y == 0) return {{{0, 0}}};
  return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
}

/// Empty if the answer is right, else what is wrong.
std::string judged(const OutlineScene& scene, const std::optional<ContactTimes>& answer) {
  const Object &a = scene.a.row, &b = scene.b.row;
  const Rational now(scene.question.horizon.now);
  const auto at_now = [&](const Object& o, int j) -> Rational {
    return Rational(o.x[j]) + Rational(o.v[j]) * (now - Rational(o.t));
  };
  const Place place{at_now(b, 0) - at_now(a, 0), at_now(b, 1) - at_now(a, 1)};
  const Place velocity{Rational(b.v[0]) - Rational(a.v[0]), Rational(b.v[1]) - Rational(a.v[1])};
  Stretch asked{0, Rational(scene.question.horizon.h)};
  for (const Object* o : {&a, &b}) {
    asked.begin = std::max<Rational>(asked.begin, Rational(o->t) - now);
    if (std::isfinite(o->until)) asked.end = std::min<Rational>(asked.end, Rational(o->until) - now);
  }
  std::optional<Stretch> exact;
  if (asked.begin <= asked.end)
    exact = oracle::first_contact(region_of(scene.a), region_of(scene.b), place, velocity, asked);
  if (exact.has_value() != answer.has_value()) return exact ? "missed" : "invented";
  if (!exact) return {};
  if (!oracle::is_rounded(answer->dt, exact->begin)) return "wrong dt";
  if (!oracle::is_rounded(answer->t, exact->begin + now)) return "wrong t";
  if (!oracle::is_rounded(answer->dt_end, exact->end)) return "wrong dt_end";
  if (!oracle::is_rounded(answer->t_end, exact->end + now)) return "wrong t_end";
  return {};
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

/// Where b is seen from a at a moment from now on, exactly.
Place place_at(const OutlineScene& scene, const Rational& moment) {
  const auto at = [&](const Object& o, int j) -> Rational {
    const Rational s = moment + Rational(scene.question.horizon.now) - Rational(o.t);
    return Rational(o.x[j]) + s * (Rational(o.v[j]) + s * Rational(o.a[j]) / 2);
  };
  const Object &a = scene.a.row, &b = scene.b.row;
  return {at(b, 0) - at(a, 0), at(b, 1) - at(a, 1)};
}

/// Judges contact of any radius and motion by single moments: just beside the times that were answered, and
/// many others. Empty if nothing is wrong.
class MomentJudge {
 public:
  explicit MomentJudge(const OutlineScene& scene)
      : scene_(scene),
        a_(region_of(scene.a)),
        b_(region_of(scene.b)),
        radius_(Rational(scene.a.row.r) + Rational(scene.b.row.r) + Rational(scene.question.within)) {}

  std::string judged(const std::optional<ContactTimes>& answer) const {
    const double h = scene_.question.horizon.h, begin = answer ? answer->dt : 2 * h;
    const double end = answer ? answer->dt_end : 2 * h;
    for (int i = 0; i <= 16; ++i) {
      const double moment = h * i / 16;
      if (moment < begin && touch(moment)) return answer ? "begins earlier" : "missed";
      if (begin < moment && moment < end && !touch(moment)) return "ends earlier";
    }
    if (!answer) return {};
    if (begin > 0 && touch(beside(begin, -1))) return "begins earlier by an ulp";
    if (begin < end && !touch(beside(begin, 1))) return "begins later";
    if (end < h && touch(beside(end, 1))) return "ends later";
    if (begin < end && !touch(beside(end, -1))) return "ends earlier by an ulp";
    return {};
  }

 private:
  bool touch(const Rational& moment) const {
    return oracle::touch_at(a_, b_, place_at(scene_, moment), radius_);
  }
  /// A little more than half an ulp before or after, where another double would be the nearest.
  static Rational beside(double moment, int side) {
    const double next = std::nextafter(moment, side * HUGE_VAL);
    return Rational(moment) + (Rational(next) - Rational(moment)) * Rational(513, 1024);
  }

  const OutlineScene& scene_;
  const Region a_, b_;
  const Rational radius_;
};

TEST(OutlineContact, OfAnyRadiusAndMotionIsRightAtEveryMoment) {
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
        if (!family.bent && scene.question.within + scene.b.row.r == 0) continue;  // judged above
        const auto answer = outline_contact(scene);
        ++cases, contacts += answer.has_value();
        ASSERT_EQ(MomentJudge(scene).judged(answer), "")
            << family.name << " pairing " << static_cast<int>(pairing) << " seed " << seed << '\n'
            << described(scene);
      }
  EXPECT_GE(4 * contacts, cases);
}

TEST(OutlineContact, OfRandomPairsIsToldByDoubles) {
  const OutlineFamily any{.name = "any", .whole = false};
  int contacts = 0, in_doubt = 0;
  for (int seed = 0; seed < 1000; ++seed) {
    StagedScene staged(draw_scene(any, OutlinePairing::outlines, static_cast<std::uint64_t>(seed)));
    UnionPair<FlatKit<2, 1>> pair = staged.pair(true);
    Instant begin;
    const Verdict touches = pair.first_contact(begin);
    contacts += touches == Verdict::yes;
    in_doubt += touches == Verdict::uncertain || (touches == Verdict::yes && !pair.end_of_contact(false).known());
  }
  EXPECT_GT(contacts, 200);
  EXPECT_LE(in_doubt, 2);
}

}  // namespace
}  // namespace foresee::contact
