// Helpers of index tests: the candidates of an index as a sorted list, and all pairs that meet.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

#include "index/candidates.h"
#include "never_interrupt.h"
#include "scenes.h"

namespace foresee::testing {

/// All pairs of `candidates`, in any order.
inline std::vector<Pair> drain(Candidates& candidates) {
  std::vector<Pair> pairs;
  while (candidates.next(pairs)) {
  }
  return pairs;
}

/// Each pair as {smaller, larger}, for the comparison of pairs within one side.
inline std::vector<Pair> within_order(std::vector<Pair> pairs) {
  for (Pair& pair : pairs)
    if (pair.a > pair.b) std::swap(pair.a, pair.b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

inline std::vector<Pair> in_order(std::vector<Pair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// An empty box meets no box, not even one that is infinite on every side.
template <int D>
bool meet(const Box<D>& a, const Box<D>& b) {
  return !a.is_empty() && !b.is_empty() && a.meets(b);
}

template <int D>
std::vector<Pair> pairs_that_meet(std::span<const Box<D>> boxes) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
      if (meet(boxes[i], boxes[j])) pairs.push_back({i, j});
  return pairs;
}

template <int D>
std::vector<Pair> pairs_that_meet(std::span<const Box<D>> a, std::span<const Box<D>> b) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = 0; j < b.size(); ++j)
      if (meet(a[i], b[j])) pairs.push_back({i, j});
  return pairs;
}

/// Expects that sorted `found` has every pair of `wanted` once, none twice, and at most `extra` others.
inline void expect_all_once(const std::vector<Pair>& found, const std::vector<Pair>& wanted,
                            std::size_t extra) {
  EXPECT_TRUE(std::adjacent_find(found.begin(), found.end()) == found.end()) << "a pair comes twice";
  EXPECT_TRUE(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end())) << "a pair is lost";
  EXPECT_LE(found.size(), wanted.size() + extra);
}

}  // namespace foresee::testing
