// Candidate stage of a join: the pairs that an index or a scan yields for the exact stage.
#pragma once

#include "index/candidates.h"
#include "query/join/question.h"

namespace foresee {

/// Every queried pair that can touch during `horizon`, once, and others (candidates.h), by `method` (not
/// automatic); the method decides only which others, and the order. Only pairs that `question.own` owns.
/// `question` must outlive the result. Cost: the index is built here, candidates are found as they are pulled.
std::unique_ptr<Candidates> join_candidates(const JoinQuestion& question, JoinMethod method,
                                            const Horizon& horizon, Interrupt& interrupt);

/// join_candidates() by the grid, divided among `question.helpers` threads.
std::unique_ptr<DividedCandidates> divided_candidates(const JoinQuestion& question, const Horizon& horizon,
                                                      Interrupt& interrupt);

}  // namespace foresee
