#include "storage/nodes/packed_map.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>

namespace foresee::storage {
namespace {

/// Each id in a leaf of its own, placed in any order.
void expect_placed(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  PackedMap map(ids);
  std::map<std::int64_t, std::int64_t> wanted;
  std::shuffle(ids.begin(), ids.end(), std::mt19937{3});
  std::int64_t leaf = 7;
  for (const std::int64_t id : ids) map.place({&id, 1}, wanted[id] = leaf++);
  std::map<std::int64_t, std::int64_t> found;
  map.for_each_part([&](std::span<const IdHashMap::Entry> part) {
    for (const IdHashMap::Entry& entry : part) found[entry.id] = entry.value;
  });
  EXPECT_EQ(found, wanted);
}

TEST(PackedMap, FindsIdsHoweverTheyAreSpread) {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  expect_placed({5});
  expect_placed({-most - 1, most});
  std::vector<std::int64_t> even, squares, clusters, far;
  for (std::int64_t i = 0; i < 3000; ++i) {
    even.push_back(3 * i - 1000), squares.push_back(i * i * i);
    clusters.push_back((i % 3) * (most / 4) + i), far.push_back(i == 0 ? -most : i == 1 ? most : i);
  }
  for (const auto& ids : {even, squares, clusters, far}) expect_placed(ids);
}

}  // namespace
}  // namespace foresee::storage
