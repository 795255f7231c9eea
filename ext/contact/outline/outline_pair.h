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
  /// The moments must not be none. `times_wanted`: more is asked than whether they touch.
  OutlinePair(const Setup& setup, const double* row_a, const double* row_b, const ObjectPieces& a,
              const ObjectPieces& b, const Moments& moments, bool times_wanted, PieceSpace& space)
      : moments_(moments),
        relative_(certain_motion_of<D, Degree>(setup, row_a, row_b)),
        asked_(asked_of(moments)),
        sizes_(sizes_of<Bounded>(setup, row_a, row_b)),
        tests_(a, b, relative_, asked_, sizes_, times_wanted, space),
        walk_(a, b, relative_, {asked_.begin.low, asked_.end.high}, sizes_.radius),
        instants_(setup, row_a, row_b, relative_, sizes_, moments_, asked_) {}

  OutlinePair(const OutlinePair&) = delete;
  OutlinePair& operator=(const OutlinePair&) = delete;

  /// Is there a contact? Stops at the first that is certain.
  Verdict touches() {
    bool met = false;
    walk_.visit(
        Order::earlier_first, [&met](const Period<double>&) { return !met; },
        [this, &met](std::size_t a, std::size_t b) {
          for (const PieceStay& stay : tests_.of(a, b)) met = met || stay.is_certain();
        });
    if (met) return Verdict::yes;
    return tests_.all().empty() ? Verdict::no : Verdict::uncertain;
  }

  /// Is there a contact, and when does it begin? yes: `begin` is known.
  Verdict first_contact(Instant& begin) {
    met_by_ = Stay::inf;
    walk_.visit(
        Order::earlier_first,
        [this](const Period<double>& near) { return near.begin <= met_by_ && !begins_at_once(); },
        [this](std::size_t a, std::size_t b) {
          for (const PieceStay& stay : tests_.of(a, b))
            if (stay.is_certain()) met_by_ = std::min(met_by_, stay.begin.high);
        });
    if (tests_.all().empty()) return Verdict::no;
    begin = earliest_begin();
    return begin.known() ? Verdict::yes : Verdict::uncertain;
  }

  /// Requires: first_contact() has said yes.
  Instant end_of_contact() {
    last_ = {-Stay::inf, -Stay::inf};
    for (const PieceStay& stay : tests_.all())
      if (stay.is_certain() && stay.begin.high <= met_by_) reach(stay.end);
    do
      while (goes_on()) {
      }
    while (goes_through_a_cut());
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
        [&](std::size_t a, std::size_t b) {
          for (const PieceStay& stay : tests_.of(a, b))
            if (stay.begin.low > after) first = std::min(first, stay.begin.low);
        });
    return first;
  }
  /// Until when contact may last that may be at `from`. All pieces that may touch meanwhile have been tested
  /// then.
  double possible_until(double from) {
    double until = from;
    for (double reached = -Stay::inf; reached < until;) {
      reached = until;
      walk_.visit(
          Order::later_first,
          [&](const Period<double>& near) { return near.begin <= until && near.end >= from; },
          [this](std::size_t a, std::size_t b) { tests_.of(a, b); });
      for (const PieceStay& stay : tests_.all())
        if (stay.begin.low <= until && stay.end.high >= from) until = std::max(until, stay.end.high);
    }
    return until;
  }

  PieceTests<D, Degree>& tests() { return tests_; }

 private:
  /// Outward and inward.
  static Stay asked_of(const Moments& moments) {
    constexpr double u = unit_roundoff;
    const double begin = moments.dt_begin, end = moments.dt_end;
    const double wider_begin = moments.begin_exact ? 0 : 2 * u * begin;
    const double wider_end = moments.end_exact ? 0 : 2 * u * end;
    return {{begin - wider_begin, begin + wider_begin}, {end - wider_end, end + wider_end}};
  }

  /// They certainly touch when what is asked about begins.
  bool begins_at_once() const { return met_by_ <= asked_.begin.low; }

  Instant earliest_begin() {
    if (begins_at_once()) return {moments_.dt_begin, moments_.t_begin};
    Instant earliest{Stay::inf, Stay::inf};
    for (const PieceStay& stay : tests_.all()) {
      if (stay.begin.low > met_by_) continue;
      if (!stay.is_certain()) return unknown_instant();
      earliest = earlier(earliest, instants_.begin(stay, tests_.ends(stay)));
    }
    return earliest;
  }

  void reach(const Enclosure& end) { last_ = {std::max(last_.low, end.low), std::max(last_.high, end.high)}; }

  /// Follows the contact along stays that surely begin before its end so far. Whether there may be others,
  /// among what was passed by because it begins later than the end was then.
  bool goes_on() {
    double passed_by = Stay::inf;
    const auto wanted = [this, &passed_by](const Period<double>& near) {
      if (near.end < last_.low || lasts_to_the_end()) return false;
      if (near.begin <= last_.high) return true;
      passed_by = std::min(passed_by, near.begin);
      return false;
    };
    walk_.visit(Order::later_first, wanted, [this](std::size_t a, std::size_t b) {
      for (const PieceStay& stay : tests_.of(a, b))
        if (is_joined(stay)) reach(stay.end);
    });
    for (double before = -Stay::inf; before < last_.low;) {
      before = last_.low;
      for (const PieceStay& stay : tests_.all())
        if (is_joined(stay)) reach(stay.end);
    }
    return passed_by <= last_.high;
  }

  bool lasts_to_the_end() const { return last_.low >= asked_.end.high; }

  bool is_joined(const PieceStay& stay) const { return stay.is_certain() && stay.begin.high <= last_.low; }
  bool may_end_it(const PieceStay& stay) const { return is_joined(stay) && stay.end.high >= last_.low; }
  /// Whether it begins before the end is in doubt, or whether it is, and it would end after that.
  bool may_continue_it(const PieceStay& stay) const {
    return !is_joined(stay) && stay.begin.low <= last_.high && stay.end.high > last_.low;
  }

  /// What leaves a piece through a cut of its outline, and nowhere else, is in a neighbour: whoever begins
  /// then continues it, and no comparison is needed.
  bool goes_through_a_cut() {
    const PieceStay* ending = nullptr;
    double latest_begin = -Stay::inf, earliest_end = Stay::inf;
    Enclosure reached = last_;
    for (const PieceStay& stay : tests_.all()) {
      if (may_end_it(stay)) {
        if (ending) return false;
        ending = &stay;
      } else if (may_continue_it(stay)) {
        latest_begin = std::max(latest_begin, stay.begin.high);
        earliest_end = std::min(earliest_end, stay.end.low);
        reached = {std::max(reached.low, stay.end.low), std::max(reached.high, stay.end.high)};
      }
    }
    if (!ending || !ends_at_a_cut(*ending)) return false;
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
    for (const PieceStay& stay : tests_.all()) {
      if (may_continue_it(stay)) return unknown_instant();
      if (may_end_it(stay)) latest = later(latest, instants_.end(stay, tests_.ends(stay)));
    }
    return latest;
  }

  const Moments& moments_;
  const CertainMotion<D> relative_;
  const Stay asked_;
  const PairSizes<Bounded> sizes_;
  PieceTests<D, Degree> tests_;
  const TreeWalk<D> walk_;
  StayInstants<D, Degree> instants_;
  double met_by_ = Stay::inf;               ///< by then they certainly touch
  Enclosure last_{-Stay::inf, -Stay::inf};  ///< the end of the contact, as far as it was followed
};

}  // namespace foresee::contact
