// The contact module as the report on accuracy measures it: whole, its exact stage alone, the stage that
// decides, and the true result.
#pragma once

#include "accuracy/methods.h"
#include "contact/contact.h"

namespace foresee::bench {

/// The method of users: make_contact, decisions and starts, in batches.
Method filtered_engine(const Family& family);

/// The exact stage for every pair.
Method exact_stage(const Family& family);

/// Counts of the stage that decides, over the pairs of a family.
struct StageShares {
  std::size_t chord = 0, certified = 0, exact = 0;                       ///< the decision
  std::size_t hits = 0, at_once = 0, double_double = 0, exact_time = 0;  ///< the start, of hits
};
StageShares stage_shares(const Family& family);

/// The true results, by the exact stage. The first `judged` pairs are also checked by the oracle of the tests
/// (rationals and Sturm sequences, sharing no code with the engine); `complaints` counts its disagreements.
struct Truth {
  std::vector<Answer> answers;
  std::size_t judged = 0, complaints = 0;
};
Truth truth_of(const Family& family, std::size_t judged);

}  // namespace foresee::bench
