// IntervalTree: what it finds is what a scan finds.
#include "base/interval_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace foresee {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(IntervalTree, FindsWhatAScanFinds) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 2000; ++round) {
    std::vector<IntervalTree::Interval> intervals(random() % 40);
    const auto number = [&] {
      const auto drawn = static_cast<int>(random() % 24);
      return drawn == 0 ? -infinity : drawn == 1 ? infinity : drawn / 2;
    };
    for (IntervalTree::Interval& one : intervals) {  // some of them empty
      one.begin = number();
      one.end = number();
    }
    const IntervalTree tree(intervals);
    const double begin = number(), end = number();
    std::vector<std::size_t> expected, found;
    for (std::size_t i = 0; i < intervals.size(); ++i)
      if (intervals[i].begin <= intervals[i].end && intervals[i].begin <= end && begin <= intervals[i].end)
        expected.push_back(i);
    tree.find(begin, end, [&](std::size_t i) {
      found.push_back(i);
      return true;
    });
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected) << "round " << round;
  }
}

TEST(IntervalTree, StopsAtFalse) {
  const IntervalTree tree({{0, 1}, {0, 1}, {2, 3}});
  int calls = 0;
  EXPECT_FALSE(tree.find(0, 9, [&](std::size_t) { return ++calls < 2; }));
  EXPECT_EQ(calls, 2);
  EXPECT_TRUE(IntervalTree({}).find(0, 9, [](std::size_t) { return false; }));
}

}  // namespace
}  // namespace foresee
