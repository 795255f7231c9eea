// Time slabs: however the horizon is cut, the rows are those of the join without slabs, in the requested
// order.
#include <gtest/gtest.h>

#include <cmath>

#include "query/join/join_plan.h"
#include "query/join_cases.h"

namespace foresee {
namespace {

using testing::after_now;
using testing::all_layouts;
using testing::all_scene_kinds;
using testing::discs;
using testing::name_of;
using testing::numbers_of;
using testing::question_about;
using testing::random_scene;
using testing::RandomScene;
using testing::rows_in_order;
using testing::rows_of;
using testing::scene_of;
using testing::SceneKind;

constexpr double inf = std::numeric_limits<double>::infinity();

bool are_in_order(const std::vector<JoinRow>& rows, JoinOrder order) {
  return std::is_sorted(rows.begin(), rows.end(), [order](const JoinRow& l, const JoinRow& r) {
    if (order == JoinOrder::by_dt) return l.contact.dt < r.contact.dt;
    if (order == JoinOrder::by_t) return l.contact.t < r.contact.t;
    return std::tuple(l.contact.t, l.a, l.b) < std::tuple(r.contact.t, r.a, r.b);
  });
}

/// Every order of the grid, which joins one slab after another, gives the rows of the join without slabs.
void expect_all_orders(JoinQuestion question, const std::string& what) {
  question.method = JoinMethod::scan;
  const auto scanned = numbers_of(rows_of(question));
  for (JoinMethod method : {JoinMethod::grid, JoinMethod::scan})
    for (JoinOrder order : {JoinOrder::by_t, JoinOrder::by_dt, JoinOrder::by_t_and_ids}) {
      if (method == JoinMethod::scan && order != JoinOrder::by_t_and_ids) continue;
      question.method = method, question.order = order;
      auto rows = rows_in_order(question);
      EXPECT_TRUE(are_in_order(rows, order)) << what << ", " << name_of(method);
      std::sort(rows.begin(), rows.end(),
                [](const JoinRow& l, const JoinRow& r) { return std::pair(l.a, l.b) < std::pair(r.a, r.b); });
      EXPECT_EQ(numbers_of(rows), scanned) << what << ", " << name_of(method);
    }
}

/// One layout in twelve, from number `first` on: every layout is tested, but not in every test.
std::vector<Layout> some_layouts(std::size_t first) {
  const std::vector<Layout> all = all_layouts();
  std::vector<Layout> some;
  for (std::size_t i = first; i < all.size(); i += 12) some.push_back(all[i]);
  return some;
}

TEST(JoinSlabs, GiveThePlainAnswerInEveryOrder) {
  std::size_t first = 0;
  for (SceneKind kind : all_scene_kinds)
    for (const Layout& layout : some_layouts(first++ % 12))
      expect_all_orders(
          question_about(random_scene({.layout = layout, .kind = kind, .count = 60, .seed = 5})),
          name_of(layout) + ", " + name_of(kind));
}

TEST(JoinSlabs, GiveThePlainAnswerAtTheEdgesOfTime) {
  std::size_t first = 0;
  for (double now : {0.0, -1.5, 1e9, 1e300})
    for (double h : {0.0, 5e-324, 4.0, 1e9})
      for (const Layout& layout : some_layouts(first++ % 12)) {
        JoinQuestion question = question_about(random_scene({.layout = layout, .count = 20, .seed = 6}));
        question.now = now, question.h = h;
        expect_all_orders(question,
                          name_of(layout) + ", now " + std::to_string(now) + ", h " + std::to_string(h));
      }
}

/// Its t is rounded to infinity; dt is the finite time.
TEST(JoinSlabs, HoldContactsThatStartAfterTheLastDouble) {
  JoinQuestion question{.a = scene_of({.axes = 1, .law = Law::uniform, .has_t = true}, {1, 2, 3},
                                      {1e308, 0, 1, 1e308, 1.2e308, 0, 1e308, 1e300, 0}),
                        .now = 1e308,
                        .h = 1.5e308};
  expect_all_orders(question, "now + h is no double");
  EXPECT_EQ(rows_of(question).size(), 2u);
}

TEST(JoinSlabs, LeaveOutTimesThatAreNotQueried) {
  for (double now : {0.0, 0.7, -3.0}) {
    RandomScene scene = random_scene({.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball},
                                      .kind = SceneKind::clustered,
                                      .count = 150,
                                      .seed = 7});
    JoinQuestion question = question_about(scene);
    question.now = now, question.h = std::abs(now) + 5, question.method = JoinMethod::scan;
    const auto all = rows_of(question);
    ASSERT_GT(all.size(), 30u);
    const ContactTimes one = all[all.size() / 3].contact, other = all[all.size() / 2].contact;
    const QueriedTimes t{std::min(one.t, other.t), std::max(one.t, other.t)},
        dt{std::min(one.dt, other.dt), std::max(one.dt, other.dt)};
    const std::pair<QueriedTimes, QueriedTimes> queried[] = {{t, {}},
                                                             {{}, dt},
                                                             {t, dt},
                                                             {{t.min, inf}, {}},
                                                             {{-inf, t.max}, {}},
                                                             {{}, {dt.min, dt.min}},
                                                             {{}, after_now},
                                                             {{}, {inf, inf}},
                                                             {{now + question.h, inf}, {}},
                                                             {{}, {1, 0}}};
    for (const auto& [queried_t, queried_dt] : queried) {
      std::vector<JoinRow> wanted;
      for (const JoinRow& row : all)
        if (queried_t.holds(row.contact.t) && queried_dt.holds(row.contact.dt)) wanted.push_back(row);
      JoinQuestion part = question;
      part.queried_t = queried_t, part.queried_dt = queried_dt;
      for (JoinMethod method : {JoinMethod::grid, JoinMethod::scan, JoinMethod::gpcd})
        for (JoinOrder order : {JoinOrder::any, JoinOrder::by_t}) {
          part.method = method, part.order = order;
          EXPECT_EQ(numbers_of(rows_of(part)), numbers_of(wanted)) << now << ", " << name_of(method);
        }
    }
  }
}

TEST(JoinSlabs, AreTakenWhereTheHorizonIsLong) {
  const RandomScene scene = random_scene({.layout = discs, .count = 2000, .seed = 8});
  JoinQuestion question = question_about(scene);
  const auto slabs = [&] { return plan_join(question).slabs; };
  EXPECT_EQ(slabs(), 1u);
  question.h = 100;
  EXPECT_GE(slabs(), 2u);
  const auto cut = numbers_of(rows_of(question));
  question.method = JoinMethod::scan;
  EXPECT_EQ(slabs(), 1u);
  EXPECT_EQ(cut, numbers_of(rows_of(question)));
}

TEST(JoinSlabs, OfTwoTablesGiveThePlainAnswer) {
  const RandomScene ships = random_scene({.layout = discs, .count = 900, .seed = 9});
  const RandomScene crates =
      random_scene({.layout = {.axes = 2, .shape = Shape::box}, .count = 700, .seed = 10});
  JoinQuestion question = question_about(ships);
  question.b = scene_of(crates, "crates");
  question.h = 300;
  EXPECT_GE(plan_join(question).slabs, 2u);
  const auto cut = numbers_of(rows_of(question));
  question.method = JoinMethod::scan;
  EXPECT_EQ(cut, numbers_of(rows_of(question)));
  question.b = question.a;
  const auto scanned = numbers_of(rows_of(question));
  question.method = JoinMethod::grid;
  EXPECT_EQ(numbers_of(rows_of(question)), scanned);
}

struct CountingInterrupt final : Interrupt {
  void check() override { ++checks; }
  std::size_t checks = 0;
};

TEST(JoinSlabs, GiveTheEarliestRowsWithoutComputingLaterOnes) {
  const RandomScene scene = random_scene({.layout = discs, .count = 5000, .seed = 11});
  JoinQuestion question = question_about(scene);
  question.h = 100, question.queried_dt = after_now, question.order = JoinOrder::by_t;
  CountingInterrupt interrupt;
  Join join(question, interrupt);
  ASSERT_FALSE(join.next().empty());
  const std::size_t first = interrupt.checks;
  while (!join.next().empty()) {
  }
  EXPECT_LT(first, interrupt.checks / 20);
}

TEST(TimeSlabs, FollowOneAnotherAndCoverTheHorizon) {
  for (double now : {0.0, -3.0, 1e9})
    for (bool instant : {false, true}) {
      const JoinQuestion question{.a = nullptr, .now = now, .h = 10};
      TimeSlabs slabs(question, {.step = 2, .first = 0.1, .instant = instant});
      double end = -inf;
      std::size_t count = 0;
      for (auto slab = slabs.next(); slab; slab = slabs.next(), ++count) {
        EXPECT_EQ(slab->from, end);
        EXPECT_LT(slab->from, slab->before);
        EXPECT_GE(slab->horizon.now, now);
        EXPECT_TRUE(count == 0 || slab->horizon.now < slab->from) << "times that round to it start earlier";
        EXPECT_GE(slab->horizon.now + slab->horizon.h, std::min(slab->before, now + 10));
        end = slab->before;
      }
      EXPECT_EQ(end, inf);
      EXPECT_EQ(count, instant ? 8u : 7u);  // 0.1, 0.8, then 2 each; the remainder is short
    }
}

TEST(TimeSlabs, OfOneLengthAreTheWholeHorizon) {
  for (double h : {0.0, 5e-324, 0.1, 3.0, 1e308})
    for (double now : {0.0, 0.1, -1e9, 1e308}) {
      TimeSlabs slabs({.a = nullptr, .now = now, .h = h}, {.step = inf, .first = inf});
      const auto slab = slabs.next();
      ASSERT_TRUE(slab);
      EXPECT_EQ(slab->horizon.now, now);
      EXPECT_EQ(slab->horizon.h, h);
      EXPECT_FALSE(slabs.next());
    }
}

}  // namespace
}  // namespace foresee
