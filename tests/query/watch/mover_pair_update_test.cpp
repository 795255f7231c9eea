// A watch over movers with plans. After every update its rows are the first contacts of the plain answer, all pairs
// of legs merged. A new plan is a changed object.
#include <gtest/gtest.h>

#include "query/plan_cases.h"
#include "query/watch/watched.h"

namespace foresee::testing {
namespace {

constexpr Layout planned{
    .axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true, .has_until = true, .has_plan = true};

using Current = std::map<std::int64_t, Mover>;

/// The time of the first contact of two movers.
std::optional<double> plain_contact(const Mover& a, const Mover& b, const Horizon& horizon, double within) {
  const Scene legs_a = legs_as_rows(planned, a), legs_b = legs_as_rows(planned, b);
  const auto contacts = plain_contacts(legs_a.bodies(), legs_b.bodies(), horizon, within);
  return contacts.empty() ? std::nullopt : std::optional(contacts.front().t);
}

std::map<MemoryWatch::Ids, double> plain_pairs(const Current& ships, const Current* ferries,
                                               const Horizon& horizon, double within) {
  std::map<MemoryWatch::Ids, double> pairs;
  for (const auto& [a, mover_a] : ships)
    for (const auto& [b, mover_b] : ferries ? *ferries : ships) {
      if (!ferries && b <= a) continue;
      if (const auto t = plain_contact(mover_a, mover_b, horizon, within)) pairs[{a, b}] = *t;
    }
  return pairs;
}

class PairUpdateOfPlans : public ::testing::TestWithParam<bool> {};

TEST_P(PairUpdateOfPlans, EveryUpdateGivesThePlainContacts) {
  std::size_t reported = 0;
  const bool between = GetParam();
  for (std::uint64_t seed = 1; seed <= (sanitized ? 2 : 8); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const double within = seed % 3 == 0 ? 0.75 : 0;
    Watched watched(between, {.tbl = "ships", .horizon = 6, .within = within, .manual = true}, planned);
    PlanMaker maker(planned, seed % 2 ? PlanNumbers::halves : PlanNumbers::thirds, seed);
    Random& random = maker.random;
    Current ships, ferries;
    double clock = -4;
    for (int step = 0; step < 40; ++step, clock += maker.number(0, step % 10 == 9 ? 12 : 2)) {
      const std::uint64_t many = step == 0 ? 40 : step % 15 == 14 ? 20 : random.below(4);
      for (std::uint64_t i = 0; i < many; ++i) {
        const bool is_ship = !between || random.below(2) == 0;
        MemoryTable& table = is_ship ? *watched.ships : *watched.ferries;
        Current& current = is_ship ? ships : ferries;
        const auto id = static_cast<std::int64_t>(1 + random.below(30));
        if (random.below(8) == 0) {
          table.erase(id);
          current.erase(id);
          continue;
        }
        const Mover mover = maker.mover(id, random.below(4) == 0);
        table.put(id, mover.record, mover.legs);
        current.insert_or_assign(id, mover);
      }
      watched.state.requested_clock = clock;
      watched.update();
      watched.expect_pairs(plain_pairs(ships, between ? &ferries : nullptr, {clock, 6}, within));
      if (HasFailure()) return;
    }
    reported += watched.watch.log().size();
  }
  EXPECT_GT(reported, 300u);
}

INSTANTIATE_TEST_SUITE_P(WithinOneAndBetweenTwo, PairUpdateOfPlans, ::testing::Bool());

/// The next contact lies many legs ahead: it waits, and is reported when the clock comes near.
TEST(PairUpdateOfPlans, AContactManyLegsAheadIsReportedInTime) {
  Watched watched(false, {.tbl = "ships", .horizon = 5, .manual = true}, planned);
  const Offsets at = record_offsets(planned);
  std::vector<double> record(static_cast<std::size_t>(at.size));
  record[static_cast<std::size_t>(at.until)] = no_end;
  record[static_cast<std::size_t>(at.r)] = 0.5;
  Plan patrol{.kind = PlanKind::knots, .axes = 2};
  for (int i = 0; i <= 200; ++i) patrol.knots.push_back({1.0 * i, {i == 150 ? 10.0 : 1.0 * (i % 2), 0}});
  watched.ships->put(1, record, legs_of(patrol));
  Plan buoy{.kind = PlanKind::knots, .axes = 2};
  buoy.knots = {{0, {10, 0}}, {no_end, {10, 0}}};
  watched.ships->put(2, record, legs_of(buoy));
  std::vector<double> reports;
  for (double clock = 0; clock <= 200; clock += 1) {
    watched.state.requested_clock = clock;
    const std::size_t known = watched.watch.log().size();
    watched.update();
    for (std::size_t i = known; i < watched.watch.log().size(); ++i) reports.push_back(clock);
  }
  // Touches from 149 8/9 (or 149.9) to 150.1: known from 145 on, gone at 151.
  EXPECT_EQ(reports, (std::vector<double>{145, 151}));
}

}  // namespace
}  // namespace foresee::testing
