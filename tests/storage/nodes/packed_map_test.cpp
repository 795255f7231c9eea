// Packed id map: finds each object for any distribution of ids, and reports ids that were not announced.
#include "storage/nodes/packed_map.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>

namespace foresee {
namespace {

/// Each id in a leaf of its own, placed in any order.
void expect_placed(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  PackedMap map(ids);
  std::map<std::int64_t, std::int64_t> wanted;
  std::shuffle(ids.begin(), ids.end(), std::mt19937{3});
  std::int64_t leaf = 7;
  for (const std::int64_t id : ids) {
    EXPECT_FALSE(map.is_complete());
    EXPECT_TRUE(map.place({&id, 1}, wanted[id] = leaf++));
  }
  EXPECT_TRUE(map.is_complete());
  std::map<std::int64_t, std::int64_t> found;
  map.for_each_chunk([&](std::span<const IdHashMap::Entry> chunk) {
    for (const IdHashMap::Entry& entry : chunk) found[entry.id] = entry.value;
  });
  EXPECT_EQ(found, wanted);
}

TEST(PackedMap, FindsIdsOfAnyDistribution) {
  constexpr std::int64_t max_id = std::numeric_limits<std::int64_t>::max();
  expect_placed({5});
  expect_placed({-max_id - 1, max_id});
  std::vector<std::int64_t> even, squares, clusters, far;
  for (std::int64_t i = 0; i < 3000; ++i) {
    even.push_back(3 * i - 1000), squares.push_back(i * i * i);
    clusters.push_back((i % 3) * (max_id / 4) + i), far.push_back(i == 0 ? -max_id : i == 1 ? max_id : i);
  }
  for (const auto& ids : {even, squares, clusters, far}) expect_placed(ids);
}

TEST(PackedMap, AnObjectThatWasNotAnnouncedIsRefused) {
  using Ids = std::vector<std::int64_t>;
  PackedMap map({1, 5});
  for (const std::int64_t other : {9, 3, -7}) EXPECT_FALSE(map.place(Ids{other}, 7)) << other;
  EXPECT_TRUE(map.place(Ids{1, 1}, 7));
  EXPECT_FALSE(map.is_complete());
  EXPECT_FALSE(PackedMap({}).place(Ids{0}, 7));
}

}  // namespace
}  // namespace foresee
