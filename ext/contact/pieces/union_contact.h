// Contact of objects that are unions of pieces: implements Contact (contact.h) by the stages of a pair, in
// order.
//
//   return std::make_unique<UnionContact<FlatTraits<2, 1>>>(setup, tables);
//
// The filter in plain doubles comes first. Trees of boxes, pieces in doubles with error bounds and crossings
// in DoubleDouble follow (union_pair.h). Exact arithmetic decides the rest, from the pieces that may touch
// around a time. Between those times it decides, for solids, whether one object is inside the other
// (docs/explanation/exactness.md).
#pragma once

#include <algorithm>
#include <optional>

#include "base/float_environment.h"
#include "contact/closest_approach.h"
#include "contact/contact.h"
#include "contact/exact/exact_contact.h"
#include "contact/pieces/pair_context.h"
#include "contact/pieces/undecided_pieces.h"
#include "contact/pieces/union_pair.h"

namespace foresee {

/// `Traits`: see pair_context.h. This class also needs the type Tables, with the shapes of both tables'
/// rows, and take(), which reads the pieces of a pair. Further it needs filter_answer(), the filter in
/// plain doubles, and the parts of a pair for the exact stage (undecided_pieces.h).
template <class Traits>
class UnionContact final : public Contact {
 public:
  using Tables = typename Traits::Tables;

  UnionContact(const Setup& setup, const Tables& tables) : setup_(setup), tables_(tables) {}

  Reach reach() const override { return {setup_.rule.within(), setup_.rule.within_z()}; }
  void set_interrupt(Interrupt& interrupt) override { steps_.emplace(interrupt); }

  std::string effort() const override {
    return per_pair(pieces_) + " pieces, " + per_pair(steps_->taken()) + " node tests and " +
           per_pair(space_.tests) + " leaf tests a pair";
  }

  void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) override {
    const FloatEnvironment environment;
    for (const Pair& pair : pairs)
      if (touches(pair)) hits.push_back(pair);
  }

  void first_contacts(std::span<const Pair> pairs, TimesWanted wanted, std::vector<Pair>& hits,
                      std::vector<ContactTimes>& times) override {
    const FloatEnvironment environment;
    for (const Pair& pair : pairs) {
      const auto found = first_contact(pair, wanted);
      if (!found) continue;
      hits.push_back(pair);
      times.push_back(*found);
    }
  }

  void closest_approach(std::span<const Pair> hits, std::span<ClosestApproach> out) override {
    const FloatEnvironment environment;
    for (std::size_t i = 0; i < hits.size(); ++i)
      out[i] = closest_approach_of<Traits::axes>(setup_, setup_.a.row(hits[i].a), setup_.b.row(hits[i].b));
  }

 private:
  using Context = PairContext<Traits>;
  using Staged = UnionPair<Traits>;

  /// The rows of a pair of objects.
  struct Rows {
    const double *a, *b;
  };

  bool touches(const Pair& pair) {
    const Rows rows{setup_.a.row(pair.a), setup_.b.row(pair.b)};
    const PairLifetime lifetime = pair_lifetime_of(setup_, rows.a, rows.b);
    if (lifetime.none) return false;
    take_pieces(pair);
    const Context context(setup_, rows.a, rows.b, a_, b_, lifetime, *steps_);
    const FilterAnswer plain = filter_answer(context, false);
    if (plain.touches != Verdict::uncertain) return plain.touches == Verdict::yes;
    Staged staged(context, false, space_);
    const Verdict touches = staged.touches();
    if (touches != Verdict::uncertain) return touches == Verdict::yes;
    return exactly_touches(rows, staged);
  }

  std::optional<ContactTimes> first_contact(const Pair& pair, TimesWanted wanted) {
    const Rows rows{setup_.a.row(pair.a), setup_.b.row(pair.b)};
    const PairLifetime lifetime = pair_lifetime_of(setup_, rows.a, rows.b);
    if (lifetime.none) return {};
    take_pieces(pair);
    const Context context(setup_, rows.a, rows.b, a_, b_, lifetime, *steps_);
    const FilterAnswer plain = filter_answer(context, true);
    if (plain.touches == Verdict::no) return {};
    if (plain.all_along)
      return ContactTimes{lifetime.t_start, lifetime.t_end, lifetime.dt_start, lifetime.dt_end};
    if (plain.at_start && wanted != TimesWanted::both)
      return ContactTimes{lifetime.t_start, lifetime.t_start, lifetime.dt_start, lifetime.dt_start};
    Staged staged(context, true, space_);
    Instant begin;
    const Verdict touches = staged.first_contact(begin);
    if (touches == Verdict::no) return {};
    if (touches == Verdict::uncertain) {
      const auto exact = exact_contact(rows, staged, -UncertainInterval::inf, staged.contact_by());
      if (!exact || exact->dt_end < UncertainInterval::inf) return exact;
      begin = {exact->dt, exact->t};
    }
    if (wanted != TimesWanted::both) return ContactTimes{begin.t, begin.t, begin.dt, begin.dt};
    Instant end = staged.end_of_contact(touches == Verdict::uncertain);
    if (!end.known() && staged.last_certain_time() == -UncertainInterval::inf) {
      const auto exact = exact_contact(rows, staged, -UncertainInterval::inf, staged.contact_by());
      if (exact.value().dt_end < UncertainInterval::inf)
        return ContactTimes{begin.t, exact->t_end, begin.dt, exact->dt_end};
      end = staged.end_of_contact(true);
    }
    if (end.known()) return ContactTimes{begin.t, end.t, begin.dt, end.dt};
    const auto exact = exact_contact(rows, staged, staged.last_certain_time());
    return ContactTimes{begin.t, exact.value().t_end, begin.dt, exact.value().dt_end};
  }

  /// Not for windows: their bounded boxes may have the largest doubles as faces.
  FilterAnswer filter_answer(const Context& context, bool times_wanted) const {
    return setup_.window ? FilterAnswer{} : Traits::filter_answer(context, times_wanted);
  }

  void take_pieces(const Pair& pair) {
    Traits::take(a_, b_, setup_, tables_, pair);
    ++pairs_, pieces_ += a_.count() + b_.count();
  }

  /// To one decimal.
  std::string per_pair(std::uint64_t all) const {
    const std::uint64_t tenths = pairs_ == 0 ? 0 : (10 * all + pairs_ / 2) / pairs_;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
  }

  /// How many pairs of pieces the exact stage takes at a time: they fit into some megabytes.
  static std::size_t at_a_time(const Staged& staged) { return staged.is_grown() ? 32 : 256; }

  [[gnu::noinline]] bool exactly_touches(const Rows& rows, Staged& staged) {
    const ExactLifetime queried = exact_lifetime_of(setup_, rows.a, rows.b);
    std::vector<PiecePair> pairs;
    const auto any_touches = [&] {
      if (pairs.empty()) return false;
      Polynomials polynomials = polynomials_of(rows, staged, pairs);
      polynomials.set_interrupt(*steps_);
      return exact_touches(polynomials, queried);
    };
    bool touches = false;
    staged.possible_pairs({-UncertainInterval::inf, UncertainInterval::inf}, [&](const PiecePair& pair) {
      pairs.push_back(pair);
      if (pairs.size() < at_a_time(staged)) return true;
      touches = any_touches();
      pairs.clear();
      return !touches;
    });
    return touches || any_touches();
  }

  /// The first contact that ends at `from` or later, exactly. `from` is -infinity, before all contact, or
  /// a time within a contact or shortly before its end; its start is not computed then. If `contact_by` is
  /// finite, they touch at that time: the end of a contact that lasts until then is infinite.
  [[gnu::noinline]] std::optional<ContactTimes> exact_contact(const Rows& rows, Staged& staged, double from,
                                                              double contact_by = UncertainInterval::inf) {
    const ExactLifetime queried = exact_lifetime_of(setup_, rows.a, rows.b);
    std::optional<ContactTimes> found;  // empty, unless a contact lasts until `from`
    if (from == -UncertainInterval::inf)
      from = staged.first_possible(from);
    else
      found.emplace();
    double until = -UncertainInterval::inf,
           exact_until = until;  // the ends of what may touch from `from` on and of what is decided
    while (from < UncertainInterval::inf && !(queried.end < Dyadic(from))) {
      if (exact_until == until)
        until = contact_by < UncertainInterval::inf ? contact_by : staged.possible_until(from);
      exact_until = until;
      const auto times = exact_times_between(rows, staged, queried, from, exact_until);
      const bool is_all = exact_until == until;
      if (times) {
        if (!found) found = times;
        found->t_end = times->t_end, found->dt_end = times->dt_end;
        if (times->dt_end < UncertainInterval::inf || (contact_by < UncertainInterval::inf && is_all))
          return found;
      }
      from = is_all ? staged.first_possible(until) : exact_until;
      if (!is_all) continue;
      if (times && !is_inside_between(staged, queried, until, from)) return ended_at(*found, queried, until);
    }
    if (found) found->t_end = queried.rounded.t_end, found->dt_end = queried.rounded.dt_end;
    return found;
  }

  /// The first contact of the pieces that may touch in [from, until]. Its end is infinite if it lasts until
  /// `until` and the queried time goes on. If too many pieces are needed, `until` becomes earlier.
  std::optional<ContactTimes> exact_times_between(const Rows& rows, Staged& staged,
                                                  const ExactLifetime& queried, double from, double& until) {
    ExactLifetime lifetime = queried;
    start_at(lifetime, from);
    end_at(lifetime, until);
    std::vector<PiecePair> pairs;
    Interval<double> interval{from, until};
    std::size_t too_many = at_a_time(staged);
    staged.possible_pairs(interval, [&](const PiecePair& pair) {
      pairs.push_back(pair);
      if (pairs.size() < too_many) return true;
      interval.end = std::min(interval.end, keep_needed(rows, staged, lifetime, pairs, too_many / 2));
      end_at(lifetime, interval.end);
      too_many = std::max(too_many, 2 * pairs.size());  // more start within one ulp
      return true;
    });
    until = interval.end;
    Polynomials polynomials = polynomials_of(rows, staged, pairs);
    polynomials.set_interrupt(*steps_);
    if constexpr (Traits::has_solids)
      return exact_times_of_solids(polynomials, lifetime,
                                   [&staged](const Dyadic& time) { return staged.is_inside_at(time); });
    return exact_times(polynomials, lifetime);
  }

  /// Removes the pairs that do not matter until the time that it returns. At most `limit` pairs are kept,
  /// unless more start within one ulp.
  double keep_needed(const Rows& rows, const Staged& staged, const ExactLifetime& lifetime,
                     std::vector<PiecePair>& pairs, std::size_t limit) {
    Polynomials polynomials = polynomials_of(rows, staged, pairs);
    polynomials.set_interrupt(*steps_);
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
    lifetime.rounded.dt_end = lifetime.rounded.t_end = UncertainInterval::inf;
  }

  /// Whether one object is inside the other from `until` to `next`, when further pieces may touch.
  static bool is_inside_between(Staged& staged, const ExactLifetime& queried, double until, double next) {
    const Dyadic from(until),
        to = next < UncertainInterval::inf ? std::min(Dyadic(next), queried.end) : queried.end;
    return from < to && staged.is_inside_at(half_of(from + to));
  }

  static ContactTimes ended_at(ContactTimes found, const ExactLifetime& queried, double until) {
    found.dt_end = until, found.t_end = rounded(Dyadic(until) + queried.now);
    return found;
  }

  using Polynomials = PolynomialsOf<UndecidedPieces<Traits>>;
  Polynomials polynomials_of(const Rows& rows, const Staged& staged, std::span<const PiecePair> pairs) {
    return {setup_, rows.a, rows.b,
            UndecidedPieces<Traits>(setup_, rows.a, rows.b, a_, b_, pairs, staged.is_grown())};
  }

  const Setup setup_;
  const Tables tables_;
  typename Traits::Pieces a_, b_;
  typename Traits::Space space_;
  NeverInterrupt never_;
  std::optional<Steps> steps_{never_};
  std::uint64_t pairs_ = 0, pieces_ = 0;  ///< tested pairs of objects, and the number of their pieces
};

}  // namespace foresee
