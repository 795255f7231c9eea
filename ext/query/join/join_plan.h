// Cost-based plan of a join: the method that 'auto' selects, and the number of time slabs of the grid.
//
// The cost of each method, in nanoseconds, follows from a few numbers (docs/developers/architecture.md). These are the
// objects, the pairs, and the pairs whose swept boxes intersect, at one instant and during a slab. The last
// two are counted in a sample of some dozen to some hundred objects, so they reflect crowds, giants and fast
// objects. The plan changes no row, only the time to compute the rows.
#pragma once

#include <cstddef>

#include "query/join/time_slabs.h"

namespace foresee {

struct JoinPlan {
  JoinMethod method;  ///< never automatic
  const char* why;    ///< the reason, for predictive_explain
  /// Of equal length if rows need no order; 1 unless the method is grid or objects have plans.
  std::size_t slabs;
  bool with_helpers = false;  ///< a slab is enough work for helper threads
};

/// The requested method, or for 'auto' the one with the lowest estimated cost, and the cheapest number of
/// slabs. A query of one id is always a scan. The same query gets the same plan. Cost: tens of thousands of
/// comparisons of boxes for each number of slabs that is tried, however many objects there are. Throws Error for shapes
/// without a distance.
JoinPlan plan_join(const JoinQuestion& question);

/// The plan's slabs: one without an end unless the plan cuts the horizon. If rows come in the order of t, the first
/// slabs are short, so that they come early.
TimeSlabs slabs_of(const JoinPlan& plan, const JoinQuestion& question);

/// Estimated number of pairs whose swept boxes intersect during `horizon`, from a deterministic sample.
double expected_meetings(const JoinQuestion& question, const Horizon& horizon);

}  // namespace foresee
