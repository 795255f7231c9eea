// Rows of a query for every contact: contacts of one pair that t and t_end do not tell apart become one row.
//
//   contact.all_contacts(pairs, hits, times);
//   join_equal_contacts(0, hits, times);                 // a, b, t, t_end are the key of a row
//
// Two contacts a fraction of a second apart may round to the same t and t_end where times have many digits. The row
// has the smallest dt and the largest dt_end. Cost: a comparison per contact.
#pragma once

#include <algorithm>
#include <vector>

#include "contact/contact.h"

namespace foresee {

/// From number `first` on. Requires: contacts of one pair follow each other in order of time.
inline void join_equal_contacts(std::size_t first, std::vector<Pair>& pairs,
                                std::vector<ContactTimes>& times) {
  std::size_t kept = first;
  for (std::size_t i = first; i < pairs.size(); ++i) {
    ContactTimes& last = times[kept > first ? kept - 1 : i];
    if (kept > first && pairs[kept - 1] == pairs[i] && last.t == times[i].t && last.t_end == times[i].t_end) {
      last.dt_end = std::max(last.dt_end, times[i].dt_end);
      continue;
    }
    pairs[kept] = pairs[i], times[kept] = times[i];
    ++kept;
  }
  pairs.resize(kept);
  times.resize(kept);
}

}  // namespace foresee
