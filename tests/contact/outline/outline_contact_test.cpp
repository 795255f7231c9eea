// Contact of outlines against the judge of rational numbers: the decision, and both times to the last bit.
#include <gtest/gtest.h>

#include "contact/case_count.h"
#include "contact/outline/outline_scenes.h"
#include "contact/outline/rational_oracle.h"

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
  int contacts = 0;
  for (const OutlineFamily& family : outline_families())
    for (const auto pairing :
         {OutlinePairing::outlines, OutlinePairing::outline_and_point, OutlinePairing::outline_and_box})
      for (int seed = 0; seed < scaled_count(30); ++seed) {
        const OutlineScene scene = draw_scene(family, pairing, static_cast<std::uint64_t>(seed));
        const auto answer = outline_contact(scene);
        contacts += answer.has_value();
        ASSERT_EQ(judged(scene, answer), "")
            << family.name << " pairing " << static_cast<int>(pairing) << " seed " << seed << '\n'
            << described(scene);
      }
  EXPECT_GT(contacts, 500);
}

}  // namespace
}  // namespace foresee::contact
