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

#include <concepts>
#include <optional>

#include "base/float_environment.h"
#include "contact/certified/pair_context.h"
#include "contact/contact.h"
#include "numbers/crossed_root.h"

namespace foresee {

/// What the pieces are, and the stages that decide a pair of objects. Two functions are optional. filter_answer() is
/// the filter of one pair in plain doubles; is_straight() says that a pair has one contact at most.
template <class Traits>
concept ContactTraits = std::same_as<decltype(Traits::axes), const int> &&  // of the objects
    std::same_as<decltype(Traits::counts_work), const bool> &&              // effort() reports the work
    requires(const Setup& setup, const typename Traits::Tables& tables, const Pair& pair,
             typename Traits::Pieces& pieces, typename Traits::Staged& staged,
             typename Traits::Exact& exact) {
  // The filter of many pairs (EachPair), from the shapes of both tables' rows or the contact set.
  requires std::constructible_from<typename Traits::Filter, decltype(setup), decltype(tables)>;
  // Reads the pieces of both objects.
  Traits::load(pieces, pieces, setup, tables, pair);
  // The input of all stages that follow (PairContext).
  requires std::constructible_from<typename Traits::Context, PairInput<typename Traits::Pieces>>;
  // The stages in doubles with error bounds (UnionPair), with memory in a Space.
  requires std::constructible_from<typename Traits::Staged, const typename Traits::Context&,
                                   typename Traits::Space&>;
  { staged.touches() } -> std::same_as<Verdict>;
  { staged.first_contact() } -> std::same_as<FirstContact>;
  { staged.end_of_contact() } -> std::same_as<Instant>;
  // The exact stage (ExactUnion). The end of the first contact may still be unknown.
  requires std::constructible_from<typename Traits::Exact, decltype(staged)>;
  { exact.touches() } -> std::same_as<bool>;
  { exact.first_contact() } -> std::same_as<FirstContact>;
  { exact.end_of_contact() } -> std::same_as<Instant>;
};

template <ContactTraits Traits>
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
    filter_.for_each(pairs, CertainContact::at_any_time,
                     [&](const Pair& pair, const Interval<double>& near, bool surely) {
                       if (surely || touches(pair, near)) hits.push_back(pair);
                     });
  }

  void first_contacts(std::span<const Pair> pairs, TimesWanted wanted, std::vector<Pair>& hits,
                      std::vector<ContactTimes>& times) override {
    const FloatEnvironment environment;
    filter_.for_each(pairs, CertainContact::at_start,
                     [&](const Pair& pair, const Interval<double>& near, bool at_start) {
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
      filter_.for_each(pairs, CertainContact::at_start,
                       [&](const Pair& pair, const Interval<double>& near, bool) {
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
      out[i] = closest_approach_of<Traits::axes>(setup_, row_a(hits[i]), row_b(hits[i]));
  }

 protected:
  /// Whether the pair touches, exactly. `near`: it can touch at no other times.
  [[gnu::noinline]] bool touches(const Pair& pair, const Interval<double>& near = any_time) {
    const PairLifetime lifetime = lifetime_of(pair);
    if (lifetime.none) return false;
    const Context context(load(pair, lifetime, near, false));
    const FilterAnswer plain = filter_answer(context);
    if (plain.touches != Verdict::uncertain) return plain.touches == Verdict::yes;
    Staged staged(context, space_);
    const Verdict touches = staged.touches();
    if (touches != Verdict::uncertain) return touches == Verdict::yes;
    return Exact(staged).touches();
  }

  /// Whether and when the pair touches: the exact times, each rounded once. `near`: as for touches(). `at_start`:
  /// they certainly touch when the queried time starts.
  [[gnu::noinline]] std::optional<ContactTimes> first_contact(const Pair& pair, const Interval<double>& near,
                                                              TimesWanted wanted, bool at_start = false) {
    const PairLifetime lifetime = lifetime_of(pair);
    if (lifetime.none) return {};
    const Instant start = lifetime.start();
    if (at_start && wanted != TimesWanted::both) return times_of(start, start);
    const Context context(load(pair, lifetime, near, true));
    const FilterAnswer plain = filter_answer(context);
    if (plain.touches == Verdict::no) return {};
    if (plain.all_along) return times_of(start, lifetime.end());
    if (plain.at_start && wanted != TimesWanted::both) return times_of(start, start);
    Staged staged(context, space_);
    FirstContact found = at_start ? contact_at_start(staged, start) : staged.first_contact();
    if (found.touches == Verdict::uncertain) found = Exact(staged).first_contact();
    if (found.touches == Verdict::no) return {};
    if (found.end.known()) return times_of(found.begin, found.end);
    if (wanted != TimesWanted::both) return times_of(found.begin, found.begin);
    const Instant end = staged.end_of_contact();
    return times_of(found.begin, end.known() ? end : Exact(staged).end_of_contact());
  }

  /// The end of the contact that the pair certainly has at `from`, or unknown. For contact sets alone.
  [[gnu::noinline]] Instant end_of_contact(const Pair& pair, double from) {
    const PairLifetime lifetime = lifetime_of(pair);
    const Context context(load(pair, lifetime, any_time, true));
    Staged staged(context, space_);
    staged.start_at(from);
    return staged.end_of_contact();
  }

  const double* row_a(const Pair& pair) const { return setup_.a.row(pair.a); }
  const double* row_b(const Pair& pair) const { return setup_.b.row(pair.b); }

  const Setup setup_;

 private:
  using Context = typename Traits::Context;
  using Staged = typename Traits::Staged;
  using Exact = typename Traits::Exact;

  PairLifetime lifetime_of(const Pair& pair) const {
    return pair_lifetime_of(setup_, row_a(pair), row_b(pair));
  }
  static ContactTimes times_of(const Instant& begin, const Instant& end) {
    return {begin.t, end.t, begin.dt, end.dt};
  }

  /// Reads the pieces of a pair into a_ and b_.
  PairInput<typename Traits::Pieces> load(const Pair& pair, const PairLifetime& lifetime,
                                          const Interval<double>& near, bool times_wanted) {
    Traits::load(a_, b_, setup_, tables_, pair);
    ++pairs_;
    pieces_ += a_.count() + b_.count();
    return {setup_, row_a(pair), row_b(pair), a_, b_, lifetime, near, times_wanted, *steps_};
  }

  /// Of outlines alone; else uncertain. Not for windows: their bounded boxes may have the largest doubles as
  /// faces.
  FilterAnswer filter_answer(const Context& context) const {
    if constexpr (requires { Traits::filter_answer(context); })
      if (!setup_.window) return Traits::filter_answer(context);
    return {};
  }

  /// The contact of a pair that certainly touches at `start`, when the queried time starts.
  static FirstContact contact_at_start(Staged& staged, const Instant& start) {
    if constexpr (requires { staged.start_at(start.dt); }) {
      staged.start_at(start.dt);
      return {Verdict::yes, start};
    } else {
      return staged.first_contact();
    }
  }

  /// Appends every contact of the pair.
  void append_contacts(const Pair& pair, const Interval<double>& near, std::vector<ContactTimes>& times) {
    if (Traits::is_straight(setup_, row_a(pair), row_b(pair))) {
      if (const auto one = first_contact(pair, near, TimesWanted::both)) times.push_back(*one);
    } else if (touches(pair, near)) {
      const PairLifetime lifetime = lifetime_of(pair);
      const Context context(load(pair, lifetime, near, true));
      Staged staged(context, space_);
      const auto all = Exact(staged).contacts();
      times.insert(times.end(), all.begin(), all.end());
    }
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
