// Contacts of movers with legs against rational numbers: each contact of the union of the legs, and its times.
#include "query/legs/mover_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "query/legs/leg_oracle.h"

namespace foresee {
namespace {

using leg_oracle::Meeting;
using leg_oracle::random_path;
using leg_oracle::resting_at;
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

TEST(MoverContacts, AtJointsJumpsAndGaps) {
  for (const auto& trap : leg_oracle::traps()) {
    std::vector<std::pair<double, double>> found;
    for (const ContactTimes& times : checked(trap.meeting)) found.emplace_back(times.t, times.t_end);
    EXPECT_EQ(found, trap.contacts) << trap.name;
  }
}

TEST(MoverContacts, OverAHundredJoints) {
  const auto found = checked(leg_oracle::zigzags());
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
