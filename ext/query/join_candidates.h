// Stage one of a join: which pairs are worth a look, and by which method they are found.
#pragma once

#include "query/join.h"

namespace foresee {

struct MethodChoice {
  JoinMethod method;  ///< never automatic
  const char* why;    ///< for people
};

/// What `method` says, or for 'auto' what promises to be fastest.
MethodChoice choose_method(const JoinQuestion& question);

/// Every pair of `question` that can touch, and others. `reach` says how far swept boxes must grow together.
std::unique_ptr<Candidates> join_candidates(const JoinQuestion& question, const Contact::Reach& reach,
                                            Interrupt& interrupt);

}  // namespace foresee
