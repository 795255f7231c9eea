// Stage one of a join: which pairs are worth a look?
#pragma once

#include "query/join/join.h"

namespace foresee::query {

/// Every pair of `question` that can touch during `horizon`, and others, by `method` (not automatic). `reach`
/// says how far swept boxes must grow together. `question` must outlive what is answered.
std::unique_ptr<Candidates> join_candidates(const JoinQuestion& question, JoinMethod method,
                                            const Horizon& horizon, const Contact::Reach& reach,
                                            Interrupt& interrupt);

/// The same by the grid, in parts for question.helpers threads.
std::unique_ptr<DividedCandidates> divided_candidates(const JoinQuestion& question, const Horizon& horizon,
                                                      const Contact::Reach& reach, Interrupt& interrupt);

}  // namespace foresee::query
