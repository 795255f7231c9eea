// Contacts of movers with legs against rational numbers: each contact of the union of the legs, and its times.
#include "query/legs/mover_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/plan/plan_legs.h"
#include "query/legs/leg_oracle.h"

namespace foresee {
namespace {

using leg_oracle::Meeting;
using leg_oracle::Spans;

bool equal(const ContactTimes& a, const ContactTimes& b) {
  return a.t == b.t && a.t_end == b.t_end && a.dt == b.dt && a.dt_end == b.dt_end;
}

/// Compares engine and oracle; `exact`: all times are doubles, so that the union of real numbers is the answer too.
/// Returns the contacts.
std::vector<ContactTimes> checked(const Meeting& meeting, bool exact = true) {
  std::vector<LegContact> legs = leg_oracle::contacts_of_legs(meeting);
  std::vector<LegContact> shuffled(legs.rbegin(), legs.rend());
  const std::vector<ContactTimes> found = mover_contacts(legs);
  const std::vector<ContactTimes> again = mover_contacts(shuffled);
  EXPECT_TRUE(std::equal(found.begin(), found.end(), again.begin(), again.end(), equal));
  Spans spans;
  const auto oracle = leg_oracle::oracle_of(meeting, &spans);
  EXPECT_TRUE(oracle) << "a time is not rational\n" << meeting;
  if (!oracle) return found;
  const bool agrees = std::equal(found.begin(), found.end(), oracle->begin(), oracle->end(), equal);
  EXPECT_TRUE(agrees) << found.size() << " contacts, the oracle has " << oracle->size() << '\n' << meeting;
  if (!exact) return found;
  spans = leg_oracle::union_of(std::move(spans));
  EXPECT_EQ(found.size(), spans.size()) << meeting;
  for (std::size_t i = 0; i < std::min(found.size(), spans.size()); ++i) {
    EXPECT_EQ(judge::rational(found[i].t), spans[i].begin) << meeting;
    EXPECT_EQ(judge::rational(found[i].t_end), spans[i].end) << meeting;
  }
  return found;
}

std::vector<Leg> legs_through(std::vector<Knot> knots, std::vector<std::size_t> part_starts = {0}) {
  const Plan plan{
      .kind = PlanKind::knots, .axes = 2, .knots = std::move(knots), .part_starts = std::move(part_starts)};
  check_plan(plan);
  return legs_of(plan);
}

/// A mover that rests permanently.
std::vector<Leg> resting_at(double x, double y) {
  return {{.t = 0, .x = {x, y, 0}}};
}

TEST(MoverContacts, AtAJointAlone) {
  const auto found =
      checked({legs_through({{0, {0, 5}}, {4, {4, 1}}, {8, {8, 5}}}), resting_at(4, 0), 0, 10});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].t, 4);
  EXPECT_EQ(found[0].t_end, 4);
}

TEST(MoverContacts, ThroughJointsOfBothAtOnce) {
  const auto found = checked({legs_through({{0, {0, 0}}, {4, {4, 0}}, {8, {4, 4}}}),
                              legs_through({{0, {8, 0}}, {4, {5, 0}}, {8, {5, 4}}}), 0, 8});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].t, 4);
  EXPECT_EQ(found[0].t_end, 8);
}

TEST(MoverContacts, WhereTwoExchangeTheirPlacesByJumps) {
  const auto found =
      checked({legs_through({{0, {0, 0}}, {4, {0, 0}}, {4, {9, 9}}, {8, {9, 9}}}, {0, 2}),
               legs_through({{0, {9, 9}}, {4, {9, 9}}, {4, {0, 0}}, {8, {0, 0}}}, {0, 2}), 0, 8});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].t, 4);
  EXPECT_EQ(found[0].t_end, 4);
}

TEST(MoverContacts, WhereOneEndsAsTheOtherStarts) {
  const auto found =
      checked({legs_through({{0, {0, 0}}, {4, {4, 0}}}), legs_through({{4, {4, 0}}, {9, {9, 9}}}), 0, 20});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].t_end, 4);
}

TEST(MoverContacts, WithTheHorizonAtAJoint) {
  const std::vector<Leg> path = legs_through({{0, {0, 5}}, {4, {4, 1}}, {8, {8, 5}}});
  EXPECT_EQ(checked({path, resting_at(4, 0), 4, 10}).size(), 1u);
  EXPECT_EQ(checked({path, resting_at(4, 0), 0, 4}).size(), 1u);
  EXPECT_EQ(checked({path, resting_at(4, 0), 4, 0}).size(), 1u);
  EXPECT_EQ(checked({path, resting_at(4, 0), 4.5, 10}).size(), 0u);
}

TEST(MoverContacts, InAGapOrAtAJumpWithoutHorizon) {
  const std::vector<Leg> path = legs_through(
      {{0, {0, 0}}, {2, {0, 0}}, {6, {0, 0}}, {6.5, {0, 0}}, {6.5, {9, 9}}, {8, {9, 9}}}, {0, 2, 4});
  EXPECT_EQ(checked({path, resting_at(0, 0), 3, 2}).size(), 0u);
  EXPECT_EQ(checked({path, resting_at(0, 0), 0, 20}).size(), 2u);
  EXPECT_EQ(checked({path, resting_at(0, 0), 6.5, 0}).size(), 1u);
  EXPECT_EQ(checked({path, resting_at(9, 9), 6.5, 0}).size(), 1u);
}

TEST(MoverContacts, OfAStopWithoutEnd) {
  const auto found =
      checked({legs_through({{0, {0, 0}}, {8, {8, 0}}, {no_end, {8, 0}}}), resting_at(8, 1), 2, 1000});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].t, 7);
  EXPECT_EQ(found[0].t_end, 1002);
}

TEST(MoverContacts, OverAHundredJoints) {
  std::vector<Knot> a, b;
  for (int i = 0; i <= 100; ++i) {
    const double t = i, y = i % 2;
    a.push_back({t, {t, y}}), b.push_back({t + 0.5, {t + 0.5, 0.5 - y}});
  }
  const auto found = checked({legs_through(a), legs_through(b), 0, 200});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].t, 0.5);
  EXPECT_EQ(found[0].t_end, 100);
}

/// Up and down past a box: two contacts of one pair of legs, which a third contact may join.
TEST(MoverContacts, OfOneBentLegAreNotJoined) {
  const std::vector<Leg> thrown = {
      {.t = 0, .until = 8, .x = {0, 0}, .v = {0, 16}, .a = {0, -4}}};  // 16 s - 2 s^2
  const auto found = checked({thrown, resting_at(0, 19), 0, 20, 5});
  EXPECT_EQ(found.size(), 2u);
  // Two contacts of one pair of legs that meet as doubles, and a third one that meets both.
  std::vector<LegContact> contacts = {{0, 0, {1, 2, 1, 2}}, {0, 0, {2, 3, 2, 3}}};
  EXPECT_EQ(mover_contacts(contacts).size(), 2u);
  contacts.push_back({0, 1, {1.5, 2.5, 1.5, 2.5}});
  ASSERT_EQ(mover_contacts(contacts).size(), 1u);
  EXPECT_TRUE(equal(mover_contacts(contacts)[0], {1, 3, 1, 3}));
}

std::vector<Leg> random_path(judge::Inputs& inputs, bool thirds) {
  std::vector<Knot> knots;
  std::vector<std::size_t> parts{0};
  double t = inputs.between(-4, 4) * 0.5;
  for (int i = inputs.between(2, 7); i > 0; --i) {
    const double x = inputs.between(-3, 3), y = inputs.between(-3, 3);
    knots.push_back({t, {thirds ? x / 3 : x, thirds ? y / 7 : y}});
    if (i > 3 && knots.size() - parts.back() > 1 && inputs.one_in(4)) {
      parts.push_back(knots.size());
      if (inputs.one_in(2)) t += 1;
      continue;
    }
    t += thirds ? inputs.between(1, 5) / 3.0 : std::ldexp(1, inputs.between(-1, 1));
  }
  if (inputs.one_in(4)) knots.push_back({no_end, knots.back().x});
  return legs_through(knots, parts);
}

TEST(MoverContacts, OfRandomPathsOfShortNumbers) {
  judge::Inputs inputs(41);
  int several = 0;
  for (int i = judge::cases(500); i > 0; --i) {
    Meeting meeting{random_path(inputs, false), random_path(inputs, false)};
    meeting.now = inputs.between(-4, 8) * 0.5, meeting.h = inputs.between(0, 12) * 0.5;
    meeting.reach = inputs.between(0, 4) * 0.5;
    several += checked(meeting, false).size() > 1;
    if (HasFailure()) return;
  }
  EXPECT_GE(several, judge::cases(500) / 50);
}

/// Velocities and times are rounded, so that legs end beside the next knot.
TEST(MoverContacts, OfRandomPathsOfRoundedNumbers) {
  judge::Inputs inputs(42);
  int contacts = 0;
  for (int i = judge::cases(500); i > 0; --i) {
    Meeting meeting{random_path(inputs, true), random_path(inputs, true)};
    meeting.now = inputs.between(-4, 8) / 3.0, meeting.h = inputs.between(0, 12) / 7.0;
    meeting.reach = inputs.between(0, 6) / 5.0;
    contacts += !checked(meeting, false).empty();
    if (HasFailure()) return;
  }
  EXPECT_GT(contacts, judge::cases(500) / 10);
}

/// Bent legs beside resting ones, with contacts at m - D to m - d and m + d to m + D.
TEST(MoverContacts, OfRandomBentLegs) {
  judge::Inputs inputs(43);
  int several = 0;
  for (int i = judge::cases(500); i > 0; --i) {
    const double m = inputs.between(0, 16) * 0.25, inner = inputs.between(0, 8) * 0.25,
                 outer = inner + inputs.between(1, 8) * 0.25;
    const double c = std::ldexp(1, inputs.between(-1, 1)), reach = c * (outer * outer - inner * inner) / 2;
    // c ((s - m)^2 - outer^2) + reach, from time 0 on
    Leg bent{.t = 0,
             .until = 8,
             .x = {c * (m * m - outer * outer) + reach, 0},
             .v = {-2 * c * m, 0},
             .a = {2 * c, 0}};
    Meeting meeting{{bent}, resting_at(0, 0), inputs.between(0, 8) * 0.5, inputs.between(0, 16) * 0.5, reach};
    if (inputs.one_in(2)) {  // the same leg, split at a time whose state doubles hold
      const double s = inputs.between(1, 15) * 0.5;
      Leg later = bent;
      later.t = s, later.x[0] = bent.x[0] + s * (bent.v[0] + c * s), later.v[0] = bent.v[0] + 2 * c * s;
      const auto whole = checked(meeting);
      meeting.a[0].until = s, meeting.a.push_back(later);
      const auto split = checked(meeting);
      ASSERT_TRUE(std::equal(whole.begin(), whole.end(), split.begin(), split.end(), equal)) << meeting;
    }
    several += checked(meeting).size() > 1;
    if (HasFailure()) return;
  }
  EXPECT_GT(several, judge::cases(500) / 12);
}

/// Contacts that doubles do not tell apart: the unit of the last place at now is 2.
TEST(MoverContacts, ThatRoundToTheSameTime) {
  const double now = 0x1p53;
  std::vector<Leg> path = {{.t = now, .until = now + 2, .x = {0, 0}, .v = {8, 0}},
                           {.t = now + 2, .until = now + 4, .x = {16, 0}, .v = {-8, 0}}};
  const auto found = checked({path, {{.t = now, .x = {4, 0}}}, now, 4, 1}, false);
  EXPECT_EQ(found.size(), 2u);
  const auto near = checked({path, {{.t = now, .x = {15, 0}}}, now, 4, 0.5}, false);
  EXPECT_EQ(near.size(), 1u);  // [1.81, 1.94] and [2.06, 2.19] after now round to one time
}

}  // namespace
}  // namespace foresee
