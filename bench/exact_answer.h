// The pairs among an index's candidates that touch, and when, by foresee's exact contact.
//
//   const Answer answer = exact_answer(*candidates, *contact);
//
// The numbers of a pair are rows. `row_of` translates those of an index that stores objects in another order.
#pragma once

#include <vector>

#include "contact/contact.h"
#include "core_rivals.h"
#include "index/candidates.h"
#include "measure.h"

namespace foresee::bench {

/// Adds the time of the contact alone to `contact_seconds`, unless it is null.
template <class RowOf>
Answer exact_answer(Candidates& candidates, Contact& contact, double* contact_seconds, RowOf row_of) {
  Answer answer;
  std::vector<Pair> batch, hits;
  std::vector<ContactTimes> times;
  const auto add = [&](const Pair& pair, double t) { answer.add({row_of(pair.a), row_of(pair.b)}, t); };
  for (; candidates.next(batch); batch.clear()) {
    answer.candidates += batch.size();
    if (candidates.touching()) {
      for (const Pair& pair : batch) add(pair, 0);
      continue;
    }
    hits.clear(), times.clear();
    const double begin = contact_seconds ? cpu_seconds() : 0;
    contact.first_contacts(batch, TimesWanted::starts, hits, times);
    if (contact_seconds) *contact_seconds += cpu_seconds() - begin;
    for (std::size_t i = 0; i < hits.size(); ++i) add(hits[i], times[i].t);
  }
  return answer;
}

inline Answer exact_answer(Candidates& candidates, Contact& contact, double* contact_seconds = nullptr) {
  return exact_answer(candidates, contact, contact_seconds, [](std::uint32_t row) { return row; });
}

}  // namespace foresee::bench
