// The contact room as the report sees it: whole, its exact stage alone, which stage decides, and the truth.
#pragma once

#include "accuracy/methods.h"
#include "contact/contact.h"

namespace foresee::bench {

/// What users get: make_contact, decisions and begins, in batches.
Method filtered_engine(const Family& family);

/// The exact stage for every pair.
Method exact_stage(const Family& family);

/// How often each stage has the last word, over the pairs of a family.
struct StageShares {
  std::size_t chord = 0, certified = 0, exact = 0;                       ///< the decision
  std::size_t hits = 0, at_once = 0, double_double = 0, exact_time = 0;  ///< the begin, of hits
};
StageShares stage_shares(const Family& family);

/// The right answers, by the exact stage. The first `judged` pairs are also put before the judge of the tests
/// (rationals and Sturm sequences, sharing no code with the engine); `complaints` counts what it objects to.
struct Truth {
  std::vector<Answer> answers;
  std::size_t judged = 0, complaints = 0;
};
Truth truth_of(const Family& family, std::size_t judged);

}  // namespace foresee::bench
