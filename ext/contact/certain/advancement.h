// One pair on its way through the horizon, in double arithmetic with certified signs.
//
// Conservative advancement (B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996):
// while the pair is certainly apart, time leaps by the longest stretch for which that is certain; then, from
// a moment at which it certainly touches, by the longest stretches of contact. What stays in doubt is a
// sliver around each crossing, or everything where the crossing is a graze: then the answer is `uncertain`,
// and other means must decide.
#pragma once

#include <cstdint>

#include "contact/certain/certain_set.h"
#include "contact/certain/root_bracketing.h"

namespace foresee {

enum class Verdict : std::uint8_t { no, yes, uncertain };

template <int D, int Degree>
class Advancement {
 public:
  /// On the moments at which both exist: those asked about, rounded outward, and those that certainly count.
  /// `near`: only then can they touch, if at all.
  [[gnu::flatten]] Advancement(const ContactSet& set, const Setup& setup, const double* row_a,
                               const double* row_b, const PairLifetime& lifetime,
                               const Interval<double>& near, CertainScratch& scratch)
      : certain_(set, setup, row_a, row_b, scratch) {
    constexpr double u = unit_roundoff;
    const double begin = lifetime.dt_start, end = lifetime.dt_end;
    begin_ = std::max(lifetime.start_exact ? begin : begin * (1 - 2 * u), near.begin);
    inner_start_ = lifetime.start_exact ? begin : begin * (1 + 2 * u);
    end_ = lifetime.end_exact ? end : end * (1 + 2 * u);
    inner_end_ = lifetime.end_exact ? end : end * (1 - 2 * u);
    near_end_ = std::min(end_, near.end);
  }

  /// Is there a contact? Looks for any moment of it, not for its begin.
  Verdict touches() {
    if (begin_ > near_end_) return Verdict::no;
    double tau = begin_;
    for (int leaps = 0; leaps < max_leaps; ++leaps) {
      const double step = apart(tau);
      const double next = step >= 0 ? after_leap(tau, step) : tau;
      if (next > near_end_) return Verdict::no;
      const double inside = std::max(next * (1 + 0x1p-20), inner_start_);
      if (inside <= inner_end_ && certain_.now_within(inside)) return Verdict::yes;
      if (!(next > tau)) break;
      tau = next;
    }
    Bracket first;
    return first_contact(first);
  }

  /// Is there a contact? If yes, `first` brackets its begin.
  Verdict first_contact(Bracket& first) {
    if (begin_ > near_end_) return Verdict::no;
    const double stopped = leap([this](double tau) { return apart(tau); }, begin_, near_end_);
    if (stopped == for_ever) return Verdict::no;
    first = {stopped, stopped};
    const bool met = witness([this](double tau) { return certain_.now_within(tau); }, first, inner_start_);
    return met ? Verdict::yes : Verdict::uncertain;
  }

  /// From a moment of certain contact: brackets its end. yes: it ends; no: it lasts to the end of the
  /// horizon.
  Verdict end_of_contact(double from, Bracket& last) {
    const auto within = [this](double tau) { return certain_.within(tau, room_from(tau, end_)); };
    const double stopped = leap(within, from, end_);
    if (stopped == for_ever) return Verdict::no;
    last = {stopped, stopped};
    const bool left = witness([this](double tau) { return certain_.now_apart(tau); }, last, stopped);
    return left ? Verdict::yes : Verdict::uncertain;
  }

  CertainSet<D, Degree>& certain() { return certain_; }

 private:
  static double room_from(double tau, double end) { return (end - tau) * (1 + 4 * unit_roundoff); }
  /// CertainSet::apart(), up to near_end_.
  double apart(double tau) { return certain_.apart(tau, room_from(tau, near_end_)); }

  /// root_bracketing.h, up to the moments that certainly count.
  template <class Predicate>
  bool witness(Predicate&& predicate, Bracket& bracket, double earliest) const {
    return foresee::witness(predicate, bracket, earliest, inner_end_);
  }

  CertainSet<D, Degree> certain_;
  double begin_, inner_start_, inner_end_, end_;
  double near_end_;  ///< they do not touch later
};

}  // namespace foresee
