// Leaf hints: what was learned is found, and a wrong hint is detected in the leaf.
#include "storage/nodes/leaf_hints.h"

#include <gtest/gtest.h>

#include <numeric>

namespace foresee {
namespace {

std::vector<std::int64_t> count_from(std::int64_t first, std::size_t many) {
  std::vector<std::int64_t> ids(many);
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

TEST(LeafHints, GiveLeafAndSlotOfConsecutiveIds) {
  LeafHints hints;
  EXPECT_TRUE(hints.empty());
  EXPECT_EQ(hints.find(7).leaf, 0);
  for (std::int64_t leaf = 1; leaf <= 100; ++leaf) {
    hints.reserve(static_cast<std::size_t>(leaf) * 2 * 50);
    hints.learn(count_from(leaf * 50, 50), leaf);
  }
  for (std::int64_t leaf = 1; leaf <= 100; ++leaf)
    for (std::size_t slot = 0; slot < 50; ++slot) {
      const LeafHints::Hint hint = hints.find(leaf * 50 + static_cast<std::int64_t>(slot));
      EXPECT_EQ(hint.leaf, leaf);
      EXPECT_EQ(hint.slot, slot);
    }
}

TEST(LeafHints, AnObjectIsFoundWhereverItIsInItsLeaf) {
  const std::vector<std::int64_t> ids = count_from(1000, 600);  // more than a hint can count
  LeafHints hints;
  hints.reserve(2 * ids.size());
  hints.learn(ids, 3);
  for (std::size_t slot = 0; slot < ids.size(); ++slot)
    EXPECT_EQ(hints.find(ids[slot]).slot_in(ids, ids[slot]), slot);
  const LeafHints::Hint elsewhere{.leaf = 3, .slot = 200};
  EXPECT_EQ(elsewhere.slot_in(ids, 1007), 7u);
  EXPECT_EQ(elsewhere.slot_in(ids, 999), ids.size());
  EXPECT_EQ(elsewhere.slot_in({}, 999), 0u);
}

TEST(LeafHints, ALargeTableGrowsInSmallSteps) {
  constexpr std::size_t wanted = 1 << 22;
  LeafHints hints;
  hints.reserve(1);
  std::size_t max_added = 0;
  for (std::int64_t leaf = 1; leaf <= 10000; ++leaf) {
    const std::size_t before = hints.places();
    hints.reserve(wanted);
    max_added = std::max(max_added, hints.places() - before);
    hints.learn(count_from(leaf * 64, 64), leaf);
  }
  EXPECT_EQ(hints.places(), wanted);
  EXPECT_LE(max_added, wanted / 128);
  for (std::int64_t id = 64; id < 64 * 10001; ++id) ASSERT_EQ(hints.find(id).leaf, id / 64);
}

TEST(LeafHints, LeavesWithLargeNumbersHaveNone) {
  constexpr std::int64_t last = (std::int64_t{1} << 24) - 1;
  LeafHints hints;
  hints.reserve(1);
  hints.learn(1, last, 255);
  hints.learn(2, last + 1, 0);
  EXPECT_EQ(hints.find(1).leaf, last);
  EXPECT_EQ(hints.find(1).slot, 255u);
  EXPECT_EQ(hints.find(2).leaf, 0);
}

}  // namespace
}  // namespace foresee
