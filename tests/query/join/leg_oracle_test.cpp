// Joins of plans against rational numbers: traps, and random paths, by every method, for first and for all contacts.
#include "query/legs/leg_oracle.h"

#include <gtest/gtest.h>

#include "query/legs/leg_scenes.h"

namespace foresee {
namespace {

using leg_oracle::legs_through;
using leg_oracle::Meeting;
using leg_oracle::random_path;
using leg_oracle::resting_at;
using leg_oracle::Spans;
using testing::numbers_of;
using testing::sorted_rows;

constexpr Layout points{
    .axes = 2, .law = Law::accelerated, .has_t = true, .has_until = true, .has_plan = true};

/// A table of one mover with this id and half extent.
std::shared_ptr<const Scene> table_of(const std::vector<Leg>& legs, Shape shape, double half, std::int64_t id,
                                      double until = no_end) {
  auto scene = std::make_shared<Scene>();
  scene->name = "movers", scene->layout = points, scene->layout.shape = shape;
  const Offsets at = record_offsets(scene->layout);
  std::vector<double> record(static_cast<std::size_t>(at.size));
  record[static_cast<std::size_t>(at.until)] = until;
  record[static_cast<std::size_t>(at.plan)] = record[static_cast<std::size_t>(at.chunks)] = 1;
  for (int axis = 0; axis < 2 && at.half != Offsets::absent; ++axis)
    record[static_cast<std::size_t>(at.half + axis)] = half;
  scene->add(id, record.data(), legs);
  return scene;
}

JoinQuestion question_of(const Meeting& meeting) {
  return {.a = table_of(meeting.a, Shape::point, 0, 1),
          .b = table_of(meeting.b, Shape::box, meeting.reach, 2),
          .now = meeting.now,
          .h = meeting.h,
          .wants = {.approach = false}};
}

/// Compares the contacts by every method and order with the oracle's, which it returns.
std::vector<ContactTimes> checked(const Meeting& meeting) {
  Spans spans;
  const auto oracle = leg_oracle::oracle_of(meeting, &spans);
  EXPECT_TRUE(oracle) << "a time is not rational\n" << meeting;
  if (!oracle) return {};
  JoinQuestion question = question_of(meeting);
  for (const bool all : {false, true}) {
    std::vector<JoinRow> expected;
    for (const ContactTimes& times : *oracle) {
      if (!all && !expected.empty()) break;
      JoinRow row;
      row.a = 1, row.b = 2, row.contact = times, row.approach = {0, 0, 0};
      if (!expected.empty() && expected.back().contact.t == times.t &&
          expected.back().contact.t_end == times.t_end)
        expected.back().contact.dt_end = times.dt_end;
      else
        expected.push_back(row);
    }
    question.all_contacts = all;
    for (const JoinMethod method : {JoinMethod::scan, JoinMethod::grid, JoinMethod::tree, JoinMethod::gpcd})
      for (const JoinOrder order : {JoinOrder::any, JoinOrder::by_t}) {
        question.method = method, question.order = order;
        EXPECT_EQ(numbers_of(sorted_rows(question)), numbers_of(expected))
            << name_of(method) << ", all contacts: " << all << '\n'
            << meeting;
      }
  }
  return *oracle;
}

TEST(LegOracle, TrapsAtJointsJumpsAndGaps) {
  for (const auto& trap : leg_oracle::traps())
    EXPECT_EQ(checked(trap.meeting).size(), trap.contacts.size()) << trap.name;
}

TEST(LegOracle, AContactOverAHundredJoints) {
  const Meeting meeting = leg_oracle::zigzags();
  ASSERT_EQ(checked(meeting).size(), 1u);
  // Where t is bounded from below, the contact is neither new nor the first one.
  JoinQuestion question = question_of(meeting);
  for (const bool all : {false, true})
    for (const double min : {0.5, 0.75, 60.0})
      for (const JoinMethod method :
           {JoinMethod::scan, JoinMethod::grid, JoinMethod::tree, JoinMethod::gpcd}) {
        question.method = method, question.all_contacts = all, question.queried_t.min = min;
        EXPECT_EQ(sorted_rows(question).size(), min == 0.5 ? 1u : 0u) << name_of(method) << min << all;
      }
}

TEST(LegOracle, ContactsThatRoundToTheSameTime) {
  const double now = 0x1p53;
  const std::vector<Leg> path = {{.t = now, .until = now + 2, .x = {0, 0}, .v = {8, 0}},
                                 {.t = now + 2, .until = now + 4, .x = {16, 0}, .v = {-8, 0}}};
  checked({path, {{.t = now, .x = {4, 0}}}, now, 4, 1});
  checked({path, {{.t = now, .x = {15, 0}}}, now, 4, 0.5});
}

TEST(LegOracle, LegsOfANanosecondBesideLegsOfAYear) {
  const double year = 0x1p25, tiny = 0x1p-30;
  std::vector<Leg> path = {{.t = 0, .until = tiny, .x = {0, 0}, .v = {0x1p30, 0}},
                           {.t = tiny, .until = 2 * tiny, .x = {1, 0}, .v = {-0x1p30, 0}},
                           {.t = 2 * tiny, .until = year, .x = {0, 0}, .v = {0x1p-20, 0}},
                           {.t = year, .until = year, .x = {32, 0}}};
  EXPECT_EQ(checked({path, resting_at(1, 0), 0, 2 * year, 0.25}).size(), 2u);
  EXPECT_EQ(checked({path, resting_at(32, 0), 0, 2 * year, 0}).size(), 1u);
  EXPECT_EQ(checked({path, resting_at(40, 0), 0, 2 * year, 0.5}).size(), 0u);
}

TEST(LegOracle, UntilCutsAPlan) {
  const std::vector<Leg> path = legs_through({{0, {0, 0}}, {4, {4, 0}}, {8, {8, 0}}});
  JoinQuestion question = question_of({path, resting_at(6, 0), 0, 20, 1});
  for (const auto& [until, rows] :
       {std::pair(4.0, 0u), {5.0, 1u}, {4.5, 0u}, {0.0, 0u}, {-1.0, 0u}, {9.0, 1u}})
    for (const JoinMethod method : {JoinMethod::scan, JoinMethod::grid, JoinMethod::tree}) {
      question.a = table_of(path, Shape::point, 0, 1, until), question.method = method;
      const std::vector<JoinRow> found = sorted_rows(question);
      ASSERT_EQ(found.size(), rows) << until;
      for (const JoinRow& row : found) EXPECT_EQ(row.contact.t_end, std::min(until, 7.0));
    }
}

TEST(LegOracle, RandomPaths) {
  judge::Inputs inputs(81);
  int several = 0;
  for (int i = judge::cases(400); i > 0; --i) {
    const bool thirds = inputs.one_in(2);
    Meeting meeting{random_path(inputs, thirds), random_path(inputs, thirds)};
    const double part = thirds ? 7 : 2;
    meeting.now = inputs.between(-4, 8) / part, meeting.h = inputs.between(0, 24) / part;
    meeting.reach = inputs.between(0, 4) * (thirds ? 0.2 : 0.5);
    several += checked(meeting).size() > 1;
    if (HasFailure()) return;
  }
  EXPECT_GE(several, judge::cases(400) / 50);
}

/// Plans of one leg give the bits of plain rows.
TEST(LegOracle, OneLegIsAPlainRow) {
  judge::Inputs inputs(82);
  std::size_t rows = 0;
  for (int i = judge::cases(60); i > 0; --i) {
    testing::LegWorld world{.movers = 30, .max_legs = 1, .thirds = inputs.one_in(2)};
    if (inputs.one_in(2)) world.layout.law = Law::accelerated;
    const auto movers = testing::random_movers(world, inputs);
    auto plain = std::make_shared<Scene>();
    plain->name = movers->name, plain->layout = movers->layout, plain->layout.has_plan = false;
    plain->ids = movers->ids, plain->rows = movers->rows;
    JoinQuestion question{.a = movers, .now = inputs.between(0, 6) / 2.0, .h = inputs.between(0, 12) / 2.0};
    question.all_contacts = inputs.one_in(2);
    JoinQuestion of_rows = question;
    of_rows.a = plain;
    for (const JoinMethod method : {JoinMethod::scan, JoinMethod::grid}) {
      question.method = of_rows.method = method;
      const std::vector<JoinRow> expected = sorted_rows(of_rows);
      rows += expected.size();
      ASSERT_EQ(numbers_of(sorted_rows(question)), numbers_of(expected));
    }
  }
  EXPECT_GT(rows, 100u);
}

}  // namespace
}  // namespace foresee
