// List of placed ids: returns each id once, ascending, whatever the order in which they came.
#include "storage/nodes/placed_ids.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>

namespace foresee {
namespace {

/// Each few ids in a leaf of their own, placed in any order.
void expect_placed(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  IdSum sum;
  for (const std::int64_t id : ids) sum.add(id);
  std::shuffle(ids.begin(), ids.end(), std::mt19937{3});
  std::map<std::int64_t, std::int64_t> wanted;
  PlacedIds placed;
  std::int64_t leaf = PlacedIds::max_leaf - static_cast<std::int64_t>(ids.size());
  for (std::size_t i = 0; i < ids.size(); i += 3) {
    const auto few = std::span(ids).subspan(i, std::min<std::size_t>(3, ids.size() - i));
    for (const std::int64_t id : few) wanted[id] = leaf;
    placed.add(few, leaf++);
  }
  EXPECT_EQ(placed.sum(), sum);
  EXPECT_EQ(placed.sum().count(), ids.size());
  auto next = wanted.begin();
  std::int64_t block = 0;
  placed.for_each_chunk([&](std::span<const IdHashMap::Entry> chunk) {
    ASSERT_FALSE(chunk.empty());
    EXPECT_TRUE(next == wanted.begin() || IdBlock::base_of(chunk.front().id) != block);
    block = IdBlock::base_of(chunk.back().id);
    for (const IdHashMap::Entry& entry : chunk) {
      ASSERT_NE(next, wanted.end());
      EXPECT_EQ(entry.id, next->first);
      EXPECT_EQ(entry.value, next->second);
      ++next;
    }
  });
  EXPECT_EQ(next, wanted.end());
}

TEST(PlacedIds, ReturnsIdsOfAnyDistribution) {
  constexpr std::int64_t max_id = std::numeric_limits<std::int64_t>::max();
  expect_placed({});
  expect_placed({5});
  expect_placed({-max_id - 1, max_id, 0, -1, std::int64_t{1} << 31, std::int64_t{1} << 32});
  std::vector<std::int64_t> even, squares, clusters, far;
  for (std::int64_t i = 0; i < 3000; ++i) {
    even.push_back(3 * i - 1000);
    squares.push_back(i * i * i);
    clusters.push_back((i % 3) * (max_id / 4) + i);
    far.push_back(i == 0 ? -max_id : i == 1 ? max_id : i);
  }
  for (const auto& ids : {even, squares, clusters, far}) expect_placed(ids);
}

TEST(PlacedIds, ReturnsSeveralBlocksAsOne) {
  std::vector<std::int64_t> ids;
  for (std::int64_t i = 0; i < 200'000; ++i) ids.push_back(i * 3 - 100'000);
  expect_placed(ids);
  ids.resize(1 << 17);  // the last block is full
  expect_placed(ids);
}

TEST(IdSum, DiffersIfAnIdDoes) {
  IdSum a, b, c;
  a.add(1);
  a.add(5);
  b.add(5);
  b.add(1);
  EXPECT_EQ(a, b);
  c.add(1);
  c.add(1);
  EXPECT_FALSE(a == c);
  c = {};
  c.add(6);
  EXPECT_FALSE(a == c);
}

}  // namespace
}  // namespace foresee
