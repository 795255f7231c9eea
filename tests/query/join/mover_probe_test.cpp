// The search for partners of one mover in both trees: all its contacts are among the legs found.
#include <gtest/gtest.h>

#include <map>

#include "base/float_environment.h"
#include "never_interrupt.h"
#include "query/join/join_scenes.h"
#include "query/plan_cases.h"

namespace foresee::testing {
namespace {

bool are_same(const std::vector<ContactTimes>& a, const std::vector<ContactTimes>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ContactTimes& x, const ContactTimes& y) {
    return x.t == y.t && x.t_end == y.t_end && x.dt == y.dt && x.dt_end == y.dt_end;
  });
}

class ProbeOfMovers : public ::testing::TestWithParam<Layout> {};

TEST_P(ProbeOfMovers, FindsEveryContact) {
  const FloatEnvironment environment;
  NeverInterrupt never;
  std::size_t met = 0, found = 0;
  for (const PlanNumbers numbers : all_plan_numbers) {
    const Movers movers = random_movers(GetParam(), numbers, 50, 21);
    const auto table = table_of(movers);
    PlanMaker maker(GetParam(), numbers, 22);
    const bool kinds = GetParam().has_category;
    for (const Mover& one : movers.all) {
      const Horizon horizon{maker.time(-4, 24), maker.number(0, 40)};
      const auto object = table->objects(std::span(&one.id, 1), {});
      const auto near = objects_near(*object, trees_of(*table), horizon, {0.5, 0.5}, never,
                                     [&](std::int64_t id) { return id != one.id; });
      std::map<std::int64_t, foresee::RowRange> rows;
      for (std::size_t i = 0; i < near->object_count(); ++i)
        ASSERT_TRUE(rows.emplace(near->ids[near->rows_of(i).first], near->rows_of(i)).second);
      EXPECT_FALSE(rows.contains(one.id));
      found += rows.size();
      const Scene legs = legs_as_rows(GetParam(), one);
      for (const Mover& other : movers.all) {
        const Scene other_legs = legs_as_rows(GetParam(), other);
        const Bodies all = other_legs.bodies(), own = legs.bodies();
        if (other.id == one.id ||
            (kinds && !may_meet(kinds_of(own.row(0), own.at), kinds_of(all.row(0), all.at))))
          continue;
        const auto wanted = plain_contacts(own, all, horizon, 0.5);
        met += wanted.size();
        std::vector<ContactTimes> among_found;
        if (const auto range = rows.find(other.id); range != rows.end()) {
          const Bodies bodies(all.layout, near->bodies().row(range->second.first), range->second.size());
          among_found = plain_contacts(own, bodies, horizon, 0.5);
        }
        ASSERT_TRUE(are_same(among_found, wanted)) << one.id << ' ' << other.id;
      }
    }
  }
  EXPECT_GT(met, 50u);
  EXPECT_LT(found, 3 * 50 * 49u / 2);  // a search, not all
}

INSTANTIATE_TEST_SUITE_P(Layouts, ProbeOfMovers, ::testing::ValuesIn(layouts_with_plans()));

}  // namespace
}  // namespace foresee::testing
