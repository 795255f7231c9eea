// Joins of plans against rational numbers: traps, and random paths, by every method, for first and for all contacts.
#include "query/legs/leg_oracle.h"

#include <gtest/gtest.h>

#include "query/legs/leg_scenes.h"

namespace foresee {
namespace {

using leg_oracle::Meeting;
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

std::vector<Leg> legs_through(std::vector<Knot> knots, std::vector<std::size_t> part_starts = {0}) {
  const Plan plan{
      .kind = PlanKind::knots, .axes = 2, .knots = std::move(knots), .part_starts = std::move(part_starts)};
  check_plan(plan);
  return legs_of(plan);
}

std::vector<Leg> resting_at(double x, double y) {
  return {{.t = 0, .x = {x, y, 0}}};
}

TEST(LegOracle, TrapsAtJointsJumpsAndGaps) {
  const std::vector<Leg> path = legs_through({{0, {0, 5}}, {4, {4, 1}}, {8, {8, 5}}});
  EXPECT_EQ(checked({path, resting_at(4, 0), 0, 10}).size(), 1u) << "at a joint alone";
  for (const auto& [now, h] : {std::pair(4.0, 10.0), {0.0, 4.0}, {4.0, 0.0}})
    EXPECT_EQ(checked({path, resting_at(4, 0), now, h}).size(), 1u) << "the horizon at a joint";
  EXPECT_EQ(checked({path, resting_at(4, 0), 4.5, 10}).size(), 0u);
  EXPECT_EQ(checked({legs_through({{0, {0, 0}}, {4, {4, 0}}, {8, {4, 4}}}),
                     legs_through({{0, {8, 0}}, {4, {5, 0}}, {8, {5, 4}}}), 0, 8})
                .size(),
            1u)
      << "through joints of both at once";
  EXPECT_EQ(checked({legs_through({{0, {0, 0}}, {4, {0, 0}}, {4, {9, 9}}, {8, {9, 9}}}, {0, 2}),
                     legs_through({{0, {9, 9}}, {4, {9, 9}}, {4, {0, 0}}, {8, {0, 0}}}, {0, 2}), 0, 8})
                .size(),
            1u)
      << "two exchange their places by jumps";
  const std::vector<Leg> gaps = legs_through(
      {{0, {0, 0}}, {2, {0, 0}}, {6, {0, 0}}, {6.5, {0, 0}}, {6.5, {9, 9}}, {8, {9, 9}}}, {0, 2, 4});
  EXPECT_EQ(checked({gaps, resting_at(0, 0), 3, 2}).size(), 0u) << "a horizon wholly in a gap";
  EXPECT_EQ(checked({gaps, resting_at(0, 0), 0, 20}).size(), 2u);
  EXPECT_EQ(checked({gaps, resting_at(9, 9), 6.5, 0}).size(), 1u) << "no horizon, at a jump";
  EXPECT_EQ(
      checked({legs_through({{0, {0, 0}}, {4, {4, 0}}}), legs_through({{4, {4, 0}}, {9, {9, 9}}}), 0, 20})
          .size(),
      1u)
      << "one ends as the other starts";
  EXPECT_EQ(
      checked({legs_through({{0, {0, 0}}, {8, {8, 0}}, {no_end, {8, 0}}}), resting_at(8, 1), 2, 1000}).size(),
      1u)
      << "a stop without end";
}

TEST(LegOracle, AContactOverAHundredJoints) {
  std::vector<Knot> a, b;
  for (int i = 0; i <= 100; ++i) {
    const double t = i, y = i % 2;
    a.push_back({t, {t, y}}), b.push_back({t + 0.5, {t + 0.5, 0.5 - y}});
  }
  const Meeting meeting{legs_through(a), legs_through(b), 0, 200};
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

std::vector<Leg> random_path(judge::Inputs& inputs, bool thirds) {
  std::vector<Leg> legs;
  while (legs.empty()) {
    std::vector<Knot> knots;
    std::vector<std::size_t> parts{0};
    double t = inputs.between(-4, 4) * 0.5;
    for (int i = inputs.between(2, 9); i > 0; --i) {
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
    legs = legs_through(knots, parts);
  }
  return legs;
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
