// Pairs of legs without an index: each pair that shares a time, once, in batches of a bounded size.
#include "query/legs/leg_candidates.h"

#include <gtest/gtest.h>

#include <set>

#include "never_interrupt.h"

namespace foresee::testing {
namespace {

constexpr Layout with_legs{
    .axes = 1, .law = Law::uniform, .has_t = true, .has_until = true, .has_plan = true};

/// Legs [t, until] of one mover after another.
std::shared_ptr<const Scene> scene_with(const std::vector<std::vector<std::array<double, 2>>>& movers) {
  auto scene = std::make_shared<Scene>();
  scene->name = "robots", scene->layout = with_legs;
  const Offsets at = row_offsets(with_legs);
  for (std::size_t mover = 0; mover < movers.size(); ++mover)
    for (const auto& [t, until] : movers[mover]) {
      scene->ids.push_back(static_cast<std::int64_t>(mover));
      scene->rows.resize(scene->rows.size() + static_cast<std::size_t>(at.size));
      double* const row = scene->rows.data() + scene->rows.size() - at.size;
      row[at.t] = t, row[at.until] = until;
    }
  scene->find_movers();
  return scene;
}

/// Every pair of legs of two movers that share a time of the horizon.
std::set<std::pair<std::uint32_t, std::uint32_t>> expected_pairs(const Movers& movers,
                                                                 const Horizon& horizon) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  const auto rows = static_cast<std::uint32_t>(movers.scene()->size());
  for (std::uint32_t a = 0; a < rows; ++a)
    for (std::uint32_t b = a + 1; b < rows; ++b) {
      const double from = std::max({movers.t(a), movers.t(b), horizon.now});
      const double until = std::min({movers.until(a), movers.until(b), horizon.now + horizon.h});
      if (movers.mover_of(a) != movers.mover_of(b) && from <= until) pairs.insert({a, b});
    }
  return pairs;
}

void expect_each_once(const std::shared_ptr<const Scene>& scene, const Horizon& horizon) {
  const Movers movers(scene);
  const auto candidates = make_leg_candidates({.a = movers, .b = movers, .each_once = true}, horizon, never);
  std::set<std::pair<std::uint32_t, std::uint32_t>> found;
  std::vector<Pair> batch;
  for (bool more = true; more; batch.clear()) {
    more = candidates->next(batch);
    EXPECT_LE(batch.size(), 4096u);
    for (const Pair& pair : batch)
      EXPECT_TRUE(found.insert(std::minmax(pair.a, pair.b)).second) << pair.a << ", " << pair.b;
  }
  EXPECT_EQ(found, expected_pairs(movers, horizon));
}

TEST(LegCandidates, AreEachPairThatSharesATime) {
  expect_each_once(scene_with({{{0, 1}, {1, 3}, {5, 5}, {5, 9}}, {{1, 1}, {2, 5}}, {{4, 4}, {9, 20}}}),
                   {1, 7});
}

TEST(LegCandidates, ComeInBatchesAlsoOfTwoMovers) {
  // A hundred legs without duration at one time are each beside all others.
  const std::vector<std::array<double, 2>> at_once(100, {5, 5});
  expect_each_once(scene_with({at_once, {{0, 4}}, at_once, at_once}), {0, 10});
}

}  // namespace
}  // namespace foresee::testing
