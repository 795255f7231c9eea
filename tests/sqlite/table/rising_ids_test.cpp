// Prefetch of rising ids: each batch of ids is announced once, before its ids are requested. For other orders
// nothing is announced.
#include "sqlite/table/rising_ids.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <vector>

namespace foresee {
namespace {

/// The ids that are announced while the ids `queried` are requested; none is announced twice.
std::set<std::int64_t> announced(const std::vector<std::int64_t>& queried) {
  RisingIds rising;
  std::set<std::int64_t> all;
  for (const std::int64_t id : queried)
    if (const auto first = rising.next(id)) {
      EXPECT_GT(*first, id);
      for (std::int64_t i = 0; i < RisingIds::batch; ++i) EXPECT_TRUE(all.insert(*first + i).second);
    }
  return all;
}

TEST(RisingIds, EveryIdAfterTheSecondIsAnnouncedBeforeItIsRequested) {
  for (const std::int64_t gap : {1, 2, 3, 4})
    for (const std::int64_t start : {std::int64_t{-500}, std::int64_t{0}, std::int64_t{1} << 40}) {
      RisingIds rising;
      std::set<std::int64_t> known;
      for (std::int64_t n = 0; n < 1000; ++n) {
        const std::int64_t id = start + n * gap;
        EXPECT_TRUE(n < 2 || known.contains(id)) << id;
        if (const auto first = rising.next(id))
          for (std::int64_t i = 0; i < RisingIds::batch; ++i) known.insert(*first + i);
      }
    }
}

TEST(RisingIds, OtherOrdersAnnounceNothing) {
  EXPECT_TRUE(announced({5, 5, 5, 5}).empty());
  EXPECT_TRUE(announced({9, 8, 7, 6}).empty());
  EXPECT_TRUE(announced({1, 10, 100, 1000}).empty());
  EXPECT_TRUE(announced({7}).empty());
}

TEST(RisingIds, ASecondRiseIsDetected) {
  const auto all = announced({1, 2, 3, 1000, 1001, 1002});
  EXPECT_TRUE(all.contains(4));
  EXPECT_TRUE(all.contains(1003));
  EXPECT_FALSE(all.contains(500));
}

TEST(RisingIds, TheEndsOfAllIdsAreNoRise) {
  constexpr auto lowest = std::numeric_limits<std::int64_t>::min(),
                 highest = std::numeric_limits<std::int64_t>::max();
  EXPECT_TRUE(announced({highest - 2, highest - 1, highest, lowest, highest, lowest}).empty());
  EXPECT_TRUE(announced({lowest, lowest + 1}).contains(lowest + 2));
}

}  // namespace
}  // namespace foresee
