// Contact times of given pairs: the exact stage of a join without a search for candidates.
//
//   question.wants = {.contact = true, .ends = true, .approach = false};
//   for (const JoinRow& row : pair_contacts(question, pairs, interrupt)) use(row.a, row.b, row.contact.t);
//
// Guarantee: a row for each pair that may meet and touches during [now, now + h], with the same numbers as
// the join gives; the others are left out. Rows come in the order of the pairs, within one scene the smaller id first.
// Cost: some hundred nanoseconds per pair.
#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "query/join/question.h"

namespace foresee {

/// `pairs`: row numbers in the scenes of `queried`. Throws Error as Join does.
std::vector<JoinRow> pair_contacts(const JoinQuestion& queried, std::span<const Pair> pairs,
                                   Interrupt& interrupt);

}  // namespace foresee
