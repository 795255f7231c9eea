// Laws 10 to 16 of contact (contact/contact.h): the effects of a longer horizon, of greater lengths and of
// other pairs in the same call.
#include <array>

#include "contact/laws.h"
#include "numbers/dyadic.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

/// Law 10: the first contact of a horizon is that of its first half, or else that of its second.
TEST(Laws, HorizonsCanBeSplit) {
  check_law(
      [](Case& c) {
        const auto [now, h] = c.question.horizon;
        const double half = h / 2, middle = now + half;
        c.question.horizon.h = half;
        return middle - now == half && middle - half == now && half * 2 == h;  // then no sum is rounded
      },
      [](const Case& c, const Case& first_half) {
        const auto whole = contact(c.a, c.b, c.question), first = contact(c.a, c.b, first_half.question);
        Case second_half = first_half;
        second_half.question.horizon.now += first_half.question.horizon.h;
        const auto second = contact(c.a, c.b, second_half.question);
        ASSERT_EQ(whole.has_value(), first.has_value() || second.has_value()) << c;
        if (!whole) return;
        EXPECT_EQ(whole->t, (first ? first : second)->t) << c;
        if (!first) {
          EXPECT_EQ(whole->t_end, second->t_end) << c;
        }
      });
}

/// No pair is lost, and no pair touches later.
void expect_not_later(const Case& c, const Case& grown) {
  const auto before = contact(c.a, c.b, c.question), after = contact(grown.a, grown.b, grown.question);
  if (!before) return;
  ASSERT_TRUE(after.has_value()) << c;
  EXPECT_LE(after->t, before->t) << c;
  EXPECT_LE(after->dt, before->dt) << c;
}

/// Law 11, for `within`.
TEST(Laws, GrowingIsNeverLater) {
  check_law(
      [](Case& c) {
        c.question.within += 0.25;
        return true;
      },
      expect_not_later);
}

/// Law 11, for extents.
TEST(Laws, GreaterExtentsAreNeverLater) {
  check_law(
      [](Case& c) {
        c.a.r *= 1.25, c.a.hz *= 1.25, c.b.r *= 1.25;
        for (double& half : c.a.half) half *= 1.25;
        return true;
      },
      expect_not_later);
}

/// Law 12.
TEST(Laws, FasterGrowthIsNeverLater) {
  check_law(
      [](Case& c) {
        if (!grows(c.a.layout)) std::swap(c.a, c.b);
        c.a.growth *= 1.25, c.a.growth_z *= 1.25;
        return grows(c.a.layout);
      },
      [](const Case& c, const Case& grown) {
        const auto before = contact(c.a, c.b, c.question), after = contact(grown.a, grown.b, c.question);
        ASSERT_TRUE(after || !before) << c;
        EXPECT_TRUE(!before || after->dt <= before->dt) << c;
      });
}

/// Law 13.
TEST(Laws, LongerHorizonsKeepFirstContacts) {
  check_law(
      [](Case& c) {
        c.question.horizon.h *= 1.75;
        return true;
      },
      [](const Case& c, const Case& longer) {
        const auto before = contact(c.a, c.b, c.question), after = contact(c.a, c.b, longer.question);
        if (!before) return;
        ASSERT_TRUE(after.has_value()) << c;
        EXPECT_EQ(after->t, before->t) << c;
        EXPECT_EQ(after->dt, before->dt) << c;
        EXPECT_GE(after->t_end, before->t_end) << c;
        EXPECT_GE(after->dt_end, before->dt_end) << c;
      });
}

/// Law 14. The end of the horizon is rounded like a time.
TEST(Laws, ContactsAreWithinTheHorizonAndBothLives) {
  check_law([](Case&) { return true; },
            [](const Case& c, const Case&) {
              const auto times = contact(c.a, c.b, c.question);
              if (!times) return;
              const auto [now, h] = c.question.horizon;
              EXPECT_LE(std::max({now, c.a.t, c.b.t}), times->t) << c;
              EXPECT_LE(times->t, times->t_end) << c;
              EXPECT_LE(times->t_end, std::min({now + h, c.a.until, c.b.until})) << c;
              EXPECT_LE(0, times->dt) << c;
              EXPECT_LE(times->dt, times->dt_end) << c;
              EXPECT_LE(times->dt_end, h) << c;
            });
}

/// Law 15, for balls that do not grow: both sides rounded once.
TEST(Laws, BallsTouchIffTheirCentresComeNearEnough) {
  int touching = 0;
  check_law(
      [](Case& c) {
        for (Object* o : {&c.a, &c.b})
          if (o->layout.shape != Shape::ball || grows(o->layout)) return false;
        return true;
      },
      [&](const Case& c, const Case&) {
        const Said said = said_of(c);
        if (!said.approach) return;
        const double reach = rounded(Dyadic(c.a.r) + Dyadic(c.b.r) + Dyadic(c.question.within));
        if (said.times) {
          EXPECT_LE(said.approach->d, reach) << c;
        } else {
          EXPECT_GE(said.approach->d, reach) << c;
        }
        touching += said.times.has_value();
      });
  EXPECT_GT(touching, 0);
}

/// Every a with every b, in one call, sorted by row and in another order.
void expect_independent(const std::vector<Case>& cases) {
  std::vector<double> rows_a, rows_b;
  std::vector<Pair> pairs;
  const Layout layout_a = cases[0].a.layout, layout_b = cases[0].b.layout;
  const ContactQuestion& question = cases[0].question;
  std::vector<std::array<Object, 2>> objects;
  for (const Case& c : cases) {
    objects.push_back({c.a, c.b});
    objects.back()[0].layout = layout_a, objects.back()[1].layout = layout_b;
    const std::vector<double> row_a = objects.back()[0].row(), row_b = objects.back()[1].row();
    rows_a.insert(rows_a.end(), row_a.begin(), row_a.end());
    rows_b.insert(rows_b.end(), row_b.begin(), row_b.end());
  }
  for (std::uint32_t i = 0; i < cases.size(); ++i)
    for (std::uint32_t j = 0; j < cases.size(); ++j)
      pairs.push_back({i, (i + j) % static_cast<std::uint32_t>(cases.size())});
  const Bodies a(layout_a, rows_a.data(), cases.size()), b(layout_b, rows_b.data(), cases.size());
  const auto together = make_contact(a, b, question, "a", "b");
  for (int round = 0; round < 2; ++round) {
    std::vector<Pair> hits, decided, right;
    std::vector<ContactTimes> times;
    together->first_contacts(pairs, TimesWanted::both, hits, times);
    together->decide(pairs, decided);
    EXPECT_EQ(decided, hits);
    for (const Pair& pair : pairs) {
      const auto alone = contact(objects[pair.a][0], objects[pair.b][1], question);
      if (!alone) continue;
      ASSERT_LT(right.size(), times.size());
      const ContactTimes& all = times[right.size()];
      EXPECT_EQ(all.t, alone->t);
      EXPECT_EQ(all.dt_end, alone->dt_end);
      right.push_back(pair);
    }
    EXPECT_EQ(hits, right);
    std::reverse(pairs.begin(), pairs.end());
  }
}

/// Law 16.
TEST(Laws, OtherPairsOfTheCallDoNotMatter) {
  std::uint64_t seed = 90000;
  const auto check_scene = [&](const Scenery& scenery, const Family& family) {
    Generator generate(family, seed++);
    std::vector<Case> cases;
    while (cases.size() < (sanitized ? 3 : 6))
      cases.push_back(make_case(generate, family, scenery.first, scenery.second));
    expect_independent(cases);
  };
  for (int round = 0; round < scaled_count(1); ++round)
    for (const Scenery& scenery : all_sceneries())
      for (const auto& families : {ordinary_families(), growing_families()})
        for (const Family& family : families) {
          check_scene(scenery, family);
          if (::testing::Test::HasFailure()) return;
        }
}

}  // namespace
}  // namespace foresee
