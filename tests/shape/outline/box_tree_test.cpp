#include "shape/outline/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <random>

namespace foresee {
namespace {

std::vector<Box<2>> random_boxes(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<double> place(0, 100), size(0, 3);
  std::vector<Box<2>> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec<2> lower{place(random), place(random)};
    boxes.push_back({lower, lower + Vec<2>{size(random), size(random)}});
  }
  return boxes;
}

std::vector<Box<2>> in_order(const std::vector<Box<2>>& boxes, const std::vector<std::uint32_t>& order) {
  std::vector<Box<2>> ordered;
  for (const std::uint32_t box : order) ordered.push_back(boxes[box]);
  return ordered;
}

/// The items whose boxes meet `box`, and how many nodes were looked at.
std::vector<std::size_t> items_near(const BoxTree<2>& tree, const Box<2>& box, std::size_t& visits) {
  std::vector<std::size_t> found;
  std::vector<BoxTree<2>::Node> stack{tree.root};
  while (!stack.empty()) {
    EXPECT_LE(stack.size(), std::bit_width(tree.items()) + 1u);
    const auto node = stack.back();
    stack.pop_back();
    ++visits;
    if (!tree.box(node).meets(box)) continue;
    if (tree.is_leaf(node))
      found.push_back(tree.item(node));
    else
      stack.push_back(tree.left(node)), stack.push_back(tree.right(node));
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(BoxTree, AnOrderHasEveryBoxOnce) {
  std::mt19937_64 random(41);
  for (const std::size_t count : {1, 2, 3, 5, 8, 13, 1000}) {
    std::vector<std::uint32_t> order = tree_order<2>(random_boxes(random, count));
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
  }
}

TEST(BoxTree, FindsWhatMeetsABox) {
  std::mt19937_64 random(42);
  for (const std::size_t count : {1, 2, 3, 7, 100, 1000}) {
    std::vector<Box<2>> boxes = random_boxes(random, count);
    boxes = in_order(boxes, tree_order<2>(boxes));
    const BoxTree<2> tree(boxes);
    EXPECT_EQ(tree.items(), count);
    std::size_t visits = 0;
    for (const Box<2>& box : random_boxes(random, 100)) {
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < count; ++i)
        if (boxes[i].meets(box)) expected.push_back(i);
      EXPECT_EQ(items_near(tree, box, visits), expected);
    }
    if (count == 1000) {
      EXPECT_LT(visits, 100u * 60);
    }
  }
}

TEST(BoxTree, ALeafKnowsItsItem) {
  std::mt19937_64 random(43);
  const std::vector<Box<2>> boxes = random_boxes(random, 37);
  const BoxTree<2> tree(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_TRUE(tree.is_leaf(tree.leaf(i)));
    EXPECT_EQ(tree.item(tree.leaf(i)), i);
    EXPECT_TRUE((tree.box(tree.leaf(i)).lower == boxes[i].lower).all());
  }
}

TEST(BoxTree, BoxesInOnePlaceAreNoDeeperThanOthers) {
  const std::vector<Box<2>> boxes(100'000, Box<2>{{0, 0}, {1, 1}});
  const BoxTree<2> tree(in_order(boxes, tree_order<2>(boxes)));
  std::size_t visits = 0;
  EXPECT_EQ(items_near(tree, {{0, 0}, {0, 0}}, visits).size(), boxes.size());
}

}  // namespace
}  // namespace foresee
