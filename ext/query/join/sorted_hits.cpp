#include "query/join/sorted_hits.h"

#include <algorithm>

#include "base/interrupt_steps.h"

namespace foresee {

void SortedHits::add(const Hits& hits, Interrupt& interrupt) {
  for (std::size_t i = 0; i < hits.pairs.size(); ++i) {
    const Found found{hits.times[i].t, hits.times[i].dt, hits.pairs[i]};
    // Contacts of one pair with one t and dt are one hit, which write_rows() expands again.
    if (question_.all_contacts && i > 0 && hits.pairs[i] == hits.pairs[i - 1] &&
        found.t == hits.times[i - 1].t && found.dt == hits.times[i - 1].dt)
      continue;
    if ((cut_ && !precedes(found, last_)) || (after_ && !precedes(*after_, found))) continue;
    found_.push_back(found);
    if (found_.size() / 2 >= room_) keep_first(interrupt);
  }
}

bool SortedHits::precedes(const Found& l, const Found& r) const {
  if (l.t != r.t) return l.t < r.t;
  if (question_.order != JoinOrder::by_t_and_ids) {
    if (l.dt != r.dt) return l.dt < r.dt;  // rounding is monotonic: both ascend
    return l.pair.a != r.pair.a ? l.pair.a < r.pair.a : l.pair.b < r.pair.b;
  }
  const Scene& a = *question_.a;
  const Scene& b = question_.side_b();
  const std::int64_t l_a = a.ids[l.pair.a], r_a = a.ids[r.pair.a];
  return l_a != r_a ? l_a < r_a : b.ids[l.pair.b] < b.ids[r.pair.b];
}

void SortedHits::keep_first(Interrupt& interrupt) {
  Steps steps(interrupt);
  const auto last = found_.begin() + static_cast<std::ptrdiff_t>(room_ - 1);
  std::nth_element(found_.begin(), last, found_.end(), [&](const Found& l, const Found& r) {
    steps();
    return precedes(l, r);
  });
  last_ = *last;
  found_.resize(room_);
  cut_ = true;
}

void SortedHits::sort(Interrupt& interrupt) {
  if (found_.size() > room_) keep_first(interrupt);
  Steps steps(interrupt);
  std::sort(found_.begin(), found_.end(), [&](const Found& l, const Found& r) {
    steps();
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
  if (given_ < sorted_) return;
  after_.reset();
  if (cut_) {
    after_ = found_.back();
    room_ = room_ > found_.max_size() / growth ? found_.max_size() : room_ * growth;
  }
  found_.clear();
  sorted_ = given_ = 0;
}

}  // namespace foresee
