// Contact of pairs by one contact set for all of them (contact_set.h), in stages of increasing cost.
//
// First the lanes (set_lanes.h) discard most pairs, several at a time. The others are decided one by one:
// doubles with error bounds, DoubleDouble for the times, and exact numbers for pairs that these leave
// undecided.
#pragma once

#include "base/float_environment.h"
#include "contact/certain/crossing.h"
#include "contact/certain/set_lanes.h"
#include "contact/closest_approach.h"
#include "contact/exact/exact_contact.h"

namespace foresee {

/// D: the number of axes. Degree: 1 or 2, the highest power of time in the relative motion and in the sizes
/// of the set.
template <int D, int Degree>
class SetContact : public Contact {
 public:
  /// The setup's bodies must outlive the contact.
  SetContact(const Setup& setup, ContactSet set)
      : setup_(setup),
        set_(std::move(set)),
        certain_scratch_(set_),
        crossing_scratch_(set_),
        space_(lanes_space(set_)),
        question_{.a = setup.a.at,
                  .b = setup.b.at,
                  .now = setup.horizon.now,
                  .h = setup.horizon.h,
                  .set = set_.arrays(),
                  .lengths = certain_scratch_.lengths.data(),
                  .touches_wanted = false,
                  .space = reinterpret_cast<double*>(space_.data())} {}

  Reach reach() const override { return {setup_.rule.within(), setup_.rule.within_z()}; }

  void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) override {
    const FloatEnvironment environment;
    in_set_lanes(pairs, true, [&](const Pair& pair, int l) {
      if (set_lanes_.touches[l] > 0 || touches(set_lanes_.a[l], set_lanes_.b[l], near(l)))
        hits.push_back(pair);
    });
  }

  void first_contacts(std::span<const Pair> pairs, TimesWanted wanted, std::vector<Pair>& hits,
                      std::vector<ContactTimes>& times) override {
    const FloatEnvironment environment;
    ContactTimes found;
    in_set_lanes(pairs, false, [&](const Pair& pair, int l) {
      if (!first_contact(set_lanes_.a[l], set_lanes_.b[l], near(l), wanted, found)) return;
      hits.push_back(pair);
      times.push_back(found);
    });
  }

  void closest_approach(std::span<const Pair> hits, std::span<ClosestApproach> out) override {
    const FloatEnvironment environment;
    for (std::size_t i = 0; i < hits.size(); ++i)
      out[i] = closest_approach_of<D>(setup_, setup_.a.row(hits[i].a), setup_.b.row(hits[i].b));
  }

 protected:
  /// Prefetches the rows of a later pair: neighbours in space are seldom neighbours in memory, and memory
  /// latency would be a quarter of the cost of a decision.
  void fetch_ahead(std::span<const Pair> pairs, std::size_t i) const {
    constexpr std::size_t ahead = 16, doubles_per_line = 8;
    if (i + ahead >= pairs.size()) return;
    const double* row_a = setup_.a.row(pairs[i + ahead].a);
    const double* row_b = setup_.b.row(pairs[i + ahead].b);
    __builtin_prefetch(row_a);
    __builtin_prefetch(row_a + doubles_per_line);
    __builtin_prefetch(row_b);
    __builtin_prefetch(row_b + doubles_per_line);
  }

  /// Whether the pair touches, exactly. `near`: it can touch at no other times.
  [[gnu::noinline]] bool touches(const double* row_a, const double* row_b,
                                 const Interval<double>& near = any_time) {
    const PairLifetime lifetime = pair_lifetime_of(setup_, row_a, row_b);
    if (lifetime.none) return false;
    const Verdict verdict = advancement(row_a, row_b, lifetime, near).touches();
    if (verdict != Verdict::uncertain) return verdict == Verdict::yes;
    return exactly<bool>(row_a, row_b, exact_touches);
  }

  /// Whether and when the pair touches: the exact times, each rounded once. `near`: as for touches().
  [[gnu::noinline]] bool first_contact(const double* row_a, const double* row_b, const Interval<double>& near,
                                       TimesWanted wanted, ContactTimes& found) {
    const PairLifetime lifetime = pair_lifetime_of(setup_, row_a, row_b);
    if (lifetime.none) return false;
    Instant begin = unknown_instant(), end = unknown_instant();
    const Verdict touches = filtered_contact(row_a, row_b, lifetime, near, wanted, begin, end);
    if (touches == Verdict::no) return false;
    found = {begin.t, end.t, begin.dt, end.dt};
    if (touches == Verdict::yes && begin.known() && end.known()) return true;
    const auto exact = exactly<std::optional<ContactTimes>>(row_a, row_b, exact_times);
    if (exact) found = *exact;
    return exact.has_value();
  }

  /// The end of the contact that the pair certainly has at `from`, or unknown.
  [[gnu::noinline]] Instant end_of_contact(const double* row_a, const double* row_b, double from) {
    const PairLifetime lifetime = pair_lifetime_of(setup_, row_a, row_b);
    auto advancement = this->advancement(row_a, row_b, lifetime, any_time);
    return end_of_contact(advancement, from, lifetime, row_a, row_b);
  }

  /// The same, with an Advancement of the pair.
  Instant end_of_contact(Advancement<D, Degree>& advancement, double from, const PairLifetime& lifetime,
                         const double* row_a, const double* row_b) {
    Bracket last;
    const Verdict leaves = advancement.end_of_contact(from, last);
    if (leaves == Verdict::uncertain) return unknown_instant();
    const Instant end{lifetime.dt_end, lifetime.t_end};
    return leaves == Verdict::no
               ? end
               : earlier(crossing<CrossingDirection::leaving>(advancement, last, row_a, row_b), end);
  }

  static constexpr Interval<double> any_time{0, unbounded};
  const Setup setup_;

 private:
  Advancement<D, Degree> advancement(const double* row_a, const double* row_b, const PairLifetime& lifetime,
                                     const Interval<double>& near) {
    return {set_, setup_, row_a, row_b, lifetime, near, certain_scratch_};
  }

  Interval<double> near(int l) const { return {set_lanes_.begin[l], set_lanes_.end[l]}; }

  /// Visits the pairs that are not certainly apart, in order, each with its lane l. near(l) is when the pair
  /// can touch. If touches_wanted, set_lanes_.touches[l] says whether it certainly touches.
  template <class Visit>
  void in_set_lanes(std::span<const Pair> pairs, bool touches_wanted, Visit&& visit) {
    constexpr std::size_t width = SetLanes::width;
    question_.touches_wanted = touches_wanted;
    for (std::size_t begin = 0; begin < pairs.size(); begin += width) {
      const auto some = pairs.subspan(begin, std::min(width, pairs.size() - begin));
      for (std::size_t l = 0; l < width; ++l) {
        fetch_ahead(pairs, begin + l);
        const Pair& pair = some[std::min(l, some.size() - 1)];  // lanes without a pair repeat the last one
        set_lanes_.a[l] = setup_.a.row(pair.a), set_lanes_.b[l] = setup_.b.row(pair.b);
      }
      set_kernel_.classify(question_, set_lanes_);
      for (std::size_t l = 0; l < some.size(); ++l)
        if (!(set_lanes_.begin[l] > set_lanes_.end[l])) visit(some[l], static_cast<int>(l));
    }
  }

  /// The answer of double and DoubleDouble: whether the two touch and, where known, from when until when.
  Verdict filtered_contact(const double* row_a, const double* row_b, const PairLifetime& lifetime,
                           const Interval<double>& near, TimesWanted wanted, Instant& begin, Instant& end) {
    auto advancement = this->advancement(row_a, row_b, lifetime, near);
    Bracket first;
    const Verdict meets = advancement.first_contact(first);
    if (meets != Verdict::yes) return meets;
    begin = {lifetime.dt_start, lifetime.t_start};
    if (first.after > lifetime.dt_start)
      begin = later(crossing<CrossingDirection::entering>(advancement, first, row_a, row_b), begin);
    end = wanted == TimesWanted::both ? end_of_contact(advancement, first.after, lifetime, row_a, row_b)
                                      : begin;
    return meets;
  }

  /// The time in the bracket at which the pair enters or leaves the set, rounded once, or unknown.
  template <CrossingDirection direction>
  Instant crossing(Advancement<D, Degree>& advancement, const Bracket& bracket, const double* row_a,
                   const double* row_b) {
    const auto relative = relative_motion_of<DoubleDouble, D>(setup_, row_a, row_b);
    return Crossing<direction, D, Degree>(advancement.certain(), relative, {set_, row_a, row_b}, bracket,
                                          setup_.horizon.now, crossing_scratch_)
        .instant();
  }

  /// The answer of the exact stage, which always has one.
  template <class Answer>
  [[gnu::noinline]] Answer exactly(const double* row_a, const double* row_b,
                                   Answer (*decide)(PiecePolynomials&, const ExactLifetime&)) const {
    PairPolynomials polynomials(set_, setup_, row_a, row_b);
    return decide(polynomials, exact_lifetime_of(setup_, row_a, row_b));
  }

  const ContactSet set_;
  CertainScratch certain_scratch_;
  CrossingScratch crossing_scratch_;
  std::vector<LanesLine> space_;
  LanesQuestion question_;
  SetLanes set_lanes_;
  const SetKernel<D, Degree>& set_kernel_ = set_kernel<D, Degree>();
};

extern template class SetContact<1, 1>;
extern template class SetContact<1, 2>;
extern template class SetContact<2, 1>;
extern template class SetContact<2, 2>;
extern template class SetContact<3, 1>;
extern template class SetContact<3, 2>;

}  // namespace foresee
