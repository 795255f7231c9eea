// Nearest movers with plans: the smallest distance of all their legs, from scenes and from both trees.
#include <gtest/gtest.h>

#include <tuple>

#include "query/nearest/nearest.h"
#include "query/plan_cases.h"

namespace foresee::testing {
namespace {

using RankedRow = std::tuple<double, std::int64_t, double, double>;

std::vector<RankedRow> ranked_rows(const NearestQuestion& question) {
  NeverInterrupt never;
  std::vector<RankedRow> rows;
  for (const NearestRow& row : nearest(question, never))
    rows.emplace_back(row.distance, row.id, row.t, row.dt);
  return rows;
}

/// The plain answer: every leg, each by its own query of a plain table.
std::vector<RankedRow> plain_ranking(const Movers& movers, NearestQuestion question) {
  std::vector<RankedRow> all;
  for (const Mover& mover : movers.all) {
    auto rows = std::make_shared<Scene>(legs_as_rows(movers.layout, mover));
    std::vector<RankedRow> legs;
    for (std::size_t row = 0; row < rows->size(); ++row) {
      auto one = std::make_shared<Scene>();
      const auto size = static_cast<std::size_t>(row_offsets(rows->layout).size);
      const double* from = rows->rows.data() + row * size;
      *one = {"one", rows->layout, {mover.id}, std::vector<double>(from, from + size)};
      question.objects = {"one", one, nullptr};
      for (const RankedRow& leg : ranked_rows(question)) legs.push_back(leg);
    }
    if (!legs.empty()) all.push_back(*std::min_element(legs.begin(), legs.end()));
  }
  std::sort(all.begin(), all.end());
  if (all.size() > static_cast<std::size_t>(question.k)) all.resize(static_cast<std::size_t>(question.k));
  return all;
}

class NearestOfMovers : public ::testing::TestWithParam<Layout> {};

TEST_P(NearestOfMovers, IsTheNearestOfTheLegs) {
  std::size_t found = 0;
  for (const PlanNumbers numbers : all_plan_numbers)
    for (std::uint64_t seed = 1; seed <= (sanitized ? 1 : 4); ++seed) {
      const Movers movers = random_movers(GetParam(), numbers, 60, seed);
      const auto table = table_of(movers);
      PlanMaker maker(GetParam(), numbers, seed + 200);
      for (int i = 0; i < 16; ++i) {
        NearestQuestion question{
            .objects = {}, .now = maker.time(-8, 40), .h = i % 4 == 0 ? 0 : maker.number(0, 24)};
        question.k = i % 5 == 4 ? 1000 : 1 + i % 4;
        const std::array<double, 3> at = maker.place();
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(GetParam().axes); ++axis) {
          question.point[axis] = at[axis];
          if (i % 2) question.velocity[axis] = maker.number(-3, 3);
        }
        if (GetParam().has_category && i % 2) question.mask = static_cast<std::uint32_t>(1 + i % 5);
        const auto wanted = plain_ranking(movers, question);
        for (const SearchTarget& target : targets_of(*table, {question.now, question.h})) {
          question.objects = target;
          ASSERT_EQ(ranked_rows(question), wanted)
              << seed << ' ' << i << (target.scene ? " scene" : " trees");
        }
        found += wanted.size();
      }
    }
  EXPECT_GT(found, sanitized ? 100u : 500u);
}

INSTANTIATE_TEST_SUITE_P(Layouts, NearestOfMovers, ::testing::ValuesIn(layouts_with_plans()));

}  // namespace
}  // namespace foresee::testing
