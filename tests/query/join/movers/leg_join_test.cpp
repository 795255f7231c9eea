// Joins of scenes with plans: every method, order and slab gives the plain answer, bit for bit.
#include <gtest/gtest.h>

#include "query/legs/leg_scenes.h"
#include "sanitized.h"

namespace foresee {
namespace {

using testing::LegWorld;
using testing::numbers_of;
using testing::plain_rows;
using testing::random_movers;
using testing::rows_in_order;
using testing::sorted_rows;

constexpr JoinMethod leg_methods[] = {JoinMethod::scan, JoinMethod::grid, JoinMethod::tree, JoinMethod::gpcd,
                                      JoinMethod::automatic};
constexpr JoinOrder orders[] = {JoinOrder::any, JoinOrder::by_t, JoinOrder::by_dt, JoinOrder::by_t_and_ids};

bool leg_rows_are_in_order(const std::vector<JoinRow>& rows, JoinOrder order) {
  return std::is_sorted(rows.begin(), rows.end(), [order](const JoinRow& l, const JoinRow& r) {
    if (order == JoinOrder::any) return false;
    if (order == JoinOrder::by_dt) return l.contact.dt < r.contact.dt;
    if (order == JoinOrder::by_t) return l.contact.t < r.contact.t;
    return std::tie(l.contact.t, l.a, l.b) < std::tie(r.contact.t, r.a, r.b);
  });
}

/// Compares one method and order with the plain answer; `what` names the case.
void expect_plain(JoinQuestion question, const std::vector<JoinRow>& plain, const std::string& what) {
  const std::vector<double> expected = numbers_of(plain);
  for (const JoinMethod method : leg_methods)
    for (const JoinOrder order : orders) {
      question.method = method, question.order = order;
      const std::string name =
          what + ", " + name_of(method) + ", order " + std::to_string(static_cast<int>(order));
      const std::vector<double> numbers = numbers_of(sorted_rows(question));
      const auto differ =
          std::mismatch(numbers.begin(), numbers.end(), expected.begin(), expected.end()).first;
      EXPECT_TRUE(numbers == expected) << name << ": " << numbers.size() << " numbers, " << expected.size()
                                       << " expected; they differ from number " << differ - numbers.begin();
      EXPECT_TRUE(leg_rows_are_in_order(rows_in_order(question), order)) << name;
    }
}

/// Random times, distances and bounds about scenes.
JoinQuestion random_question(judge::Inputs& inputs, bool thirds) {
  JoinQuestion question;
  question.now = inputs.between(-2, 10) / (thirds ? 3.0 : 2.0);
  question.h = inputs.one_in(8) ? 0 : inputs.between(1, 30) / (thirds ? 3.0 : 2.0);
  question.within = inputs.between(0, 3) * 0.25;
  if (inputs.one_in(3)) question.queried_t.min = question.now + inputs.between(0, 8) / 2.0;
  if (inputs.one_in(4)) question.queried_t.max = question.now + inputs.between(4, 16) / 2.0;
  if (inputs.one_in(5)) question.queried_dt = testing::after_now;
  if (inputs.one_in(5)) question.queried_dt.max = inputs.between(1, 10) / 2.0;
  question.all_contacts = inputs.one_in(2);
  question.wants.approach = inputs.one_in(4);
  return question;
}

const LegWorld worlds[] = {
    {},
    {.thirds = true},
    {.layout = {.axes = 2,
                .law = Law::accelerated,
                .shape = Shape::ball,
                .has_t = true,
                .has_until = true,
                .has_plan = true}},
    {.layout = {.axes = 1,
                .law = Law::uniform,
                .shape = Shape::point,
                .has_t = true,
                .has_until = true,
                .has_plan = true},
     .movers = 8},
    {.layout = {.axes = 3,
                .law = Law::accelerated,
                .shape = Shape::cylinder,
                .has_t = true,
                .has_until = true,
                .has_plan = true},
     .thirds = true,
     .side = 3},
    {.layout = {.axes = 2,
                .law = Law::uniform,
                .shape = Shape::box,
                .has_t = true,
                .has_until = true,
                .has_category = true,
                .has_mask = true,
                .has_plan = true},
     .max_legs = 20,
     .thirds = true},
};

bool may_meet(const Scene& a, std::int64_t id_a, const Scene& b, std::int64_t id_b) {
  const auto kinds = [](const Scene& scene, std::int64_t id) {
    const auto found = std::find(scene.ids.begin(), scene.ids.end(), id) - scene.ids.begin();
    const Bodies bodies = scene.bodies();
    return kinds_of(bodies.row(static_cast<std::size_t>(found)), bodies.at);
  };
  return foresee::may_meet(kinds(a, id_a), kinds(b, id_b));
}

std::vector<JoinRow> plain_rows_that_may_meet(const JoinQuestion& question) {
  std::vector<JoinRow> rows = plain_rows(question);
  const Scene &a = *question.a, &b = question.b ? *question.b : a;
  std::erase_if(rows, [&](const JoinRow& row) { return !may_meet(a, row.a, b, row.b); });
  return rows;
}

TEST(LegJoin, GivesThePlainAnswerWithinOneTable) {
  judge::Inputs inputs(61);
  std::size_t rows = 0;
  for (int i = judge::cases(240); i > 0; --i) {
    const LegWorld& world = worlds[static_cast<std::size_t>(i) % std::size(worlds)];
    JoinQuestion question = random_question(inputs, world.thirds);
    question.a = random_movers(world, inputs);
    const std::vector<JoinRow> plain = plain_rows_that_may_meet(question);
    rows += plain.size();
    expect_plain(question, plain, "case " + std::to_string(i));
    if (HasFailure()) return;
  }
  EXPECT_GT(rows, testing::sanitized ? 100u : 1000u);
}

TEST(LegJoin, GivesThePlainAnswerBetweenTwoTables) {
  judge::Inputs inputs(62);
  std::size_t rows = 0;
  for (int i = judge::cases(180); i > 0; --i) {
    LegWorld world = worlds[static_cast<std::size_t>(i) % std::size(worlds)];
    JoinQuestion question = random_question(inputs, world.thirds);
    question.a = random_movers(world, inputs);
    // Another table with plans, one without, or the same as two sides.
    if (i % 3 == 0) {
      question.b = question.a;
    } else {
      world.layout.has_plan = i % 3 == 1, world.first_id = 4, world.movers = 9;
      question.b = random_movers(world, inputs, "people");
      if (inputs.one_in(2)) std::swap(question.a, question.b);
    }
    const std::vector<JoinRow> plain = plain_rows_that_may_meet(question);
    rows += plain.size();
    expect_plain(question, plain, "case " + std::to_string(i));
    if (HasFailure()) return;
  }
  EXPECT_GT(rows, testing::sanitized ? 100u : 1000u);
}

TEST(LegJoin, OfOneIdOnEitherSide) {
  judge::Inputs inputs(63);
  std::size_t rows = 0;
  for (int i = judge::cases(120); i > 0; --i) {
    const LegWorld& world = worlds[static_cast<std::size_t>(i) % std::size(worlds)];
    JoinQuestion question = random_question(inputs, world.thirds);
    question.a = random_movers(world, inputs);
    if (inputs.one_in(3)) question.b = question.a;
    if (inputs.one_in(2)) question.only_a = inputs.between(1, 13);
    if (!question.only_a || inputs.one_in(3)) question.only_b = inputs.between(1, 13);
    const std::vector<JoinRow> plain = plain_rows_that_may_meet(question);
    rows += plain.size();
    expect_plain(question, plain, "case " + std::to_string(i));
    if (HasFailure()) return;
  }
  EXPECT_GT(rows, testing::sanitized ? 2u : 30u);
}

}  // namespace
}  // namespace foresee
