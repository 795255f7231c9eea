// The changes that keep one object clear of all others: predictive_avoid as a library call.
//
//   for (const AvoidRow& row : avoid({.own_scene = ship, .record = numbers, .others = ships, .now = 600, .h = 600,
//                                     .within = 200}, interrupt))
//     if (row.clear) use(row.manoeuvre, row.k_from, row.k_to, row.record);
//
// Guarantee: the rows of a manoeuvre tile [lo, hi]; clear and blocked rows alternate, and a shared end
// belongs to the clear row.
//   - No change of a clear row touches any object during the horizon. This is proven for every double of the row,
//     for the numbers as they are stored, and for velocities within 4 units in the last place of those.
//   - Exact contact of the stored row decides k = 0 and a query with lo = hi, both ways.
//   - A clear range wider than 10^-6 of [lo, hi] is found if it stays clear for velocities within 64 units in
//     the last place. On accelerated paths, beside objects that start later and for delays, also for sizes within
//     10^-13 of the lengths at hand. It ends within 10^-6 of [lo, hi] of a change that touches; usually 10^-12. A
//     blocked range is only not proven clear (docs/explanation/avoidance.md: limits).
// No rows: no object has this id, or it does not exist during the horizon, has no course, or has started
// (delay). Answers do not depend on index, order, threads, CPU or objects out of reach.
//
// Cost: one query of the tree, then some 50 ns per object that any change could touch, and some microseconds
// per end of a row. For accelerated paths some twenty times as much. Memory: one row of numbers per such object.
#pragma once

#include <vector>

#include "base/error.h"
#include "query/avoid/question.h"

namespace foresee {

/// Throws Error for what require_valid() and queried_changes() refuse, as a record of another size than its layout has.
std::vector<AvoidRow> avoid(const AvoidQuestion& question, Interrupt& interrupt);

}  // namespace foresee
