#include "query/legs/mover_pair.h"

#include <cmath>

#include "motion/motion.h"

namespace foresee {
namespace {

constexpr std::size_t legs_at_once = 64;

bool is_bent(const Movers& movers) {
  return degree_of(movers.scene()->layout.law) > 1;
}
/// Whether a time is within the horizon's end, exactly: the sum of now and h is rounded, and corrected here.
bool is_by_end(double time, const Horizon& horizon) {
  const double end = horizon.now + horizon.h, of_h = end - horizon.now;
  const double error = (horizon.now - (end - of_h)) + (horizon.h - of_h);
  return time < end || (time == end && error >= 0);
}
/// Whether a contact that is joined to another makes it longer.
bool extend(ContactTimes& joined, const ContactTimes& more) {
  const bool is_longer = more.t_end > joined.t_end || more.dt_end > joined.dt_end;
  joined.t_end = std::max(joined.t_end, more.t_end), joined.dt_end = std::max(joined.dt_end, more.dt_end);
  return is_longer;
}
bool has_forms(const Movers& movers) {
  return is_stored_apart(movers.scene()->layout.shape);
}

}  // namespace

MoverPair::MoverPair(const Movers& a, const Movers& b, Contact& contact, const Horizon& horizon,
                     Interrupt& interrupt)
    : a_(a),
      b_(b),
      contact_(contact),
      horizon_(horizon),
      interrupt_(interrupt),
      tests_all_contacts_((is_bent(a) || is_bent(b)) && !has_forms(a) && !has_forms(b)) {}

void MoverPair::test_legs() {
  interrupt_.check();
  touching_.clear();
  times_.clear();
  if (tests_all_contacts_)
    contact_.all_contacts(legs_, touching_, times_);
  else
    contact_.first_contacts(legs_, TimesWanted::both, touching_, times_);
  for (std::size_t i = 0; i < touching_.size(); ++i)
    gathered_.push_back({touching_[i].a, touching_[i].b, times_[i]});
  legs_.clear();
}

void MoverPair::gather(const Pair& movers, double from, double until, bool follow) {
  double bound = until;
  std::vector<ContactTimes> later;  // they start beyond the bound, so far
  const auto test_and_follow = [&] {
    const std::size_t known = gathered_.size();
    test_legs();
    if (!follow) return;
    for (std::size_t i = known; i < gathered_.size(); ++i) later.push_back(gathered_[i].times);
    for (std::size_t waiting = later.size() + 1; later.size() < waiting;) {
      waiting = later.size();
      std::erase_if(later, [&](const ContactTimes& times) {
        if (times.t > bound) return false;
        bound = std::max(bound, times.t_end);
        return true;
      });
    }
  };
  legs_.clear();
  for_leg_pairs(a_, b_, movers, from, [&](const Pair& legs) {
    const double start = start_of(legs);
    if (legs_.size() >= legs_at_once || (start > bound && !legs_.empty())) test_and_follow();
    if (start > bound) return false;
    legs_.push_back(legs);
    return true;
  });
  if (!legs_.empty()) test_legs();
}

void MoverPair::add_leg_ends(std::span<MoverHit> hits) {
  for (std::size_t first = 0; first < hits.size(); first += legs_at_once) {
    interrupt_.check();
    const auto some = hits.subspan(first, std::min(legs_at_once, hits.size() - first));
    legs_.clear();
    touching_.clear();
    times_.clear();
    for (const MoverHit& hit : some) legs_.push_back(hit.legs);
    contact_.first_contacts(legs_, TimesWanted::both, touching_, times_);
    for (std::size_t i = 0; i < some.size(); ++i)
      some[i].times.t_end = times_[i].t_end, some[i].times.dt_end = times_[i].dt_end;
  }
}

bool MoverPair::is_complete(const MoverHit& hit) const {
  return hit.times.t > start_of(hit.legs) && hit.times.t_end < end_of(hit.legs);
}

void MoverPair::add_ends(std::span<MoverHit> hits) {
  add_leg_ends(hits);
  follow(hits);
}

void MoverPair::follow(std::span<MoverHit> hits) {
  followed_.clear();
  for (MoverHit& hit : hits) {
    if (hit.times.t_end < end_of(hit.legs)) continue;
    if (!tests_all_contacts_) {
      followed_.push_back({&hit, LegPairs(a_, b_, hit.legs), {}});
      continue;
    }
    gathered_.clear();
    gather(a_.movers_of(hit.legs, b_), hit.times.t, hit.times.t_end, true);
    hit.times = mover_contacts(gathered_).front();
  }
  while (!followed_.empty()) follow_a_leg();
}

/// One round for all contacts that go on: the next pair of legs of each is tested, all in one call.
void MoverPair::follow_a_leg() {
  interrupt_.check();
  std::size_t kept = 0;
  legs_.clear();
  touching_.clear();
  times_.clear();
  for (Followed& one : followed_) {
    const auto next = one.legs.next();
    if (!next || start_of(*next) > one.hit->times.t_end) continue;
    legs_.push_back(*next);
    if (&followed_[kept] != &one) followed_[kept] = std::move(one);
    ++kept;
  }
  followed_.erase(followed_.begin() + static_cast<std::ptrdiff_t>(kept), followed_.end());
  contact_.first_contacts(legs_, TimesWanted::both, touching_, times_);
  for (std::size_t i = 0, hit = 0; i < touching_.size(); ++i, ++hit) {
    while (legs_[hit] != touching_[i]) ++hit;
    Followed& one = followed_[hit];
    ContactTimes& joined = one.hit->times;
    if (times_[i].t > joined.t_end) {
      one.later.push_back(times_[i]);  // it may be joined by a contact that follows
      continue;
    }
    extend(joined, times_[i]);
    for (bool more = !one.later.empty(); more;) {
      more = false;
      for (const ContactTimes& times : one.later)
        if (times.t <= joined.t_end) more = extend(joined, times) || more;
    }
  }
}

bool MoverPair::touch_before(const MoverHit& hit) {
  const auto is_before = [&](const ContactTimes& times) {
    return times.t < hit.times.t || (times.t == hit.times.t && times.dt < hit.times.dt);
  };
  bool before = false;
  const auto test = [&] {
    interrupt_.check();
    touching_.clear();
    times_.clear();
    contact_.first_contacts(legs_, TimesWanted::starts, touching_, times_);
    before = std::any_of(times_.begin(), times_.end(), is_before);
    legs_.clear();
  };
  legs_.clear();
  for_leg_pairs(a_, b_, a_.movers_of(hit.legs, b_), horizon_.now, [&](const Pair& legs) {
    if (start_of(legs) > hit.times.t) return false;
    legs_.push_back(legs);
    if (legs_.size() == legs_at_once) test();
    return !before;
  });
  if (!legs_.empty() && !before) test();
  return before;
}

void MoverPair::contacts_within(const Pair& movers, double from, double until,
                                std::vector<ContactTimes>& found) {
  gathered_.clear();
  gather(movers, from, until, false);
  found = mover_contacts(gathered_);
  // Contacts that started before were followed where they started.
  const auto lasts = [&](const ContactTimes& times) {
    return times.t >= from && times.t <= until && times.t_end >= until;
  };
  if (std::none_of(found.begin(), found.end(), lasts)) return;
  gathered_.clear();
  gather(movers, from, until, true);
  found = mover_contacts(gathered_);
}

// The distance of the centres is that of the origin from a path relative to the other centre: a segment, and for bent
// paths a curve at most |a| L^2 / 8 beside it.
bool MoverPair::is_clearly_farther(const Pair& legs, double distance) const {
  const double start = std::max(start_of(legs), horizon_.now),
               end = std::min(end_of(legs), horizon_.now + horizon_.h);
  if (!(end - start < 0x1p60) || !(distance < 0x1p500)) return false;
  double along = 0, square = 0, offset = 0, slack = 0;
  std::array<double, 3> from{}, path{};
  const int axes = a_.bodies().layout.axes;
  for (int side = 0; side < 2; ++side) {
    const Bodies& bodies = (side == 0 ? a_ : b_).bodies();
    const Offsets& at = bodies.at;
    const double* const row = bodies.row(side == 0 ? legs.a : legs.b);
    const double sign = side == 0 ? -1 : 1, t = value_or(row, at.t, 0), before = start - t, after = end - t;
    for (int axis = 0; axis < axes; ++axis) {
      const auto j = static_cast<std::size_t>(axis);
      const double x = row[at.x + axis], v = at.v == Offsets::absent ? 0 : row[at.v + axis];
      const double a = at.a == Offsets::absent ? 0 : row[at.a + axis] / 2;
      const double first = x + (v + a * before) * before, last = x + (v + a * after) * after;
      from[j] += sign * first, path[j] += sign * (last - first);
      slack += std::abs(a) * (end - start) * (end - start) / 4;
      const double far = std::max(std::abs(before), std::abs(after)) + std::abs(t) + std::abs(end);
      slack += 0x1p-44 * (std::abs(x) + (std::abs(v) + std::abs(a) * far) * far);
    }
  }
  for (std::size_t j = 0; j < 3; ++j) along -= from[j] * path[j], square += path[j] * path[j];
  const double part = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  for (std::size_t j = 0; j < 3; ++j) {
    const double nearest = from[j] + part * path[j];
    offset += nearest * nearest;
  }
  return std::sqrt(offset) - slack > distance * (1 + 0x1p-20);
}

ClosestApproach MoverPair::closest_approach(const Pair& legs) {
  ClosestApproach best{};
  legs_.assign(1, legs);
  contact_.closest_approach(legs_, {&best, 1});
  const auto compare = [&] {
    interrupt_.check();
    approaches_.resize(legs_.size());
    contact_.closest_approach(legs_, approaches_);
    for (const ClosestApproach& one : approaches_)
      if (one.d < best.d || (one.d == best.d && (one.t < best.t || (one.t == best.t && one.dt < best.dt))))
        best = one;
    legs_.clear();
  };
  legs_.clear();
  for_leg_pairs(a_, b_, a_.movers_of(legs, b_), horizon_.now, [&](const Pair& others) {
    if (!is_by_end(start_of(others), horizon_)) return false;
    if (others == legs || is_clearly_farther(others, best.d)) return true;
    legs_.push_back(others);
    if (legs_.size() == legs_at_once) compare();
    return true;
  });
  if (!legs_.empty()) compare();
  return best;
}

}  // namespace foresee
