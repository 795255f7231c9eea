// All pairs as candidates: each pair once, in batches, and interruptible.
#include "index/all_pairs.h"

#include "candidate_pairs.h"
#include "stopping_interrupt.h"

namespace foresee::testing {
namespace {

TEST(AllPairs, HasEachPairWithinOnce) {
  for (std::size_t count : {0, 1, 2, 3, 150}) {
    const std::vector<Pair> pairs = drain(*make_all_pairs(count, never));
    EXPECT_EQ(pairs.size(), count < 2 ? 0 : count * (count - 1) / 2);
    const std::vector<Pair> sorted = within_order(pairs);
    EXPECT_TRUE(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
    for (const Pair& pair : sorted) EXPECT_TRUE(pair.a < pair.b && pair.b < count);
  }
}

TEST(AllPairs, HasEachPairBetweenOnce) {
  for (std::size_t count_a : {0, 1, 7, 90})
    for (std::size_t count_b : {0, 1, 5, 100}) {
      const std::vector<Pair> sorted = in_order(drain(*make_all_pairs(count_a, count_b, never)));
      EXPECT_EQ(sorted.size(), count_a * count_b);
      EXPECT_TRUE(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
    }
}

TEST(AllPairs, ComesInBatchesOfAFewThousand) {
  auto candidates = make_all_pairs(10000, never);
  std::vector<Pair> batch;
  ASSERT_TRUE(candidates->next(batch));
  EXPECT_GT(batch.size(), 1000u);
  EXPECT_LE(batch.size(), 10000u);
}

TEST(AllPairs, StopsWhenInterrupted) {
  StopAt stop(2);
  auto candidates = make_all_pairs(10000, stop);
  std::vector<Pair> batch;
  EXPECT_TRUE(candidates->next(batch));
  EXPECT_TRUE(candidates->next(batch));
  EXPECT_THROW(candidates->next(batch), Interrupted);
}

}  // namespace
}  // namespace foresee::testing
