// Candidates of one row: its pairs with every row of the other side, each once.
#include <gtest/gtest.h>

#include "index/all_pairs.h"

namespace foresee {
namespace {

std::vector<Pair> all_of(const OneWithAll& rows) {
  NeverInterrupt never;
  std::vector<Pair> pairs;
  const auto candidates = make_one_with_all(rows, never);
  while (candidates->next(pairs)) {
  }
  EXPECT_FALSE(candidates->next(pairs));
  return pairs;
}

TEST(OneWithAll, PairsTheRowWithEveryRowOnceOnItsSide) {
  EXPECT_EQ(all_of({.one = 7, .side = Side::a, .count = 3}), (std::vector<Pair>{{7, 0}, {7, 1}, {7, 2}}));
  EXPECT_EQ(all_of({.one = 7, .side = Side::b, .count = 2}), (std::vector<Pair>{{0, 7}, {1, 7}}));
  EXPECT_EQ(all_of({.one = 7, .side = Side::b, .count = 0}), std::vector<Pair>{});
}

TEST(OneWithAll, GoesOnAcrossBatches) {
  const auto pairs = all_of({.one = 0, .side = Side::a, .count = 10000});
  ASSERT_EQ(pairs.size(), 10000u);
  for (std::uint32_t i = 0; i < 10000; ++i) ASSERT_EQ(pairs[i], (Pair{0, i}));
}

}  // namespace
}  // namespace foresee
