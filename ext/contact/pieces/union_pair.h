// When do two touch first that are unions of pieces, and until when? As far as doubles and DoubleDouble can
// vouch for it; where they cannot, on which pieces it hangs.
//
// Contact is the union of the stays of all pairs of pieces (pair_tests.h). It begins when the earliest stay
// does. Its end is found by going on: among the stays that begin before it, one that ends after it, until
// there is none. What is only possible counts for neither; what it could change is left to the exact stage.
//
// The pieces of a solid are its surface alone. Then contact is also what lies between two stays, before the
// first or after the last, if one of the two lies within the other there: nothing of that changes unless the
// surfaces touch, so it is asked at one moment.
#pragma once

#include "contact/pieces/endpoint_rounding.h"
#include "contact/pieces/pair_intervals.h"

namespace foresee {

template <class Traits>
class UnionPair : public PairIntervals<Traits> {
  using Base = PairIntervals<Traits>;
  using Base::context_, Base::containment_, Base::tests_;

 public:
  /// As that of PairIntervals.
  UnionPair(const PairContext<Traits>& context, bool times_wanted, typename Traits::Space& space)
      : Base(context, times_wanted, space),
        instants_(context.setup, context.row_a, context.row_b, context.relative, context.sizes,
                  context.lifetime, context.queried),
        seen_(space.seen) {}

  /// Is there a contact? Stops at the first that is certain. If it is uncertain, the pieces alone tell.
  Verdict touches() {
    if (Base::is_within_at_start()) return Verdict::yes;
    Verdict touches = Verdict::no;
    context_.walk.visit(
        Order::earlier_first, [&](const Interval<double>&) { return touches != Verdict::yes; },
        [&](std::size_t a, std::size_t b, const Interval<double>&) {
          for (const PieceInterval& interval : tests_.of(a, b))
            if (touches != Verdict::yes) touches = interval.is_certain() ? Verdict::yes : Verdict::uncertain;
        });
    return touches;
  }

  /// Is there a contact, and when does it begin? yes: `begin` is known.
  Verdict first_contact(Instant& begin) {
    starts_within_ = Base::is_within_at_start();
    if (starts_within_) {
      met_by_ = context_.queried.begin.high, begin = {context_.lifetime.dt_start, context_.lifetime.t_start};
      return Verdict::yes;
    }
    bool possible = false;
    context_.walk.visit(
        Order::earlier_first,
        [this](const Interval<double>& near) { return near.begin <= met_by_ && !starts_at_once(); },
        [&](std::size_t a, std::size_t b, const Interval<double>&) {
          if (tests_.is_full()) take_starts();
          for (const PieceInterval& interval : tests_.of(a, b, met_by_)) {
            possible = true;
            if (interval.is_certain()) met_by_ = std::min(met_by_, interval.begin.high);
          }
        });
    if (!possible) return Verdict::no;
    begin = earliest_start();
    return begin.known() ? Verdict::yes : Verdict::uncertain;
  }

  /// By then they certainly touch; infinite if that is not known. Requires: first_contact() was asked.
  double met_by() const { return met_by_; }

  /// Requires: the begin is known. `lasts_until_met_by`: that the contact does is known.
  Instant end_of_contact(bool lasts_until_met_by) {
    if (starts_within_)
      last_ = context_.queried.begin;
    else if (lasts_until_met_by || !Traits::has_solids)  // stays of what fills its shape last a while
      go_on_from_met_by();
    else if (!enter(-UncertainInterval::inf))
      return unknown_instant();
    do follow();
    while (!lasts_to_the_end() && (goes_through_a_cut() || goes_on_within()));
    return latest_end();
  }

  /// After that: the last moment that certainly belongs to this contact, or one shortly before its end,
  /// between which no other contact begins; -infinity where none is known.
  double last_certain_time() const { return last_.low; }

 private:
  /// They certainly touch when what is asked about begins.
  bool starts_at_once() const { return met_by_ <= context_.queried.begin.low; }

  /// Of the stays found so far that may be the first, when they begin.
  void take_starts() {
    for (const PieceInterval& interval : tests_.all()) {
      if (interval.begin.low > met_by_) continue;
      const Instant begin =
          interval.is_certain() ? instants_.begin(interval, tests_.ends(interval)) : unknown_instant();
      if (begin.known())
        earliest_ = earlier(earliest_, begin);
      else
        unknown_from_ = std::min(unknown_from_, interval.begin.low);
    }
  }

  Instant earliest_start() {
    if (starts_at_once()) return {context_.lifetime.dt_start, context_.lifetime.t_start};
    take_starts();
    return unknown_from_ <= met_by_ ? unknown_instant() : earliest_;
  }

  void go_on_from_met_by() {
    last_ = {met_by_, met_by_};
    for (const PieceInterval& interval : tests_.all())
      if (interval.is_certain() && interval.begin.high <= met_by_) reach(interval.end);
  }

  /// From the first of the stays that begin later than `after`, which contact may have lasted until, it lasts
  /// until last_. Whether that is told.
  bool enter(double after) {
    double met_by = UncertainInterval::inf;
    seen_.clear(), all_seen_ = last_is_instant_ = false;
    context_.walk.visit(
        Order::earlier_first,
        [&](const Interval<double>& near) { return near.end > after && near.begin <= met_by; },
        [&](std::size_t a, std::size_t b, const Interval<double>&) {
          for (const PieceInterval& interval : tests_.of(a, b)) {
            if (!(interval.begin.low > after)) continue;
            seen_.push_back(interval);
            if (interval.is_certain()) met_by = std::min(met_by, interval.begin.high);
          }
        });
    std::erase_if(seen_, [met_by](const PieceInterval& interval) { return interval.begin.low > met_by; });
    if (seen_.empty()) return false;
    const auto are_all = [this](auto&& what) { return std::all_of(seen_.begin(), seen_.end(), what); };
    if (!are_all([](const PieceInterval& interval) { return interval.is_certain(); })) return false;
    if (seen_.size() == 1) {
      last_ = seen_[0].end, last_is_instant_ = seen_[0].is_instant;
      return true;
    }
    if (!are_all([](const PieceInterval& interval) { return !interval.is_instant; })) return false;
    last_ = {met_by, met_by};  // whichever is first lasts until then
    return true;
  }

  /// One lies within the other when the stays so far have ended: contact lasts until the next.
  bool goes_on_within() {
    if constexpr (!Traits::has_solids) return false;
    if (!containment_.may_be()) return false;
    bool in_doubt = false;
    at_the_end([&](const PieceInterval& interval) { in_doubt |= may_continue_it(interval); });
    if (in_doubt) return false;
    all_seen_ = false;  // as others may be tested
    const double next = Base::first_possible(last_.high), until = std::min(next, context_.queried.end.low);
    const double between = last_.high + (until - last_.high) / 2;
    end_in_doubt_ = !(last_.high < between && between < until);
    if (end_in_doubt_ || !containment_.at(Dyadic(between))) return false;
    if (next == UncertainInterval::inf)
      return last_ = {context_.queried.end.high, context_.queried.end.high}, true;
    end_in_doubt_ = !enter(last_.high);
    if (end_in_doubt_) last_ = {between, between};
    return !end_in_doubt_;
  }

  void reach(const Enclosure& end) { last_ = {std::max(last_.low, end.low), std::max(last_.high, end.high)}; }

  /// Follows the contact along stays that surely begin before its end so far. Each walk looks for those that
  /// end last; the next is for what it passed by, as it begins later than the end was then.
  void follow() {
    double passed_by = UncertainInterval::inf,
           forgotten = UncertainInterval::inf;  // the earliest begins of nodes, and of stays
    do {
      passed_by = forgotten = UncertainInterval::inf;
      seen_.clear(), all_seen_ = true;
      const auto wanted = [this, &passed_by](const Interval<double>& near) {
        if (near.end < last_.low || lasts_to_the_end()) return false;
        if (near.begin > last_.high) passed_by = std::min(passed_by, near.begin);
        return near.begin <= last_.high;
      };
      context_.walk.visit(Order::later_first, wanted,
                          [this, &forgotten](std::size_t a, std::size_t b, const Interval<double>&) {
                            if (tests_.is_full()) forgotten = std::min(forgotten, forget_seen());
                            for (const PieceInterval& interval : tests_.of(a, b)) {
                              if (is_joined(interval)) reach(interval.end);
                              seen_.push_back(interval);
                            }
                          });
      join_seen();
    } while (passed_by <= last_.high || forgotten <= last_.low);
  }

  /// When the first begins of those that are not joined so far.
  double forget_seen() {
    double first = UncertainInterval::inf;
    for (const PieceInterval& interval : seen_)
      if (interval.is_certain() && !is_joined(interval)) first = std::min(first, interval.begin.high);
    seen_.clear(), all_seen_ = false;
    return first;
  }

  /// Those too that were seen before the contact reached them: in the order of their begins.
  void join_seen() {
    std::sort(seen_.begin(), seen_.end(), [](const UncertainInterval& a, const UncertainInterval& b) {
      return a.begin.high < b.begin.high;
    });
    for (const PieceInterval& interval : seen_) {
      if (interval.begin.high > last_.low) break;
      if (interval.is_certain()) reach(interval.end);
    }
  }

  bool lasts_to_the_end() const { return last_.low >= context_.queried.end.high; }

  bool is_joined(const PieceInterval& interval) const {
    if (interval.is_instant && last_is_instant_ && interval.end.low == last_.low &&
        interval.end.high == last_.high)
      return true;
    return interval.is_certain() && interval.begin.high <= last_.low;
  }
  bool may_end_it(const PieceInterval& interval) const {
    return is_joined(interval) && interval.end.high >= last_.low;
  }
  /// Whether it begins before the end is in doubt, or whether it is, and it would end after that.
  bool may_continue_it(const PieceInterval& interval) const {
    return !is_joined(interval) && interval.begin.low <= last_.high && interval.end.high > last_.low;
  }

  /// Gives `use` all stays that may end the contact or continue it. Requires: follow().
  template <class Use>
  void at_the_end(Use&& use) {
    if (all_seen_) return static_cast<void>(std::for_each(seen_.begin(), seen_.end(), use));
    context_.walk.visit(
        Order::later_first,
        [this](const Interval<double>& near) { return near.begin <= last_.high && near.end >= last_.low; },
        [this, &use](std::size_t a, std::size_t b, const Interval<double>&) {
          for (const PieceInterval& interval : tests_.of(a, b)) use(interval);
        });
  }

  /// What leaves a piece through a cut of its outline, and nowhere else, is in a neighbour: whoever begins
  /// then continues it, and no comparison is needed.
  bool goes_through_a_cut() {
    if constexpr (Traits::has_solids) return false;
    int ending = 0;
    bool at_a_cut = false;
    double latest_start = -UncertainInterval::inf, earliest_end = UncertainInterval::inf;
    Enclosure reached = last_;
    at_the_end([&](const PieceInterval& interval) {
      if (may_end_it(interval)) {
        ++ending, at_a_cut = ends_at_a_cut(interval);
      } else if (may_continue_it(interval)) {
        latest_start = std::max(latest_start, interval.begin.high);
        earliest_end = std::min(earliest_end, interval.end.low);
        reached = {std::max(reached.low, interval.end.low), std::max(reached.high, interval.end.high)};
      }
    });
    if (ending != 1 || !at_a_cut) return false;
    if (!(latest_start <= earliest_end && reached.low > last_.high)) return false;
    last_ = reached;
    return true;
  }

  bool ends_at_a_cut(const PieceInterval& interval) const {
    if (context_.queried.end.meets(interval.end)) return false;
    const EndpointCandidate<typename Traits::Condition>* only = nullptr;
    for (const auto& end : tests_.ends(interval)) {
      if (end.direction == CrossingDirection::entering) continue;
      if (only) return false;
      only = &end;
    }
    return only && Traits::is_cut(only->condition);
  }

  Instant latest_end() {
    if (lasts_to_the_end()) return {context_.lifetime.dt_end, context_.lifetime.t_end};
    if (end_in_doubt_) return unknown_instant();
    Instant latest{-UncertainInterval::inf, -UncertainInterval::inf};
    at_the_end([this, &latest](const PieceInterval& interval) {
      if (may_continue_it(interval)) latest = unknown_instant();
      if (latest.known() && may_end_it(interval))
        latest = later(latest, instants_.end(interval, tests_.ends(interval)));
    });
    return latest;
  }

  EndpointRounding<Traits> instants_;
  std::vector<PieceInterval>& seen_;  ///< by the last walk of follow()
  bool all_seen_ = false;             ///< and known still
  bool starts_within_ = false;        ///< one in the other
  bool end_in_doubt_ = false;
  bool last_is_instant_ = false;            ///< when the contact was entered again, alone
  double met_by_ = UncertainInterval::inf;  ///< by then they certainly touch
  Instant earliest_{UncertainInterval::inf, UncertainInterval::inf};  ///< of the begins that are known
  double unknown_from_ = UncertainInterval::inf;  ///< and since when one may be that is not
  Enclosure last_{-UncertainInterval::inf,
                  -UncertainInterval::inf};  ///< the end of the contact, as far as it was followed
};

}  // namespace foresee
