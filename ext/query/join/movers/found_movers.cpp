#include "query/join/movers/found_movers.h"

#include <algorithm>
#include <tuple>

#include "base/interrupt_steps.h"

namespace foresee {

std::uint64_t PairTable::find_or_add(const Pair& pair, std::uint64_t number) {
  const std::uint64_t key = key_of(pair);
  for (std::size_t i = place_of(pair);; i = (i + 1) & (slots_.size() - 1)) {
    Slot& slot = slots_[i];
    if (slot.number_plus_one == 0) {
      slot = {key, number + 1};
      if (++size_ * 2 > slots_.size()) grow();
      return number;
    }
    if (slot.pair == key) return slot.number_plus_one - 1;
  }
}

void PairTable::grow() {
  std::vector<Slot> smaller(2 * slots_.size());
  smaller.swap(slots_);
  --shift_;
  for (const Slot& slot : smaller) {
    if (slot.number_plus_one == 0) continue;
    std::size_t i = slot.pair * by_golden_ratio >> shift_;
    while (slots_[i].number_plus_one != 0) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = slot;
  }
}

void FoundMovers::drop_found(std::vector<Pair>& candidates, const SlabLegs& legs_a, const SlabLegs& legs_b) {
  keys_.clear();
  for (const Pair& rows : candidates) {
    keys_.push_back(movers_of(rows, legs_a, legs_b));
    pairs_.prefetch(keys_.back());
  }
  const bool within = &a_ == &b_;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    candidates[kept] = candidates[i];
    kept += !(within && keys_[i].a == keys_[i].b) && !pairs_.holds_before(keys_[i], pairs_before_);
  }
  candidates.resize(kept);
}

void FoundMovers::add(const Hits& hits, const SlabLegs& legs_a, const SlabLegs& legs_b) {
  with_ends_ = hits.with_ends;
  keys_.clear();
  if (!keeps_all_)
    for (const Pair& rows : hits.pairs) {
      keys_.push_back(movers_of(rows, legs_a, legs_b));
      pairs_.prefetch(keys_.back());
    }
  for (std::size_t i = 0; i < hits.pairs.size(); ++i) {
    const MoverHit hit{{legs_a.leg(hits.pairs[i].a), legs_b.leg(hits.pairs[i].b)}, hits.times[i]};
    if (keeps_all_) {
      found_.push_back(hit);
      continue;
    }
    const std::uint64_t next = pairs_before_ + found_.size(), at = pairs_.find_or_add(keys_[i], next);
    if (at < pairs_before_) continue;
    if (at == next) {
      found_.push_back(hit);
      continue;
    }
    MoverHit& other = found_[at - pairs_before_];
    if (std::tie(hit.times.t, hit.times.dt) < std::tie(other.times.t, other.times.dt)) other = hit;
  }
}

void FoundMovers::finish(const TimeSlab& slab, Interrupt& interrupt) {
  pairs_before_ += found_.size();
  if (question_.all_contacts)
    join_contacts(slab, interrupt);
  else if (!question_.queries_all_times())
    keep_first_contacts(interrupt);
  given_ = 0, sorted_ = question_.order == JoinOrder::any ? found_.size() : 0;
  constexpr std::size_t min_room = 4096;
  room_ = std::max(min_room, question_.likely_rows);
}

void FoundMovers::keep_first_contacts(Interrupt& interrupt) {
  const bool is_bounded = question_.queried_t.min > question_.now || question_.queried_dt.min > 0;
  std::erase_if(found_, [&](const MoverHit& hit) {
    interrupt.check();
    return !are_queried(hit.times) || (is_bounded && pair_.touch_before(hit));
  });
}

void FoundMovers::join_contacts(const TimeSlab& slab, Interrupt& interrupt) {
  if (!with_ends_) pair_.add_leg_ends(found_);
  const auto key = [&](const MoverHit& hit) {
    const Pair movers = a_.movers_of(hit.legs, b_);
    return std::tuple(movers.a, movers.b, hit.times.t, hit.times.dt, hit.legs.a, hit.legs.b);
  };
  Steps steps(interrupt);
  std::sort(found_.begin(), found_.end(), [&](const MoverHit& l, const MoverHit& r) {
    steps();
    return key(l) < key(r);
  });
  joined_.clear();
  for (std::size_t first = 0, last; first < found_.size(); first = last) {
    interrupt.check();
    const Pair movers = a_.movers_of(found_[first].legs, b_);
    for (last = first + 1; last < found_.size() && a_.movers_of(found_[last].legs, b_) == movers;) ++last;
    join_contacts_of(first, last, slab);
  }
  found_.swap(joined_);
}

void FoundMovers::join_contacts_of(std::size_t first, std::size_t last, const TimeSlab& slab) {
  const std::size_t before = joined_.size();
  const auto begin = found_.begin() + static_cast<std::ptrdiff_t>(first),
             end = found_.begin() + static_cast<std::ptrdiff_t>(last);
  if (std::all_of(begin, end, [&](const MoverHit& hit) { return pair_.is_complete(hit); })) {
    joined_.insert(joined_.end(), begin, end);
  } else {
    const Horizon& part = slab.horizon;
    pair_.contacts_within(a_.movers_of(found_[first].legs, b_), part.now, part.now + part.h, contacts_);
    for (const ContactTimes& times : contacts_)
      if (slab.holds(times.t) && are_queried(times)) joined_.push_back({found_[first].legs, times});
  }
  // Contacts that t and t_end do not tell apart are one row.
  std::size_t kept = before;
  for (std::size_t i = before; i < joined_.size(); ++i) {
    const ContactTimes& times = joined_[i].times;
    ContactTimes& row = joined_[kept > before ? kept - 1 : i].times;
    if (kept > before && row.t == times.t && row.t_end == times.t_end) {
      row.dt = std::min(row.dt, times.dt), row.dt_end = std::max(row.dt_end, times.dt_end);
      continue;
    }
    joined_[kept++] = joined_[i];
  }
  joined_.resize(kept);
}

bool FoundMovers::precedes(const MoverHit& l, const MoverHit& r) const {
  if (l.times.t != r.times.t) return l.times.t < r.times.t;
  if (question_.order != JoinOrder::by_t_and_ids && l.times.dt != r.times.dt) return l.times.dt < r.times.dt;
  const auto& ids_a = a_.scene()->ids;
  const auto& ids_b = b_.scene()->ids;
  const std::int64_t l_a = ids_a[l.legs.a], r_a = ids_a[r.legs.a], l_b = ids_b[l.legs.b],
                     r_b = ids_b[r.legs.b];
  if (l_a != r_a) return l_a < r_a;
  if (l_b != r_b) return l_b < r_b;
  return question_.all_contacts && l.times.t_end < r.times.t_end;
}

void FoundMovers::sort_some(Interrupt& interrupt) {
  Steps steps(interrupt);
  const auto before = [&](const MoverHit& l, const MoverHit& r) {
    steps();
    return precedes(l, r);
  };
  const auto begin = found_.begin() + static_cast<std::ptrdiff_t>(sorted_);
  const std::size_t count = std::min(room_, found_.size() - sorted_);
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  if (end != found_.end()) std::nth_element(begin, end, found_.end(), before);
  std::sort(begin, end, before);
  constexpr std::size_t growth = 8;
  sorted_ += count;
  room_ = room_ > found_.max_size() / growth ? found_.max_size() : growth * room_;
}

void FoundMovers::take(std::vector<MoverHit>& hits, Interrupt& interrupt) {
  constexpr std::size_t some = 256;
  if (given_ == sorted_) sort_some(interrupt);
  const std::size_t count = std::min(some, sorted_ - given_);
  const auto begin = found_.begin() + static_cast<std::ptrdiff_t>(given_);
  hits.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
  given_ += count;
  if (question_.wants.contact && question_.wants.ends && !question_.all_contacts) {
    if (with_ends_)
      pair_.follow(hits);
    else
      pair_.add_ends(hits);
  }
  if (any()) return;
  found_.clear();
  given_ = sorted_ = 0;
}

}  // namespace foresee
