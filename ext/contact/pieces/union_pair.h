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
//
// A Kit says what the pieces are. It has `axes` and `degree` of the motion, the types Pieces (of one object,
// under a tree), Condition, Sizes<T>, Space and Tests (pair_tests.h), sizes_of<T>() and Within, which tells
// of solids whether one lies within the other; `has_solids` says that there may be some.
#pragma once

#include "contact/certain/advancement.h"
#include "contact/certain/certain_motion.h"
#include "contact/pieces/stay_instant.h"
#include "contact/pieces/tree_walk.h"

namespace foresee::contact {

template <class Kit>
class UnionPair {
 public:
  using Pieces = typename Kit::Pieces;

  /// The moments must not be none. `times_wanted`: more is asked than whether they touch. An interrupt is
  /// heeded at each of the `steps`.
  UnionPair(const Setup& setup, const double* row_a, const double* row_b, const Pieces& a, const Pieces& b,
            const Moments& moments, bool times_wanted, typename Kit::Space& space, Steps& steps)
      : moments_(moments),
        relative_(certain_motion_of<Kit::axes, Kit::degree>(setup, row_a, row_b)),
        asked_(asked_of(moments)),
        sizes_(Kit::template sizes_of<Bounded>(setup, row_a, row_b)),
        within_(setup, row_a, row_b, a, b, relative_, steps),
        tests_(a, b, relative_, asked_, sizes_, times_wanted, space),
        walk_(a, b, relative_, {asked_.begin.low, asked_.end.high}, sizes_, steps),
        instants_(setup, row_a, row_b, relative_, sizes_, moments_, asked_),
        seen_(space.seen) {}

  UnionPair(const UnionPair&) = delete;
  UnionPair& operator=(const UnionPair&) = delete;

  /// Is there a contact? Stops at the first that is certain. If it is uncertain, the pieces alone tell.
  Verdict touches() {
    if (within_.at_begin()) return Verdict::yes;
    Verdict touches = Verdict::no;
    walk_.visit(
        Order::earlier_first, [&](const Period<double>&) { return touches != Verdict::yes; },
        [&](std::size_t a, std::size_t b, const Period<double>&) {
          for (const PieceStay& stay : tests_.of(a, b))
            if (touches != Verdict::yes) touches = stay.is_certain() ? Verdict::yes : Verdict::uncertain;
        });
    return touches;
  }

  /// Is there a contact, and when does it begin? yes: `begin` is known.
  Verdict first_contact(Instant& begin) {
    begins_within_ = within_.at_begin();
    if (begins_within_) {
      met_by_ = asked_.begin.high, begin = {moments_.dt_begin, moments_.t_begin};
      return Verdict::yes;
    }
    bool possible = false;
    walk_.visit(
        Order::earlier_first,
        [this](const Period<double>& near) { return near.begin <= met_by_ && !begins_at_once(); },
        [&](std::size_t a, std::size_t b, const Period<double>&) {
          if (tests_.is_full()) take_begins();
          for (const PieceStay& stay : tests_.of(a, b)) {
            possible = true;
            if (stay.is_certain()) met_by_ = std::min(met_by_, stay.begin.high);
          }
        });
    if (!possible) return Verdict::no;
    begin = earliest_begin();
    return begin.known() ? Verdict::yes : Verdict::uncertain;
  }

  /// By then they certainly touch; infinite if that is not known. Requires: first_contact() was asked.
  double met_by() const { return met_by_; }

  /// Requires: the begin is known. `lasts_until_met_by`: that the contact does is known.
  Instant end_of_contact(bool lasts_until_met_by) {
    if (begins_within_)
      last_ = asked_.begin;
    else if (lasts_until_met_by || !Kit::has_solids)  // stays of what fills its shape last a while
      go_on_from_met_by();
    else if (!enter(-Stay::inf))
      return unknown_instant();
    do follow();
    while (!lasts_to_the_end() && (goes_through_a_cut() || goes_on_within()));
    return latest_end();
  }

  /// After that: the last moment that certainly belongs to this contact; -infinity where none is known.
  double last_certain_moment() const { return last_.low; }

  /// Whether one lies within the other. Requires: their surfaces do not touch then.
  bool is_within_at(const Dyadic& moment) { return within_.at(moment); }

  // For the exact stage: what is possible, in order of time.

  /// When contact may begin that begins later than `after`; infinite if none may.
  double first_possible(double after) {
    double first = Stay::inf;
    all_seen_ = false;
    walk_.visit(
        Order::earlier_first,
        [&](const Period<double>& near) { return near.end > after && near.begin < first; },
        [&](std::size_t a, std::size_t b, const Period<double>& near) {
          for (const PieceStay& stay : tests_.of(a, b)) {
            const auto [begin, end] = possible(stay, near);
            if (begin <= end && begin > after) first = std::min(first, begin);
          }
        });
    return first;
  }
  /// Until when contact may last that may be at `from`.
  double possible_until(double from) {
    double until = from, passed_by = from;
    while (passed_by <= until) {
      passed_by = Stay::inf;
      const auto begins_by_then = [&](double begin) {
        if (begin > until) passed_by = std::min(passed_by, begin);
        return begin <= until;
      };
      walk_.visit(
          Order::earlier_first,
          [&](const Period<double>& near) { return near.end >= from && begins_by_then(near.begin); },
          [&](std::size_t a, std::size_t b, const Period<double>& near) {
            for (const PieceStay& stay : tests_.of(a, b)) {
              const auto [begin, end] = possible(stay, near);
              if (begin <= end && end >= from && begins_by_then(begin)) until = std::max(until, end);
            }
          });
    }
    return until;
  }
  /// Gives `take` each pair of pieces that may touch within the period, as long as it returns true.
  template <class Take>
  void possible_pairs(const Period<double>& period, Take&& take) {
    bool more = true;
    walk_.visit(
        Order::earlier_first,
        [&](const Period<double>& near) {
          return more && near.begin <= period.end && near.end >= period.begin;
        },
        [&](std::size_t a, std::size_t b, const Period<double>& near) {
          const auto stays = tests_.of(a, b);
          if (std::any_of(stays.begin(), stays.end(), [&](const PieceStay& stay) {
                const auto [begin, end] = possible(stay, near);
                return begin <= end && begin <= period.end && end >= period.begin;
              }))
            more = take(PiecePair{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
        });
  }
  bool is_grown() const { return sizes_.radius.value > 0; }  ///< near counts as touching

 private:
  /// Outward and inward.
  static Stay asked_of(const Moments& moments) {
    constexpr double u = unit_roundoff;
    const double begin = moments.dt_begin, end = moments.dt_end;
    const double wider_begin = moments.begin_exact ? 0 : 2 * u * begin;
    const double wider_end = moments.end_exact ? 0 : 2 * u * end;
    return {{begin - wider_begin, begin + wider_begin}, {end - wider_end, end + wider_end}};
  }

  /// At no other moment may they touch; never if the end is before the begin.
  static Period<double> possible(const PieceStay& stay, const Period<double>& near) {
    return {std::max(stay.begin.low, near.begin), std::min(stay.end.high, near.end)};
  }

  /// They certainly touch when what is asked about begins.
  bool begins_at_once() const { return met_by_ <= asked_.begin.low; }

  /// Of the stays found so far that may be the first, when they begin.
  void take_begins() {
    for (const PieceStay& stay : tests_.all()) {
      if (stay.begin.low > met_by_) continue;
      const Instant begin = stay.is_certain() ? instants_.begin(stay, tests_.ends(stay)) : unknown_instant();
      if (begin.known())
        earliest_ = earlier(earliest_, begin);
      else
        unknown_from_ = std::min(unknown_from_, stay.begin.low);
    }
  }

  Instant earliest_begin() {
    if (begins_at_once()) return {moments_.dt_begin, moments_.t_begin};
    take_begins();
    return unknown_from_ <= met_by_ ? unknown_instant() : earliest_;
  }

  void go_on_from_met_by() {
    last_ = {met_by_, met_by_};
    for (const PieceStay& stay : tests_.all())
      if (stay.is_certain() && stay.begin.high <= met_by_) reach(stay.end);
  }

  /// From the first of the stays that begin later than `after`, which contact may have lasted until, it lasts
  /// until last_. Whether that is told.
  bool enter(double after) {
    double met_by = Stay::inf;
    seen_.clear(), all_seen_ = false;
    walk_.visit(
        Order::earlier_first,
        [&](const Period<double>& near) { return near.end > after && near.begin <= met_by; },
        [&](std::size_t a, std::size_t b, const Period<double>&) {
          for (const PieceStay& stay : tests_.of(a, b)) {
            if (!(stay.begin.low > after)) continue;
            seen_.push_back(stay);
            if (stay.is_certain()) met_by = std::min(met_by, stay.begin.high);
          }
        });
    std::erase_if(seen_, [met_by](const PieceStay& stay) { return stay.begin.low > met_by; });
    if (seen_.empty()) return false;
    const auto are_all = [this](auto&& what) { return std::all_of(seen_.begin(), seen_.end(), what); };
    if (!are_all([](const PieceStay& stay) { return stay.is_certain(); })) return false;
    if (seen_.size() == 1) return last_ = seen_[0].end, true;
    if (!are_all([](const PieceStay& stay) { return !stay.is_moment; })) return false;
    last_ = {met_by, met_by};  // whichever is first lasts until then
    return true;
  }

  /// One lies within the other when the stays so far have ended: contact lasts until the next.
  bool goes_on_within() {
    if constexpr (!Kit::has_solids) return false;
    if (!within_.may_be()) return false;
    bool in_doubt = false;
    at_the_end([&](const PieceStay& stay) { in_doubt |= may_continue_it(stay); });
    if (in_doubt) return false;
    const double next = first_possible(last_.high), until = std::min(next, asked_.end.low);
    const double between = last_.high + (until - last_.high) / 2;
    end_in_doubt_ = !(last_.high < between && between < until);
    if (end_in_doubt_ || !within_.at(Dyadic(between))) return false;
    if (next == Stay::inf) return last_ = {asked_.end.high, asked_.end.high}, true;
    end_in_doubt_ = !enter(last_.high);
    if (end_in_doubt_) last_ = {between, between};
    return !end_in_doubt_;
  }

  void reach(const Enclosure& end) { last_ = {std::max(last_.low, end.low), std::max(last_.high, end.high)}; }

  /// Follows the contact along stays that surely begin before its end so far. Each walk looks for those that
  /// end last; the next is for what it passed by, as it begins later than the end was then.
  void follow() {
    double passed_by = Stay::inf, forgotten = Stay::inf;  // the earliest begins of nodes, and of stays
    do {
      passed_by = forgotten = Stay::inf;
      seen_.clear(), all_seen_ = true;
      const auto wanted = [this, &passed_by](const Period<double>& near) {
        if (near.end < last_.low || lasts_to_the_end()) return false;
        if (near.begin > last_.high) passed_by = std::min(passed_by, near.begin);
        return near.begin <= last_.high;
      };
      walk_.visit(Order::later_first, wanted,
                  [this, &forgotten](std::size_t a, std::size_t b, const Period<double>&) {
                    if (tests_.is_full()) forgotten = std::min(forgotten, forget_seen());
                    for (const PieceStay& stay : tests_.of(a, b)) {
                      if (is_joined(stay)) reach(stay.end);
                      seen_.push_back(stay);
                    }
                  });
      join_seen();
    } while (passed_by <= last_.high || forgotten <= last_.low);
  }

  /// When the first begins of those that are not joined so far.
  double forget_seen() {
    double first = Stay::inf;
    for (const PieceStay& stay : seen_)
      if (stay.is_certain() && !is_joined(stay)) first = std::min(first, stay.begin.high);
    seen_.clear(), all_seen_ = false;
    return first;
  }

  /// Those too that were seen before the contact reached them: in the order of their begins.
  void join_seen() {
    std::sort(seen_.begin(), seen_.end(),
              [](const Stay& a, const Stay& b) { return a.begin.high < b.begin.high; });
    for (const PieceStay& stay : seen_) {
      if (stay.begin.high > last_.low) break;
      if (stay.is_certain()) reach(stay.end);
    }
  }

  bool lasts_to_the_end() const { return last_.low >= asked_.end.high; }

  bool is_joined(const PieceStay& stay) const { return stay.is_certain() && stay.begin.high <= last_.low; }
  bool may_end_it(const PieceStay& stay) const { return is_joined(stay) && stay.end.high >= last_.low; }
  /// Whether it begins before the end is in doubt, or whether it is, and it would end after that.
  bool may_continue_it(const PieceStay& stay) const {
    return !is_joined(stay) && stay.begin.low <= last_.high && stay.end.high > last_.low;
  }

  /// Gives `use` all stays that may end the contact or continue it. Requires: follow().
  template <class Use>
  void at_the_end(Use&& use) {
    if (all_seen_) return static_cast<void>(std::for_each(seen_.begin(), seen_.end(), use));
    walk_.visit(
        Order::later_first,
        [this](const Period<double>& near) { return near.begin <= last_.high && near.end >= last_.low; },
        [this, &use](std::size_t a, std::size_t b, const Period<double>&) {
          for (const PieceStay& stay : tests_.of(a, b)) use(stay);
        });
  }

  /// What leaves a piece through a cut of its outline, and nowhere else, is in a neighbour: whoever begins
  /// then continues it, and no comparison is needed.
  bool goes_through_a_cut() {
    if constexpr (Kit::has_solids) return false;
    int ending = 0;
    bool at_a_cut = false;
    double latest_begin = -Stay::inf, earliest_end = Stay::inf;
    Enclosure reached = last_;
    at_the_end([&](const PieceStay& stay) {
      if (may_end_it(stay)) {
        ++ending, at_a_cut = ends_at_a_cut(stay);
      } else if (may_continue_it(stay)) {
        latest_begin = std::max(latest_begin, stay.begin.high);
        earliest_end = std::min(earliest_end, stay.end.low);
        reached = {std::max(reached.low, stay.end.low), std::max(reached.high, stay.end.high)};
      }
    });
    if (ending != 1 || !at_a_cut) return false;
    if (!(latest_begin <= earliest_end && reached.low > last_.high)) return false;
    last_ = reached;
    return true;
  }

  bool ends_at_a_cut(const PieceStay& stay) const {
    if (asked_.end.meets(stay.end)) return false;
    const StayEnd<typename Kit::Condition>* only = nullptr;
    for (const auto& end : tests_.ends(stay)) {
      if (end.way == Way::in) continue;
      if (only) return false;
      only = &end;
    }
    return only && Kit::is_cut(only->condition);
  }

  Instant latest_end() {
    if (lasts_to_the_end()) return {moments_.dt_end, moments_.t_end};
    if (end_in_doubt_) return unknown_instant();
    Instant latest{-Stay::inf, -Stay::inf};
    at_the_end([this, &latest](const PieceStay& stay) {
      if (may_continue_it(stay)) latest = unknown_instant();
      if (latest.known() && may_end_it(stay)) latest = later(latest, instants_.end(stay, tests_.ends(stay)));
    });
    return latest;
  }

  const Moments& moments_;
  const CertainMotion<Kit::axes> relative_;
  const Stay asked_;
  const typename Kit::template Sizes<Bounded> sizes_;
  typename Kit::Within within_;
  typename Kit::Tests tests_;
  const TreeWalk<Kit::axes, Pieces> walk_;
  StayInstants<Kit> instants_;
  std::vector<PieceStay>& seen_;  ///< by the last walk of follow()
  bool all_seen_ = false;         ///< and known still
  bool begins_within_ = false;    ///< one in the other
  bool end_in_doubt_ = false;
  double met_by_ = Stay::inf;               ///< by then they certainly touch
  Instant earliest_{Stay::inf, Stay::inf};  ///< of the begins that are known
  double unknown_from_ = Stay::inf;         ///< and since when one may be that is not
  Enclosure last_{-Stay::inf, -Stay::inf};  ///< the end of the contact, as far as it was followed
};

}  // namespace foresee::contact
