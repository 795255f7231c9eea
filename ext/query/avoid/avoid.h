// Which changes keep one object clear of everybody? predictive_avoid as a library call: intruders, ranges
// proven clear, the exact word where one change is asked about, rows.
//
//   for (const AvoidRow& row : avoid({.own = ship, .record = numbers, .others = ships, .now = 600, .h = 600,
//                                     .within = 200}, interrupt))
//     if (row.clear) use(row.manoeuvre, row.k_from, row.k_to, row.record);
//
// Guarantee: the rows of a manoeuvre tile [lo, hi], clear and blocked by turns; a shared end is the clear
// row's.
//   - No change of a clear row touches anybody during the horizon: proven for every double of it, for the
//     numbers as they are stored, and for velocities within 4 units in the last place of those.
//   - k = 0, and a question with lo = hi, is decided both ways by exact contact of the stored row.
//   - A clear range wider than 10^-6 of [lo, hi] is found if it stays clear for velocities within 64 units in
//     the last place, and ends no farther than that from a change that touches; usually 10^-12. What is
//     blocked is not proven clear, no more (docs/avoidance.md: limits).
// No rows: nobody has this id, does not exist during the horizon, has no course, or has started (delay).
// Answers do not depend on index, order, threads, CPU or objects out of reach.
//
// Cost: a look into the tree, then some 50 ns for each object that any change could meet, and some
// microseconds for each end of a row. Memory: a row of numbers for each of those objects.
#pragma once

#include <vector>

#include "base/error.h"
#include "query/avoid/question.h"

namespace foresee {

/// Throws Error for what require_valid() and queried_changes() refuse.
std::vector<AvoidRow> avoid(const AvoidQuestion& question, Interrupt& interrupt);

}  // namespace foresee
