// The exact stage of two unions of pieces: exact numbers decide what doubles leave undecided, from the pieces
// that may touch around a time.
//
//   ExactUnion<FlatTraits<2, 1>> exact(pair);
//   exact.touches();                                       // or first_contact(), with its times
//
// Pieces are taken some at a time, and those that do not matter are dropped. So the memory for a pair of objects
// is bounded, whatever its number of pieces.
#pragma once

#include <algorithm>
#include <optional>

#include "contact/certified/possible_intervals.h"
#include "contact/certified/union_pair.h"
#include "contact/exact/exact_contact.h"

namespace foresee {

/// The constraints of the pairs of pieces that doubles leave undecided. The parts of the Minkowski sum of each pair are
/// pieces of the union, in the order of the pairs. `Traits`: what the pieces are (pair_context.h). Its function
/// add_pair() adds the parts of one pair, after `shared`, the numbers of the constraints of shared_constraints(), which
/// all of them have.
template <class Traits>
class UndecidedPieces : public ConstraintUnion {
 public:
  using PieceConstraint = typename Traits::PieceConstraint;

  /// `grown`: the contact distance of these objects is more than 0. Rows, pieces and setup must outlive this.
  UndecidedPieces(const Setup& setup, const double* row_a, const double* row_b,
                  const typename Traits::Pieces& a, const typename Traits::Pieces& b,
                  std::span<const PiecePair> pairs, bool grown)
      : setup_(setup), row_a_(row_a), row_b_(row_b), a_(a) {
    std::vector<int> shared;
    for (const PieceConstraint& constraint : Traits::shared_constraints(setup))
      shared.push_back(add(constraint));
    for (const PiecePair& pair : pairs) {
      Traits::add_pair(*this, a.piece(pair.a), b.piece(pair.b), grown, shared);
      ends_.push_back(static_cast<std::uint32_t>(pieces().size()));
    }
  }

  /// Its number.
  int add(const PieceConstraint& constraint) {
    constraints_.push_back(constraint);
    return static_cast<int>(constraints_.size()) - 1;
  }

  const ConstraintUnion& set() const { return *this; }
  /// For each pair, the number of pieces up to and with it.
  std::span<const std::uint32_t> ends() const { return ends_; }
  std::size_t constraint_count() const { return constraints_.size(); }

  /// The polynomial of a constraint, padded with zeros. `x`: the relative motion from now on.
  template <class T>
  Coefficients<T, 4> polynomial(int constraint, const std::array<Coefficients<T, 2>, 3>& x) const {
    Coefficients<T, 4> all{};
    with_polynomial<2>(constraints_[static_cast<std::size_t>(constraint)], x,
                       Traits::template sizes_of<T>(setup_, row_a_, row_b_, a_),
                       [&all](const auto& p) { std::copy(p.begin(), p.end(), all.begin()); });
    return all;
  }

  /// Equal constraints are not searched for.
  static constexpr bool is_compared(int) { return false; }
  static constexpr bool are_equal(int, int) { return false; }

 private:
  const Setup& setup_;
  const double *row_a_, *row_b_;
  const typename Traits::Pieces& a_;
  std::vector<PieceConstraint> constraints_;
  std::vector<std::uint32_t> ends_;
};

/// `Traits`: what the pieces are (pair_context.h).
template <class Traits>
class ExactUnion {
 public:
  /// `pair` must outlive this.
  explicit ExactUnion(UnionPair<Traits>& pair)
      : context_(pair.context()),
        pair_(pair),
        queried_(exact_lifetime_of(context_.setup, context_.row_a, context_.row_b)) {}

  /// Whether they touch.
  [[gnu::noinline]] bool touches() {
    std::vector<PiecePair> pairs;
    const auto any_touches = [&] {
      if (pairs.empty()) return false;
      Polynomials polynomials = polynomials_of(pairs);
      return exact_touches(polynomials, queried_);
    };
    bool touches = false;
    pair_.possible_pairs({-unbounded, unbounded}, [&](const PiecePair& pair) {
      pairs.push_back(pair);
      if (pairs.size() < at_a_time()) return true;
      touches = any_touches();
      pairs.clear();
      return !touches;
    });
    return touches || any_touches();
  }

  /// The first contact. If it lasts until the pair's contact_by(), then its end is unknown.
  FirstContact first_contact() {
    const auto times = contact(-unbounded, pair_.contact_by());
    if (!times) return {};
    const Instant begin{times->dt, times->t};
    if (times->dt_end < unbounded) return {Verdict::yes, begin, {times->dt_end, times->t_end}};
    pair_.set_lasts_until_contact_by();
    return {Verdict::yes, begin};
  }

  /// The end of the first contact, which the pair's end_of_contact() has left unknown.
  Instant end_of_contact() {
    if (!pair_.last_certain_time()) {
      const FirstContact first = first_contact();
      const Instant end = first.end.known() ? first.end : pair_.end_of_contact();
      if (end.known()) return end;
    }
    const auto times = contact(pair_.last_certain_time().value());
    return {times.value().dt_end, times.value().t_end};
  }

 private:
  /// The first contact that ends at `from` or later, exactly. `from` is -infinity, before all contact, or
  /// a time within a contact or shortly before its end; its start is not computed then. If `contact_by` is
  /// finite, they touch at that time: the end of a contact that lasts until then is infinite.
  [[gnu::noinline]] std::optional<ContactTimes> contact(double from, double contact_by = unbounded) {
    std::optional<ContactTimes> found;  // empty, unless a contact lasts until `from`
    if (from == -unbounded)
      from = pair_.first_possible(from);
    else
      found.emplace();
    // `until`: the end of the pieces that may touch from `from` on; `exact_until`: how far exact numbers have decided.
    double until = -unbounded, exact_until = until;
    while (from < unbounded && !(queried_.end < Dyadic(from))) {
      if (exact_until == until) until = contact_by < unbounded ? contact_by : pair_.possible_until(from);
      exact_until = until;
      const auto times = times_between(from, exact_until);
      const bool is_all = exact_until == until;
      if (times) {
        if (!found) found = times;
        found->t_end = times->t_end, found->dt_end = times->dt_end;
        if (times->dt_end < unbounded || (contact_by < unbounded && is_all)) return found;
      }
      from = is_all ? pair_.first_possible(until) : exact_until;
      if (!is_all) continue;
      if (times && !is_inside_between(until, from)) return ended_at(*found, until);
    }
    if (found) found->t_end = queried_.rounded.t_end, found->dt_end = queried_.rounded.dt_end;
    return found;
  }

  /// How many pairs of pieces the exact stage takes at a time: they fit into some megabytes.
  std::size_t at_a_time() const { return pair_.is_grown() ? 32 : 256; }

  /// The first contact of the pieces that may touch in [from, until]. Its end is infinite if it lasts until
  /// `until` and the queried time goes on. If too many pieces are needed, `until` becomes earlier.
  std::optional<ContactTimes> times_between(double from, double& until) {
    ExactLifetime lifetime = queried_;
    start_at(lifetime, from);
    end_at(lifetime, until);
    std::vector<PiecePair> pairs;
    Interval<double> interval{from, until};
    std::size_t too_many = at_a_time();
    pair_.possible_pairs(interval, [&](const PiecePair& pair) {
      pairs.push_back(pair);
      if (pairs.size() < too_many) return true;
      interval.end = std::min(interval.end, keep_needed(lifetime, pairs, too_many / 2));
      end_at(lifetime, interval.end);
      too_many = std::max(too_many, 2 * pairs.size());  // more start within one ulp
      return true;
    });
    until = interval.end;
    Polynomials polynomials = polynomials_of(pairs);
    if constexpr (Traits::has_solids)
      return exact_times(polynomials, lifetime,
                         [this](const Dyadic& time) { return pair_.is_inside_at(time); });
    return exact_times(polynomials, lifetime);
  }

  /// Removes the pairs that do not matter until the time that it returns. At most `limit` pairs are kept,
  /// unless more start within one ulp.
  double keep_needed(const ExactLifetime& lifetime, std::vector<PiecePair>& pairs, std::size_t limit) {
    Polynomials polynomials = polynomials_of(pairs);
    const NeededPieces needed = needed_pieces(polynomials, lifetime, limit);
    const std::span<const std::uint32_t> ends = polynomials.constraints().ends();
    std::size_t kept = 0;
    for (std::size_t i = 0, piece = 0; i < pairs.size(); ++i) {
      const std::size_t before = piece;
      while (piece < needed.pieces.size() && needed.pieces[piece] < ends[i]) ++piece;
      if (piece > before) pairs[kept++] = pairs[i];
    }
    pairs.resize(kept);
    return needed.until;
  }

  /// Cuts the lifetime at `from`: these pieces may touch before too, but other pieces decide that time.
  static void start_at(ExactLifetime& lifetime, double from) {
    const Dyadic begin(from);
    if (!(lifetime.begin < begin)) return;
    lifetime.begin = begin;
    lifetime.rounded.dt_start = from, lifetime.rounded.t_start = rounded(begin + lifetime.now);
  }
  static void end_at(ExactLifetime& lifetime, double until) {
    const Dyadic end(until);
    if (!(end < lifetime.end)) return;
    lifetime.end = end;
    lifetime.rounded.dt_end = lifetime.rounded.t_end = unbounded;
  }

  /// Whether one object is inside the other from `until` to `next`, when further pieces may touch.
  bool is_inside_between(double until, double next) {
    const Dyadic from(until), to = next < unbounded ? std::min(Dyadic(next), queried_.end) : queried_.end;
    return from < to && pair_.is_inside_at(half_of(from + to));
  }

  ContactTimes ended_at(ContactTimes found, double until) const {
    found.dt_end = until, found.t_end = rounded(Dyadic(until) + queried_.now);
    return found;
  }

  using Polynomials = PolynomialsOf<UndecidedPieces<Traits>>;
  Polynomials polynomials_of(std::span<const PiecePair> pairs) const {
    return {context_.setup, context_.row_a, context_.row_b,
            UndecidedPieces<Traits>(context_.setup, context_.row_a, context_.row_b, context_.a, context_.b,
                                    pairs, pair_.is_grown()),
            &context_.steps};
  }

  const PairContext<Traits>& context_;
  UnionPair<Traits>& pair_;
  const ExactLifetime queried_;
};

}  // namespace foresee
