// Contact of objects that are unions of pieces: implements Contact (contact.h) by the stages of a pair, in
// order, whatever the pieces are.
//
//   return std::make_unique<UnionContact<FlatTraits<2, 1>>>(setup, tables);
//
// There are three kinds of pieces: those of one contact set for all pairs (set/set_traits.h), convex polygons
// (outline/flat_traits.h) and triangles (mesh/mesh_contact.cpp). Filters come first: of many pairs at once, and
// of one pair in plain doubles. Doubles with error bounds follow, and crossings in DoubleDouble. Exact
// arithmetic decides the rest. docs/explanation/exactness.md describes the stages.
#pragma once

#include <algorithm>
#include <optional>

#include "base/float_environment.h"
#include "contact/certified/pair_context.h"
#include "contact/contact.h"
#include "numbers/crossed_root.h"

namespace foresee {

/// `Traits` has the number of `axes`, and `counts_work`, which is true if effort() reports it. Tables are the
/// shapes of both tables' rows, or the contact set. Filter is the filter of many pairs (EachPair). Pieces are those
/// of one object, which take() reads. Context is the input of a pair (PairContext), and filter_answer() the filter
/// in plain doubles. Staged has the stages in doubles (UnionPair), with memory in a Space. Exact is the exact
/// stage (ExactUnion).
template <class Traits>
class UnionContact : public Contact {
 public:
  using Tables = typename Traits::Tables;

  /// The setup's bodies must outlive this.
  UnionContact(const Setup& setup, Tables tables)
      : setup_(setup), tables_(std::move(tables)), filter_(setup_, tables_) {}

  void set_interrupt(Interrupt& interrupt) override { steps_.emplace(interrupt); }

  std::string effort() const override {
    if constexpr (Traits::counts_work)
      return per_pair(pieces_) + " pieces, " + per_pair(steps_->taken()) + " node tests and " +
             per_pair(space_.tests) + " leaf tests a pair";
    else
      return "";
  }

  void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) override {
    const FloatEnvironment environment;
    filter_.for_each(pairs, false, [&](const Pair& pair, const Interval<double>& near, bool surely) {
      if (surely || touches(pair, near)) hits.push_back(pair);
    });
  }

  void first_contacts(std::span<const Pair> pairs, TimesWanted wanted, std::vector<Pair>& hits,
                      std::vector<ContactTimes>& times) override {
    const FloatEnvironment environment;
    filter_.for_each(pairs, true, [&](const Pair& pair, const Interval<double>& near, bool at_start) {
      const auto found = first_contact(pair, near, wanted, at_start);
      if (!found) return;
      hits.push_back(pair);
      times.push_back(*found);
    });
  }

  /// Only for convex sets, whose traits say which relative paths are straight: these are inside once at most.
  void all_contacts(std::span<const Pair> pairs, std::vector<Pair>& hits,
                    std::vector<ContactTimes>& times) override {
    if constexpr (requires { &Traits::is_straight; }) {
      const FloatEnvironment environment;
      filter_.for_each(pairs, true, [&](const Pair& pair, const Interval<double>& near, bool) {
        const std::size_t before = times.size();
        append_contacts(pair, near, times);
        hits.insert(hits.end(), times.size() - before, pair);
      });
    } else {
      Contact::all_contacts(pairs, hits, times);
    }
  }

  void closest_approach(std::span<const Pair> hits, std::span<ClosestApproach> out) override {
    const FloatEnvironment environment;
    for (std::size_t i = 0; i < hits.size(); ++i)
      out[i] = closest_approach_of<Traits::axes>(setup_, setup_.a.row(hits[i].a), setup_.b.row(hits[i].b));
  }

 protected:
  /// Whether the pair touches, exactly. `near`: it can touch at no other times.
  [[gnu::noinline]] bool touches(const Pair& pair, const Interval<double>& near = any_time) {
    const Rows rows = rows_of(pair);
    const PairLifetime lifetime = pair_lifetime_of(setup_, rows.a, rows.b);
    if (lifetime.none) return false;
    take_pieces(pair);
    const Context context(setup_, rows.a, rows.b, a_, b_, lifetime, near, *steps_);
    const FilterAnswer plain = filter_answer(context, false);
    if (plain.touches != Verdict::uncertain) return plain.touches == Verdict::yes;
    Staged staged(context, false, space_);
    const Verdict touches = staged.touches();
    if (touches != Verdict::uncertain) return touches == Verdict::yes;
    return Exact(context, staged).touches();
  }

  /// Whether and when the pair touches: the exact times, each rounded once. `near`: as for touches(). `at_start`:
  /// they certainly touch when the queried time starts.
  [[gnu::noinline]] std::optional<ContactTimes> first_contact(const Pair& pair, const Interval<double>& near,
                                                              TimesWanted wanted, bool at_start = false) {
    const Rows rows = rows_of(pair);
    const PairLifetime lifetime = pair_lifetime_of(setup_, rows.a, rows.b);
    if (lifetime.none) return {};
    const ContactTimes at_once{lifetime.t_start, lifetime.t_start, lifetime.dt_start, lifetime.dt_start};
    if (at_start && wanted != TimesWanted::both) return at_once;
    take_pieces(pair);
    const Context context(setup_, rows.a, rows.b, a_, b_, lifetime, near, *steps_);
    const FilterAnswer plain = filter_answer(context, true);
    if (plain.touches == Verdict::no) return {};
    if (plain.all_along)
      return ContactTimes{lifetime.t_start, lifetime.t_end, lifetime.dt_start, lifetime.dt_end};
    if (plain.at_start && wanted != TimesWanted::both) return at_once;
    Staged staged(context, true, space_);
    Instant begin = unknown_instant();
    const Verdict touches = at_start ? start_at_once(staged, lifetime, begin) : staged.first_contact(begin);
    if (touches == Verdict::no) return {};
    if (touches == Verdict::uncertain) {
      const auto exact = Exact(context, staged).contact(-UncertainInterval::inf, staged.contact_by());
      if (!exact || exact->dt_end < UncertainInterval::inf)
        return exact;  // infinite: the end is not known yet
      begin = {exact->dt, exact->t};
    }
    if (wanted != TimesWanted::both) return ContactTimes{begin.t, begin.t, begin.dt, begin.dt};
    Instant end = staged.end_of_contact(touches == Verdict::uncertain);
    if (!end.known() && staged.last_certain_time() == -UncertainInterval::inf) {
      const auto exact = Exact(context, staged).contact(-UncertainInterval::inf, staged.contact_by());
      if (exact.value().dt_end < UncertainInterval::inf)
        return ContactTimes{begin.t, exact->t_end, begin.dt, exact->dt_end};
      end = staged.end_of_contact(true);
    }
    if (end.known()) return ContactTimes{begin.t, end.t, begin.dt, end.dt};
    const auto exact = Exact(context, staged).contact(staged.last_certain_time());
    return ContactTimes{begin.t, exact.value().t_end, begin.dt, exact.value().dt_end};
  }

  /// The end of the contact that the pair certainly has at `from`, or unknown.
  [[gnu::noinline]] Instant end_of_contact(const Pair& pair, double from) {
    const Rows rows = rows_of(pair);
    const PairLifetime lifetime = pair_lifetime_of(setup_, rows.a, rows.b);
    take_pieces(pair);
    const Context context(setup_, rows.a, rows.b, a_, b_, lifetime, any_time, *steps_);
    Staged staged(context, true, space_);
    staged.start_at(from);
    return staged.end_of_contact(true);
  }

  const Setup setup_;

 private:
  using Context = typename Traits::Context;
  using Staged = typename Traits::Staged;
  using Exact = typename Traits::Exact;

  /// The rows of a pair of objects.
  struct Rows {
    const double *a, *b;
  };
  Rows rows_of(const Pair& pair) const { return {setup_.a.row(pair.a), setup_.b.row(pair.b)}; }

  /// As Staged::first_contact(), of a pair that certainly touches when the queried time starts.
  static Verdict start_at_once(Staged& staged, const PairLifetime& lifetime, Instant& begin) {
    if constexpr (requires { staged.start_at(0.0); }) {
      staged.start_at(lifetime.dt_start);
      begin = {lifetime.dt_start, lifetime.t_start};
      return Verdict::yes;
    } else {
      return staged.first_contact(begin);
    }
  }

  /// Not for windows: their bounded boxes may have the largest doubles as faces.
  FilterAnswer filter_answer(const Context& context, bool times_wanted) const {
    return setup_.window ? FilterAnswer{} : Traits::filter_answer(context, times_wanted);
  }

  /// Appends every contact of the pair.
  void append_contacts(const Pair& pair, const Interval<double>& near, std::vector<ContactTimes>& times) {
    const Rows rows = rows_of(pair);
    if (Traits::is_straight(setup_, rows.a, rows.b)) {
      if (const auto one = first_contact(pair, near, TimesWanted::both)) times.push_back(*one);
    } else if (touches(pair, near)) {
      const PairLifetime lifetime = pair_lifetime_of(setup_, rows.a, rows.b);
      const Context context(setup_, rows.a, rows.b, a_, b_, lifetime, near, *steps_);
      const auto all = Exact(context, Staged(context, true, space_)).contacts();
      times.insert(times.end(), all.begin(), all.end());
    }
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

  const Tables tables_;
  typename Traits::Filter filter_;
  typename Traits::Pieces a_, b_;
  typename Traits::Space space_;
  NeverInterrupt never_;
  std::optional<Steps> steps_{never_};
  std::uint64_t pairs_ = 0, pieces_ = 0;  ///< tested pairs of objects, and the number of their pieces
};

}  // namespace foresee
