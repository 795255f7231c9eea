// First contact of two unions of pieces, as far as doubles and DoubleDouble certify it.
//
// Contact is the union of the uncertain intervals of all pairs of pieces (pair_tests.h). It starts with the
// earliest interval. Its end is found step by step: an interval that starts before the end so far and ends
// later moves the end, until no such interval is left. Intervals that are only possible do not count; if they
// could change the result, the exact stage decides.
//
// The pieces of a solid are its surface alone. If one object is inside the other, contact also includes the
// time between two intervals, before the first or after the last. That cannot change while the surfaces do
// not touch, so it is tested at one instant of each such gap (Containment).
#pragma once

#include <optional>

#include "contact/certified/endpoint_rounding.h"
#include "contact/certified/possible_intervals.h"

namespace foresee {

/// `Traits`: what the pieces are (pair_context.h).
template <class Traits>
class UnionPair : public PairIntervals<Traits> {
  using Base = PairIntervals<Traits>;
  using Base::context_, Base::containment_, Base::tests_;

 public:
  /// See PairIntervals.
  UnionPair(const PairContext<Traits>& context, typename Traits::Space& space)
      : Base(context, space), instants_(context), seen_(space.seen) {}

  /// Whether they touch. Stops at the first certain interval. After `uncertain`, the exact stage needs the
  /// pieces only: no object is inside the other at the start.
  Verdict touches() {
    if (Base::is_inside_at_start()) return Verdict::yes;
    Verdict touches = Verdict::no;
    Base::for_each_interval(
        Order::earlier_first, [&](const Interval<double>&) { return touches != Verdict::yes; },
        [&](const PieceInterval& interval, const Interval<double>&) {
          if (touches != Verdict::yes) touches = interval.is_certain() ? Verdict::yes : Verdict::uncertain;
        });
    return touches;
  }

  /// Whether they touch, and when contact starts. Its end is not searched.
  FirstContact first_contact() {
    starts_inside_ = Base::is_inside_at_start();
    if (starts_inside_) {
      contact_by_ = context_.queried.begin.high;
      return {Verdict::yes, context_.lifetime.start()};
    }
    bool possible = false;
    context_.walk.visit(
        Order::earlier_first,
        [this](const Interval<double>& near) { return near.begin <= contact_by_ && !touches_at_start(); },
        [&](std::size_t a, std::size_t b, const Interval<double>&) {
          if (tests_.is_full()) read_starts();
          for (const PieceInterval& interval : tests_.of(a, b, contact_by_)) {
            possible = true;
            if (interval.is_certain()) contact_by_ = std::min(contact_by_, interval.begin.high);
          }
        });
    if (!possible) return {};
    if (touches_at_start()) return {Verdict::yes, context_.lifetime.start()};
    read_starts();
    if (unknown_from_ <= contact_by_) return {Verdict::uncertain};
    return {Verdict::yes, earliest_};
  }

  /// A time by which contact has certainly started; infinite if unknown. Call first_contact() before.
  double contact_by() const { return contact_by_; }

  /// The exact stage has found that the first contact lasts until contact_by().
  void set_lasts_until_contact_by() { lasts_until_contact_by_ = true; }

  /// When the first contact ends, or unknown. Requires: its start is known.
  Instant end_of_contact() {
    if (starts_inside_)
      last_ = context_.queried.begin;
    else if (lasts_until_contact_by_ || !Traits::has_solids)  // areas touch for some time
      continue_from_contact_by();
    else if (!enter(-unbounded))
      return unknown_instant();
    do follow();
    while (!lasts_to_the_end() && (continues_across_a_cut() || continues_inside()));
    return latest_end();
  }

  /// After end_of_contact(): the last time that certainly belongs to this contact, or a time shortly
  /// before its end, with no other contact in between. No value: none is known.
  std::optional<double> last_certain_time() const {
    return last_.low > -unbounded ? std::optional(last_.low) : std::nullopt;
  }

 private:
  /// They certainly touch when the queried time starts.
  bool touches_at_start() const { return contact_by_ <= context_.queried.begin.low; }

  /// Reads the starts of all intervals found so far that may be the first.
  void read_starts() {
    for (const PieceInterval& interval : tests_.all()) {
      if (interval.begin.low > contact_by_) continue;
      const Instant begin =
          interval.is_certain() ? instants_.begin(interval, tests_.ends(interval)) : unknown_instant();
      if (begin.known())
        earliest_ = earlier(earliest_, begin);
      else
        unknown_from_ = std::min(unknown_from_, interval.begin.low);
    }
  }

  void continue_from_contact_by() {
    last_ = {contact_by_, contact_by_};
    for (const PieceInterval& interval : tests_.all())
      if (interval.is_certain() && interval.begin.high <= contact_by_) reach(interval.end);
  }

  /// Enters the first of the intervals that start later than `after`: contact then lasts until last_.
  /// False if the first interval is uncertain.
  bool enter(double after) {
    double contact_by = unbounded;
    seen_.clear();
    all_seen_ = last_is_instant_ = false;
    Base::for_each_interval(
        Order::earlier_first,
        [&](const Interval<double>& near) { return near.end > after && near.begin <= contact_by; },
        [&](const PieceInterval& interval, const Interval<double>&) {
          if (!(interval.begin.low > after)) return;
          seen_.push_back(interval);
          if (interval.is_certain()) contact_by = std::min(contact_by, interval.begin.high);
        });
    std::erase_if(seen_,
                  [contact_by](const PieceInterval& interval) { return interval.begin.low > contact_by; });
    if (seen_.empty()) return false;
    const auto are_all = [this](auto&& what) { return std::all_of(seen_.begin(), seen_.end(), what); };
    if (!are_all([](const PieceInterval& interval) { return interval.is_certain(); })) return false;
    if (seen_.size() == 1) {
      last_ = seen_[0].end;
      last_is_instant_ = seen_[0].is_instant;
      return true;
    }
    if (!are_all([](const PieceInterval& interval) { return !interval.is_instant; })) return false;
    last_ = {contact_by, contact_by};  // the first of them lasts until then
    return true;
  }

  /// If one object is inside the other when the intervals so far have ended, contact lasts until the next.
  bool continues_inside() {
    if constexpr (!Traits::has_solids) return false;
    if (!containment_.may_be()) return false;
    bool in_doubt = false;
    at_the_end([&](const PieceInterval& interval) { in_doubt |= may_continue_it(interval); });
    if (in_doubt) return false;
    all_seen_ = false;  // the walk may test other pairs
    const double next = Base::first_possible(last_.high), until = std::min(next, context_.queried.end.low);
    const double between = last_.high + (until - last_.high) / 2;
    end_in_doubt_ = !(last_.high < between && between < until);
    if (end_in_doubt_ || !containment_.at(Dyadic(between))) return false;
    if (next == unbounded) {
      last_ = {context_.queried.end.high, context_.queried.end.high};
      return true;
    }
    end_in_doubt_ = !enter(last_.high);
    if (end_in_doubt_) last_ = {between, between};
    return !end_in_doubt_;
  }

  void reach(const Enclosure& end) { last_ = {std::max(last_.low, end.low), std::max(last_.high, end.high)}; }

  /// Extends the contact by intervals that surely start before its end so far. Each walk visits those that
  /// end last first. A further walk follows for nodes that were skipped, as they start after the end so far.
  void follow() {
    double passed_by, forgotten;  // the earliest start of nodes, of intervals
    do {
      passed_by = forgotten = unbounded;
      seen_.clear();
      all_seen_ = true;
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

  /// Discards the intervals seen. Returns the earliest start of those that are not part of the contact.
  double forget_seen() {
    double first = unbounded;
    for (const PieceInterval& interval : seen_)
      if (interval.is_certain() && !is_joined(interval)) first = std::min(first, interval.begin.high);
    seen_.clear();
    all_seen_ = false;
    return first;
  }

  /// Joins the intervals that were seen before the contact reached them, in the order of their starts.
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
    if (interval.is_instant && last_is_instant_ && interval.end == last_) return true;
    return interval.is_certain() && interval.begin.high <= last_.low;
  }
  bool may_end_it(const PieceInterval& interval) const {
    return is_joined(interval) && interval.end.high >= last_.low;
  }
  /// Whether it may start before the end of the contact, and would end later.
  bool may_continue_it(const PieceInterval& interval) const {
    return !is_joined(interval) && interval.begin.low <= last_.high && interval.end.high > last_.low;
  }

  /// Calls `use` for all intervals that may end the contact or continue it. Requires: follow().
  template <class Use>
  void at_the_end(Use&& use) {
    if (all_seen_) return static_cast<void>(std::for_each(seen_.begin(), seen_.end(), use));
    Base::for_each_interval(
        Order::later_first,
        [this](const Interval<double>& near) { return near.begin <= last_.high && near.end >= last_.low; },
        [&use](const PieceInterval& interval, const Interval<double>&) { use(interval); });
  }

  /// A point that leaves a piece across a cut of its outline, and nowhere else, enters a neighbouring
  /// piece. So an interval that starts then continues the contact, and no comparison is needed.
  bool continues_across_a_cut() {
    if constexpr (!Traits::has_cuts) return false;
    int ending = 0;
    bool at_a_cut = false;
    double latest_start = -unbounded, earliest_end = unbounded;
    Enclosure reached = last_;
    at_the_end([&](const PieceInterval& interval) {
      if (may_end_it(interval)) {
        ++ending;
        at_a_cut = ends_at_a_cut(interval);
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
    const EndpointCandidate<typename Traits::PieceConstraint>* only = nullptr;
    for (const auto& end : tests_.ends(interval)) {
      if (end.direction == CrossingDirection::entering) continue;
      if (only) return false;
      only = &end;
    }
    if constexpr (Traits::has_cuts) return only && Traits::is_cut(only->constraint);
    return false;
  }

  Instant latest_end() {
    if (lasts_to_the_end()) return context_.lifetime.end();
    if (end_in_doubt_) return unknown_instant();
    Instant latest{-unbounded, -unbounded};
    at_the_end([this, &latest](const PieceInterval& interval) {
      if (may_continue_it(interval)) latest = unknown_instant();
      if (latest.known() && may_end_it(interval))
        latest = later(latest, instants_.end(interval, tests_.ends(interval)));
    });
    return latest;
  }

  EndpointRounding<Traits> instants_;
  std::vector<PieceInterval>& seen_;  ///< in the last walk of follow()
  bool all_seen_ = false;             ///< seen_ is complete
  bool starts_inside_ = false;        ///< one object is inside the other
  bool lasts_until_contact_by_ = false;
  bool end_in_doubt_ = false;
  bool last_is_instant_ = false;            ///< contact was entered by one instant alone
  double contact_by_ = unbounded;           ///< contact has certainly started by then
  Instant earliest_{unbounded, unbounded};  ///< of the known starts
  double unknown_from_ = unbounded;         ///< the earliest unknown start
  Enclosure last_{-unbounded, -unbounded};  ///< the end of the contact so far
};

}  // namespace foresee
