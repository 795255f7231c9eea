#include "database/id_filter.h"

#include <gtest/gtest.h>

#include <limits>

namespace foresee {
namespace {

TEST(IdFilter, HasAllThatWereAddedAndFewOthers) {
  for (const std::int64_t step : {1, 2, 1024, 1'000'003, 1 << 30}) {
    constexpr std::int64_t many = 20'000;
    IdFilter filter(many);
    for (std::int64_t i = 0; i < many; ++i) filter.add(i * step - 5'000);
    int others = 0;
    for (std::int64_t i = 0; i < many; ++i) {
      ASSERT_TRUE(filter.may_have(i * step - 5'000));
      others += filter.may_have((many + i) * step - 5'000);
    }
    EXPECT_LT(others, many / 200) << step;
    EXPECT_LT(filter.memory(), 3 * many);
  }
}

TEST(IdFilter, AcceptsAnyIdAndMoreThanAnnounced) {
  IdFilter filter(0);
  EXPECT_FALSE(filter.may_have(0));
  for (const std::int64_t id : {std::numeric_limits<std::int64_t>::min(), std::int64_t{-1}, std::int64_t{0},
                                std::numeric_limits<std::int64_t>::max()}) {
    filter.add(id);
    EXPECT_TRUE(filter.may_have(id));
  }
  for (std::int64_t id = 0; id < 1000; ++id) filter.add(id);
  EXPECT_TRUE(filter.may_have(999));
}

TEST(IdFilter, GrowsWithItsIdsAndNotWithRepeatedOnes) {
  IdFilter filter;
  constexpr std::int64_t many = 300'000;
  for (std::int64_t i = 0; i < many; ++i) filter.add(i * 7919);
  const std::size_t memory = filter.memory();
  EXPECT_LT(memory, 5 * many);
  for (std::int64_t i = 0; i < many; ++i) filter.add(i * 7919);
  EXPECT_EQ(filter.memory(), memory);
  std::int64_t others = 0;
  for (std::int64_t i = 0; i < many; ++i) {
    ASSERT_TRUE(filter.may_have(i * 7919));
    others += filter.may_have(i * 7919 + 1);
  }
  EXPECT_LT(others, many / 50);
}

}  // namespace
}  // namespace foresee
