// When do two outlines touch first, and until when? As far as doubles and DoubleDouble can vouch for it;
// where they cannot, on which pieces it hangs.
//
// Contact is the union of the stays of all pairs of pieces (piece_tests.h). It begins when the earliest stay
// does. Its end is found by going on: among the stays that begin before it, one that ends after it, until
// there is none. What is only possible counts for neither; what it could change is left to the exact stage.
#pragma once

#include "contact/certain/advancement.h"
#include "contact/outline/stay_instant.h"
#include "contact/outline/tree_walk.h"

namespace foresee::contact {

template <int D, int Degree>
class OutlinePair {
 public:
  /// The moments must not be none. `times_wanted`: more is asked than whether they touch. An interrupt is
  /// heeded at each of the `steps`.
  OutlinePair(const Setup& setup, const double* row_a, const double* row_b, const ObjectPieces& a,
              const ObjectPieces& b, const Moments& moments, bool times_wanted, PieceSpace& space,
              Steps& steps)
      : moments_(moments),
        relative_(certain_motion_of<D, Degree>(setup, row_a, row_b)),
        asked_(asked_of(moments)),
        sizes_(sizes_of<Bounded>(setup, row_a, row_b)),
        tests_(a, b, relative_, asked_, sizes_, times_wanted, space),
        walk_(a, b, relative_, {asked_.begin.low, asked_.end.high}, sizes_, steps),
        instants_(setup, row_a, row_b, relative_, sizes_, moments_, asked_),
        seen_(space.seen) {}

  OutlinePair(const OutlinePair&) = delete;
  OutlinePair& operator=(const OutlinePair&) = delete;

  /// Is there a contact? Stops at the first that is certain.
  Verdict touches() {
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

  /// Requires: the contact lasts from its begin to met_by(), which is finite.
  Instant end_of_contact() {
    last_ = {met_by_, met_by_};
    for (const PieceStay& stay : tests_.all())
      if (stay.is_certain() && stay.begin.high <= met_by_) reach(stay.end);
    do follow();
    while (!lasts_to_the_end() && goes_through_a_cut());
    return latest_end();
  }

  /// After that: the last moment that certainly belongs to this contact.
  double last_certain_moment() const { return last_.low; }

  // For the exact stage: what is possible, in order of time.

  /// When contact may begin that begins later than `after`; infinite if none may.
  double first_possible(double after) {
    double first = Stay::inf;
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
    const StayEnd* only = nullptr;
    for (const StayEnd& end : tests_.ends(stay)) {
      if (end.way == Way::in) continue;
      if (only) return false;
      only = &end;
    }
    // Around a corner R ends beside the cut that begins there, not beyond it.
    return only && only->condition.kind != Condition::Kind::corner && only->condition.edge.inner;
  }

  Instant latest_end() {
    if (lasts_to_the_end()) return {moments_.dt_end, moments_.t_end};
    Instant latest{-Stay::inf, -Stay::inf};
    at_the_end([this, &latest](const PieceStay& stay) {
      if (may_continue_it(stay)) latest = unknown_instant();
      if (latest.known() && may_end_it(stay)) latest = later(latest, instants_.end(stay, tests_.ends(stay)));
    });
    return latest;
  }

  const Moments& moments_;
  const CertainMotion<D> relative_;
  const Stay asked_;
  const PairSizes<Bounded> sizes_;
  PieceTests<D, Degree> tests_;
  const TreeWalk<D> walk_;
  StayInstants<D, Degree> instants_;
  std::vector<PieceStay>& seen_;            ///< by the last walk of follow()
  bool all_seen_ = false;                   ///< and known still
  double met_by_ = Stay::inf;               ///< by then they certainly touch
  Instant earliest_{Stay::inf, Stay::inf};  ///< of the begins that are known
  double unknown_from_ = Stay::inf;         ///< and since when one may be that is not
  Enclosure last_{-Stay::inf, -Stay::inf};  ///< the end of the contact, as far as it was followed
};

}  // namespace foresee::contact
