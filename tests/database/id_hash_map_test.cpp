// Hash map of ids: what was set is found, and what was cleared is gone.
#include "database/id_hash_map.h"

#include <gtest/gtest.h>

namespace foresee {
namespace {

TEST(IdHashMap, FindsWhatWasSetUntilItIsCleared) {
  IdHashMap map;
  EXPECT_EQ(map.find(7), IdHashMap::unknown);
  for (std::int64_t id = -500; id < 500; ++id) {
    map.prepare(id);
    EXPECT_EQ(map.find(id), IdHashMap::unknown);
    map.set(id, 1000 + id);
  }
  for (std::int64_t id = -500; id < 500; ++id) EXPECT_EQ(map.find(id), 1000 + id);
  EXPECT_EQ(map.known().size(), 1000u);
  map.reset();
  EXPECT_EQ(map.find(7), IdHashMap::unknown);
  EXPECT_EQ(map.size(), 1000u);
}

TEST(IdHashMap, ReturnsTheValueBeforeAnExchange) {
  IdHashMap map;
  for (std::int64_t id = 0; id < 100; ++id) EXPECT_EQ(map.exchange(id, id + 1), IdHashMap::unknown);
  for (std::int64_t id = 0; id < 100; ++id) EXPECT_EQ(map.exchange(id, IdHashMap::unknown), id + 1);
  EXPECT_TRUE(map.none_known());
  EXPECT_EQ(map.exchange(7, 8), IdHashMap::unknown);
  EXPECT_EQ(map.known().size(), 1u);
}

// Otherwise the memory of a large load would be released much later, in a commit of one row.
TEST(IdHashMap, HoldsNoMemoryOnceItIsCleared) {
  IdHashMap map;
  for (std::int64_t id = 0; id < 1000; ++id) map.prepare(id);
  EXPECT_GT(map.memory(), 1000 * sizeof(IdHashMap::Entry));
  map.clear();
  EXPECT_EQ(map.memory(), 0u);
}

}  // namespace
}  // namespace foresee
