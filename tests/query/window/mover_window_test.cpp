// Windows over movers with plans: the contacts of all their legs, merged, from scenes and from both trees.
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <tuple>

#include "query/distinct_contacts.h"
#include "query/legs/mover_contacts.h"
#include "query/plan_cases.h"
#include "query/window/window.h"
#include "shape/outline/wkt.h"

namespace foresee::testing {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

using ContactRow = std::tuple<std::int64_t, double, double, double, double>;

std::vector<ContactRow> window_rows(const WindowQuestion& question) {
  NeverInterrupt never;
  Window window(question, never);
  std::vector<ContactRow> all;
  for (auto rows = window.next(); !rows.empty(); rows = window.next())
    for (const auto& [id, c] : rows) all.emplace_back(id, c.t, c.t_end, c.dt, c.dt_end);
  std::sort(all.begin(), all.end());
  return all;
}

/// The plain answer: every contact of every leg with the window, merged by rule 3.
std::vector<ContactRow> plain_rows(const Movers& movers, const WindowQuestion& question) {
  const Horizon horizon{question.now, question.h};
  std::vector<ContactRow> all;
  for (const Mover& mover : movers.all) {
    const Scene rows = legs_as_rows(movers.layout, mover);
    const Bodies bodies = rows.bodies();
    if (question.mask && !KindTest::of_categories(*question.mask).accepts(kinds_of(bodies.row(0), bodies.at)))
      continue;
    const MovingWindow window(question.faces, rows.layout, question.now, question.zone);
    const auto contact = make_window_contact(window, bodies, horizon);
    std::vector<Pair> pairs, hits;
    std::vector<ContactTimes> times;
    for (std::uint32_t row = 0; row < rows.size(); ++row) pairs.push_back({0, row});
    if (question.zone)
      contact->first_contacts(pairs, TimesWanted::both, hits, times);
    else
      contact->all_contacts(pairs, hits, times);
    std::vector<LegContact> contacts;
    for (std::size_t i = 0; i < hits.size(); ++i) contacts.push_back({0, hits[i].b, times[i]});
    std::vector<ContactTimes> merged = mover_contacts(contacts);
    if (!question.all_contacts && merged.size() > 1) merged.resize(1);
    std::vector<Pair> same(merged.size());
    join_equal_contacts(0, same, merged);
    for (const ContactTimes& c : merged) all.emplace_back(mover.id, c.t, c.t_end, c.dt, c.dt_end);
  }
  std::sort(all.begin(), all.end());
  return all;
}

WindowQuestion random_window(PlanMaker& maker, const Layout& layout, int i) {
  WindowQuestion question{
      .objects = {}, .now = maker.time(-8, 40), .h = i % 4 == 0 ? 0 : maker.number(0, 24)};
  const std::array<double, 3> at = maker.place();
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(layout.axes); ++axis) {
    question.faces.lower[axis] = at[axis], question.faces.upper[axis] = at[axis] + maker.number(0, 16);
    if (i % 3 == 0) question.faces.velocity[axis] = maker.number(-3, 3);
  }
  if (i % 7 == 6) question.faces.lower[0] = -unbounded;
  if (i % 11 == 10) question.faces = {};
  if (layout.has_category && i % 2) question.mask = static_cast<std::uint32_t>(1 + i % 5);
  return question;
}

class WindowOfMovers : public ::testing::TestWithParam<Layout> {};

TEST_P(WindowOfMovers, IsTheUnionOfTheLegs) {
  std::size_t found = 0, merged = 0;
  for (const PlanNumbers numbers : all_plan_numbers)
    for (std::uint64_t seed = 1; seed <= (sanitized ? 1 : 4); ++seed) {
      const Movers movers = random_movers(GetParam(), numbers, 60, seed);
      const auto table = table_of(movers);
      PlanMaker maker(GetParam(), numbers, seed + 100);
      for (int i = 0; i < 24; ++i) {
        WindowQuestion question = random_window(maker, GetParam(), i);
        const auto first = plain_rows(movers, question);
        question.all_contacts = true;
        const auto all = plain_rows(movers, question);
        for (const SearchTarget& target : targets_of(*table, {question.now, question.h})) {
          question.objects = target;
          question.all_contacts = true;
          ASSERT_EQ(window_rows(question), all) << seed << ' ' << i << (target.scene ? " scene" : " trees");
          question.all_contacts = false;
          ASSERT_EQ(window_rows(question), first) << seed << ' ' << i << (target.scene ? " scene" : " trees");
          question.wants = {.starts = true, .ends = false};
          std::set<std::tuple<std::int64_t, double, double>> starts, wanted;
          for (const auto& [id, t, t_end, dt, dt_end] : window_rows(question)) starts.emplace(id, t, dt);
          for (const auto& [id, t, t_end, dt, dt_end] : first) wanted.emplace(id, t, dt);
          ASSERT_EQ(starts, wanted) << seed << ' ' << i;
          question.wants = {.starts = false, .ends = false};
          std::set<std::int64_t> ids, wanted_ids;
          for (const auto& row : window_rows(question)) ids.insert(std::get<0>(row));
          for (const auto& row : first) wanted_ids.insert(std::get<0>(row));
          ASSERT_EQ(ids, wanted_ids) << seed << ' ' << i;
          question.wants = {};
        }
        found += first.size(), merged += all.size() - first.size();
      }
    }
  EXPECT_GT(found, sanitized ? 100u : 500u);
  EXPECT_GT(merged, 50u);
}

/// A zone with a corner inwards: a leg may enter it twice, and the first contact ends where the mover leaves it.
TEST_P(WindowOfMovers, MayBeAZone) {
  if (GetParam().axes != 2) return;
  const auto zone = std::make_shared<const SharedOutline>(
      read_outline("POLYGON((-4 -4, 8 -4, 8 0, 0 0, 0 8, -4 8, -4 -4))"));
  std::size_t found = 0;
  for (const PlanNumbers numbers : all_plan_numbers) {
    const Movers movers = random_movers(GetParam(), numbers, 60, 9);
    const auto table = table_of(movers);
    PlanMaker maker(GetParam(), numbers, 10);
    for (int i = 0; i < 20; ++i) {
      WindowQuestion question{
          .objects = {}, .now = maker.time(-8, 40), .h = maker.number(0, 24), .zone = zone};
      const auto wanted = plain_rows(movers, question);
      for (const SearchTarget& target : targets_of(*table, {question.now, question.h})) {
        question.objects = target;
        ASSERT_EQ(window_rows(question), wanted) << i << (target.scene ? " scene" : " trees");
      }
      found += wanted.size();
    }
  }
  EXPECT_GT(found, 100u);
}

/// Thousands of legs among plain rows.
TEST(MoverWindow, OfOneLongPlan) {
  const Layout layout = layouts_with_plans()[1];
  PlanMaker maker(layout, PlanNumbers::thirds, 11);
  Movers movers = random_movers(layout, PlanNumbers::thirds, 20, 12);
  Mover patrol = maker.mover(99, false);
  patrol.legs.clear();
  std::array<double, 3> x = maker.place();
  for (int i = 0; i < 5000; ++i) {
    const std::array<double, 3> to = maker.place();
    Leg leg{.t = i / 3.0, .until = (i + 1) / 3.0, .x = x, .v = {}, .a = {}};
    for (const std::size_t j : {0, 1}) leg.v[j] = velocity_between(x[j], to[j], leg.t, leg.until);
    patrol.legs.push_back(leg);
    x = to;
  }
  patrol.record[static_cast<std::size_t>(record_offsets(layout).until)] = no_end;
  movers.all.push_back(patrol);
  const auto table = table_of(movers);
  std::size_t found = 0;
  for (int i = 0; i < 30; ++i) {
    WindowQuestion question = random_window(maker, layout, i);
    question.now = maker.number(0, 5000), question.all_contacts = i % 2;
    if (i % 6 == 5) question.h = 200;
    const auto wanted = plain_rows(movers, question);
    for (const SearchTarget& target : targets_of(*table, {question.now, question.h})) {
      question.objects = target;
      ASSERT_EQ(window_rows(question), wanted) << i << (target.scene ? " scene" : " trees");
    }
    found += wanted.size();
  }
  EXPECT_GT(found, 50u);
}

INSTANTIATE_TEST_SUITE_P(Layouts, WindowOfMovers, ::testing::ValuesIn(layouts_with_plans()));

constexpr Layout on_plane{.axes = 2, .law = Law::uniform, .has_t = true, .has_until = true, .has_plan = true};

constexpr WindowFaces square{.lower = {0, 0, -unbounded}, .upper = {2, 2, unbounded}};

/// The contacts of one mover of these knots with the square, by two trees.
std::vector<ContactRow> contacts_of_path(std::vector<Knot> knots, std::vector<std::size_t> parts, double now,
                                         double h) {
  const Plan plan{
      .kind = PlanKind::knots, .axes = 2, .knots = std::move(knots), .part_starts = std::move(parts)};
  check_plan(plan);
  MemoryTable table("robots", on_plane);
  std::vector<double> record(static_cast<std::size_t>(record_offsets(on_plane).size));
  record[static_cast<std::size_t>(record_offsets(on_plane).until)] = unbounded;
  table.put(1, record, legs_of(plan));
  return window_rows({.objects = {"robots", nullptr, table.tree(), table.chunks()},
                      .now = now,
                      .h = h,
                      .faces = square,
                      .all_contacts = true});
}

TEST(MoverWindow, OfAJointAGapAndAJump) {
  const auto rows = [](std::initializer_list<ContactRow> list) { return std::vector<ContactRow>(list); };
  const std::vector<Knot> corner = {{0, {5, 5}}, {4, {2, 2}}, {8, {5, 5}}};
  EXPECT_EQ(contacts_of_path(corner, {0}, 0, 20), rows({{1, 4, 4, 4, 4}}));
  EXPECT_EQ(contacts_of_path(corner, {0}, 4, 0), rows({{1, 4, 4, 0, 0}}));
  EXPECT_EQ(contacts_of_path(corner, {0}, 0, 4), rows({{1, 4, 4, 4, 4}}));
  EXPECT_EQ(contacts_of_path(corner, {0}, 4.5, 9), rows({}));
  const std::vector<Knot> gap = {{0, {1, 1}}, {4, {1, 1}}, {6, {1, 1}}, {9, {1, 1}}};
  EXPECT_EQ(contacts_of_path(gap, {0, 2}, 4.5, 1), rows({}));
  EXPECT_EQ(contacts_of_path(gap, {0, 2}, 0, 20), rows({{1, 0, 4, 0, 4}, {1, 6, 9, 6, 9}}));
  const std::vector<Knot> jump = {{0, {9, 9}}, {4, {9, 9}}, {4, {1, 1}}, {unbounded, {1, 1}}};
  EXPECT_EQ(contacts_of_path(jump, {0, 2}, 4, 0), rows({{1, 4, 4, 0, 0}}));
  EXPECT_EQ(contacts_of_path(jump, {0, 2}, 1, 100), rows({{1, 4, 101, 3, 100}}));
}

}  // namespace
}  // namespace foresee::testing
