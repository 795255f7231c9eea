// Conservative advancement: contact of one pair during the horizon, in double arithmetic with certified
// signs.
//
// While the pair is certainly apart, time advances by the longest step for which that is certain. From a time
// at which the pair certainly touches, it advances by the longest steps of contact. What stays undecided is a
// short interval around each crossing, or everything if the crossing is a graze: then the answer is
// `uncertain`, and the exact stage decides.
//
// The contact set is expanded at a time: the polynomial of each primitive, with error bounds, says for how
// long it is certainly positive (outside) or negative (inside). The pair is outside a piece while one of its
// primitives is positive, and outside the set while it is outside all pieces. It is inside a piece while all
// of its primitives are negative, and inside the set while it is inside one piece. A primitive that several
// pieces share is evaluated once; one that cannot change the answer is not evaluated.
//
// Source: B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems" (1996).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "contact/certified/certain_motion.h"
#include "contact/certified/pair_context.h"
#include "contact/certified/root_bracketing.h"
#include "contact/minkowski/contact_set.h"

namespace foresee {

template <int D, int Degree>
class CertainSet {
 public:
  /// `lengths`: of the pair. `known`: scratch space. All arguments must outlive this.
  CertainSet(const ContactSet& set, const CertainMotion<D>& relative, const Bounded* lengths,
             std::vector<double>& known)
      : set_(set), relative_(relative), lengths_(lengths), known_(known) {
    known.resize(set.primitives().size());
  }

  /// For how long from tau on the pair is certainly outside the set, or not_certain. At most `room`, or
  /// unbounded.
  double apart(double tau, double room) {
    expand_at(tau);
    forget();
    double shortest = unbounded;
    for (const ContactSet::Piece& piece : set_.pieces()) {
      // A piece that is apart for longer than another changes nothing; bounds around a ball show that at less
      // cost.
      if (shortest < unbounded && longest_apart(piece.around, shortest, room) >= shortest) continue;
      shortest = std::min(shortest, longest_apart(piece.all, shortest, room));
      if (shortest < 0) break;
    }
    return shortest;
  }

  /// For how long from tau on the pair is certainly inside the set, or not_certain.
  double within(double tau, double room) {
    expand_at(tau);
    forget();
    double greatest = not_certain;
    for (const ContactSet::Piece& piece : set_.pieces())
      greatest = std::max(greatest, shortest_within(piece.all, greatest, room));
    return greatest;
  }

  /// Whether the pair is certainly inside the set at tau.
  bool now_within(double tau) {
    return has_piece_where(tau, [](double side) { return side < 0; });
  }

  /// Whether the pair is certainly outside the set at tau.
  bool now_apart(double tau) {
    return !has_piece_where(tau, [](double side) { return side <= 0; });
  }

  /// Expands the motion at tau, for the functions about single primitives that follow.
  [[gnu::always_inline]] void expand_at(double tau) {
    tau_ = tau;
    x_ = expanded_at<Degree>(relative_, tau);
  }

  /// Calls `take` with the polynomial of a primitive.
  template <class Take>
  auto with_polynomial(const Primitive& primitive, Take&& take) const {
    const auto wanted = [](const Bounded&) { return true; };
    return foresee::with_polynomial<Degree>(primitive, x_.data(), lengths_, tau_, wanted, take);
  }

  /// Bound on the underflow of a coefficient: 0 if it has no products.
  double lost(const Primitive& primitive) const {
    const bool sums = primitive.kind == ConstraintKind::half_space && !primitive.size.moves();
    return sums ? 0 : relative_.underflow + 0x1p-1060;
  }

  const ContactSet& set() const { return set_; }
  const CertainMotion<D>& relative() const { return relative_; }

 private:
  void forget() { std::fill(known_.begin(), known_.end(), std::numeric_limits<double>::quiet_NaN()); }

  /// Whether holds(value_now()) is true at tau for all primitives of some piece.
  template <class Holds>
  bool has_piece_where(double tau, Holds&& holds) {
    expand_at(tau);
    forget();
    return std::any_of(set_.pieces().begin(), set_.pieces().end(), [&](const ContactSet::Piece& piece) {
      const auto all = set_.members(piece.all);
      return std::all_of(all.begin(), all.end(), [&](int i) { return holds(value_now(i)); });
    });
  }

  /// For how long one of these primitives is certainly positive, or not_certain; exact only below `enough`.
  double longest_apart(const ContactSet::Part& part, double enough, double room) {
    double longest = not_certain;
    for (const int i : set_.members(part)) {
      longest = std::max(longest, lasts(i, 1, room));
      if (longest >= enough) break;
    }
    return longest;
  }

  /// For how long all of these primitives are certainly negative, or not_certain; exact only above `enough`.
  double shortest_within(const ContactSet::Part& part, double enough, double room) {
    double shortest = unbounded;
    for (const int i : set_.members(part)) {
      shortest = std::min(shortest, lasts(i, -1, room));
      if (shortest <= enough) break;
    }
    return shortest;
  }

  /// For how long primitive i is certainly positive (side 1) or negative (-1), or not_certain.
  [[gnu::flatten]] double lasts(int i, double side, double room) {
    const auto place = static_cast<std::size_t>(i);
    double& known = known_[place];
    if (!std::isnan(known)) return known;
    const Primitive& primitive = set_.primitives()[place];
    const double lost = this->lost(primitive);
    const auto wanted = [side, lost](const Bounded& now) { return side * now.value > now.error_bound(lost); };
    const auto take = [side, lost, room](const auto& p) { return positive_during(p, side, lost, room); };
    return known = foresee::with_polynomial<Degree>(primitive, x_.data(), lengths_, tau_, wanted, take);
  }

  /// Primitive i at tau: 1: certainly outside, -1: certainly inside, 0: undecided.
  [[gnu::flatten]] double value_now(int i) {
    const auto place = static_cast<std::size_t>(i);
    double& known = known_[place];
    if (!std::isnan(known)) return known;
    const Primitive& primitive = set_.primitives()[place];
    Coefficients<Bounded, 0> x[D];
    for (std::size_t j = 0; j < D; ++j) x[j] = {x_[j][0]};
    const Bounded value = polynomial_of<0>(primitive, x, lengths_, tau_)[0];
    const double error = value.error_bound(lost(primitive));
    return known = value.value - error > 0 ? 1 : -value.value - error > 0 ? -1 : 0;
  }

  const ContactSet& set_;
  const CertainMotion<D>& relative_;
  const Bounded* const lengths_;
  std::vector<double>& known_;  ///< the result of each primitive for the current test; NaN: not evaluated
  std::array<Coefficients<Bounded, Degree>, D> x_;
  double tau_ = 0;
};

template <int D, int Degree>
class Advancement {
 public:
  /// `certain`: of the pair, must outlive this. `lifetime`: when both objects exist; kept rounded outward, and rounded
  /// inward. `near`: the pair can touch at no other times.
  Advancement(CertainSet<D, Degree>& certain, const PairLifetime& lifetime, const Interval<double>& near)
      : certain_(certain) {
    constexpr double u = unit_roundoff;
    const double begin = lifetime.dt_start, end = lifetime.dt_end;
    begin_ = std::max(lifetime.start_exact ? begin : begin * (1 - 2 * u), near.begin);
    inner_start_ = lifetime.start_exact ? begin : begin * (1 + 2 * u);
    end_ = lifetime.end_exact ? end : end * (1 + 2 * u);
    inner_end_ = lifetime.end_exact ? end : end * (1 - 2 * u);
    near_end_ = std::min(end_, near.end);
  }

  /// Whether the pair touches: searches any time of contact, not its start.
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

  /// Whether the pair touches. If yes, `first` brackets the start of the first contact.
  Verdict first_contact(Bracket& first) {
    if (begin_ > near_end_) return Verdict::no;
    const double stopped = leap([this](double tau) { return apart(tau); }, begin_, near_end_);
    if (stopped == unbounded) return Verdict::no;
    first = {stopped, stopped};
    const bool met = witness([this](double tau) { return certain_.now_within(tau); }, first, inner_start_);
    return met ? Verdict::yes : Verdict::uncertain;
  }

  /// Brackets the end of the contact that the pair certainly has at `from`. yes: it ends; no: it lasts until
  /// the end of the horizon.
  Verdict end_of_contact(double from, Bracket& last) {
    const auto within = [this](double tau) { return certain_.within(tau, room_from(tau, end_)); };
    const double stopped = leap(within, from, end_);
    if (stopped == unbounded) return Verdict::no;
    last = {stopped, stopped};
    const bool left = witness([this](double tau) { return certain_.now_apart(tau); }, last, stopped);
    return left ? Verdict::yes : Verdict::uncertain;
  }

 private:
  static double room_from(double tau, double end) { return (end - tau) * (1 + 4 * unit_roundoff); }
  /// CertainSet::apart(), up to near_end_.
  double apart(double tau) { return certain_.apart(tau, room_from(tau, near_end_)); }

  /// foresee::witness(), within the lifetime rounded inward.
  template <class Predicate>
  bool witness(Predicate&& predicate, Bracket& bracket, double earliest) const {
    return foresee::witness(predicate, bracket, earliest, inner_end_);
  }

  CertainSet<D, Degree>& certain_;
  double begin_, inner_start_, inner_end_, end_;
  double near_end_;  ///< the pair does not touch later
};

}  // namespace foresee
