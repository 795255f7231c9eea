// Joins that exist without foresee, each emitting (a, b, t) with a textbook's contact in plain double
// (plain_contact.h), over objects in native memory, on one thread.
//
//   Answer answer = by_boost(make_workload("S-100000"));      // answer.pairs, answer.sum
//
// Workloads of two or three axes with now = 0, and shapes that plain_contact.h supports. Every method but
// stepping gives the same pairs.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/pair.h"
#include "workloads.h"

namespace foresee::bench {

/// The result of a join: the number of pairs, and a sum over them that does not depend on their order.
struct Answer {
  std::size_t candidates = 0, pairs = 0;
  std::uint64_t sum = 0;
  double t_sum = 0;  ///< so that no compiler leaves the times out

  /// The order of the two objects does not matter.
  void add(const Pair& pair, double t) {
    const std::uint64_t low = std::min(pair.a, pair.b), high = std::max(pair.a, pair.b);
    std::uint64_t mixed = (low << 32 | high) * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 29;
    sum += mixed * 0xbf58476d1ce4e5b9u;
    t_sum += t;
    ++pairs;
  }
  bool same_as(const Answer& other) const { return pairs == other.pairs && sum == other.sum; }
};

/// Every pair.
Answer by_brute_force(const Workload& w);

/// Boost.Geometry: a packed R-tree of the swept boxes, queried with every box (of the other side).
Answer by_boost(const Workload& w);

/// Advances all objects by dt and finds overlaps with a tuned static join; a pair counts at the first step at
/// which it overlaps. A pair that touches only between two steps is missed. Self-joins of boxes only.
Answer by_stepping(const Workload& w, double dt);

#ifdef FORESEE_CGAL
/// CGAL's box_self_intersection_d over the swept boxes, box_intersection_d over those of two sides.
Answer by_cgal(const Workload& w);
#endif

}  // namespace foresee::bench
