// Stage one of a join: which pairs are worth a look, and by which method they are found.
#pragma once

#include "query/join.h"

namespace foresee {

/// Every pair of `question` that can touch, and others. `reach` says how far swept boxes must grow together.
std::unique_ptr<Candidates> join_candidates(const JoinQuestion& question, const Contact::Reach& reach,
                                            Interrupt& interrupt);

}  // namespace foresee
