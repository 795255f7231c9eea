// How is a join best answered? The method that 'auto' takes, and the slabs that the grid cuts its horizon
// into.
//
// Each way has a cost in nanoseconds, from few numbers that docs/architecture.md explains: how many objects,
// how many pairs, and how many pairs of swept boxes meet, at one instant and during a slab. The last two are
// counted in a sample of some dozen to some hundred objects, so they follow crowds, giants and fast objects.
// The plan changes no row, only the time that rows take.
#pragma once

#include <cstddef>

#include "query/join/time_slabs.h"

namespace foresee {

struct JoinPlan {
  JoinMethod method;  ///< never automatic
  const char* why;    ///< for people
  std::size_t slabs;  ///< of equal length, where the order of rows does not matter; 1 but for the grid
  bool with_helpers = false;  ///< a slab is enough work to be shared with threads
};

/// The method asked for, or else the one that is expected to cost least; likewise the slabs. About one id
/// always a scan. The same question gets the same plan. Cost: tens of thousands of comparisons of boxes for
/// each number of slabs that is tried, however many objects there are.
JoinPlan plan_join(const JoinQuestion& question, const Contact::Reach& reach);

/// The plan's slabs for a question; in the order of t they begin short, so that the first rows come early.
TimeSlabs slabs_of(const JoinPlan& plan, const JoinQuestion& question);

/// About how many pairs have swept boxes that meet during `horizon`: from a sample, the same every time.
double expected_meetings(const JoinQuestion& question, const Contact::Reach& reach, const Horizon& horizon);

}  // namespace foresee
