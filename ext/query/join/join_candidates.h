// Stage one of a join: which pairs are worth a look?
#pragma once

#include "index/candidates.h"
#include "query/join/question.h"

namespace foresee {

/// Every pair of `question` that can touch during `horizon`, once, and others (candidates.h), by `method`
/// (not automatic): which others and in what order is all that depends on it. Only such as `own` owns.
/// `reach` says how far swept boxes must grow together. `question` must outlive what is answered. Cost: the
/// index is built here, candidates are found as they are pulled.
std::unique_ptr<Candidates> join_candidates(const JoinQuestion& question, JoinMethod method,
                                            const Horizon& horizon, const Contact::Reach& reach,
                                            Interrupt& interrupt);

/// The same by the grid, in parts for question.helpers threads.
std::unique_ptr<DividedCandidates> divided_candidates(const JoinQuestion& question, const Horizon& horizon,
                                                      const Contact::Reach& reach, Interrupt& interrupt);

}  // namespace foresee
