#include "query/join/sorted_hits.h"

#include <algorithm>

namespace foresee {

void SortedHits::add(const Hits& hits) {
  for (std::size_t i = 0; i < hits.pairs.size(); ++i)
    found_.push_back({hits.times[i].t, hits.times[i].dt, hits.pairs[i]});
}

bool SortedHits::precedes(const Found& l, const Found& r) const {
  if (l.t != r.t) return l.t < r.t;
  if (question_.order != JoinOrder::by_t_and_ids) return l.dt < r.dt;  // rounding keeps order: both rise
  const Scene& a = *question_.a;
  const Scene& b = question_.b ? *question_.b : a;
  const std::int64_t l_a = a.ids[l.pair.a], r_a = a.ids[r.pair.a];
  return l_a != r_a ? l_a < r_a : b.ids[l.pair.b] < b.ids[r.pair.b];
}

void SortedHits::sort(Interrupt& interrupt) {
  constexpr std::size_t comparisons_per_check = 1 << 16;
  std::size_t comparisons = 0;
  std::sort(found_.begin(), found_.end(), [&](const Found& l, const Found& r) {
    if (++comparisons % comparisons_per_check == 0) interrupt.check();
    return precedes(l, r);
  });
  sorted_ = found_.size();
}

void SortedHits::take(Hits& hits) {
  constexpr std::size_t some = 256;
  hits.clear();
  const std::size_t end = std::min(sorted_, given_ + some);
  for (; given_ < end; ++given_) {
    const Found& found = found_[given_];
    hits.pairs.push_back(found.pair);
    hits.times.push_back({found.t, found.t, found.dt, found.dt});
  }
  if (given_ == sorted_) found_.clear(), sorted_ = given_ = 0;
}

}  // namespace foresee
