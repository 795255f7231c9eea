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

#include "contact/pieces/pair_stays.h"
#include "contact/pieces/stay_instant.h"

namespace foresee {

template <class Kit>
class UnionPair : public PairStays<Kit> {
  using Base = PairStays<Kit>;
  using Base::way_, Base::within_, Base::tests_;

 public:
  /// As that of PairStays.
  UnionPair(const PairWay<Kit>& way, bool times_wanted, typename Kit::Space& space)
      : Base(way, times_wanted, space),
        instants_(way.setup, way.row_a, way.row_b, way.relative, way.sizes, way.moments, way.asked),
        seen_(space.seen) {}

  /// Is there a contact? Stops at the first that is certain. If it is uncertain, the pieces alone tell.
  Verdict touches() {
    if (Base::is_within_at_begin()) return Verdict::yes;
    Verdict touches = Verdict::no;
    way_.walk.visit(
        Order::earlier_first, [&](const Period<double>&) { return touches != Verdict::yes; },
        [&](std::size_t a, std::size_t b, const Period<double>&) {
          for (const PieceStay& stay : tests_.of(a, b))
            if (touches != Verdict::yes) touches = stay.is_certain() ? Verdict::yes : Verdict::uncertain;
        });
    return touches;
  }

  /// Is there a contact, and when does it begin? yes: `begin` is known.
  Verdict first_contact(Instant& begin) {
    begins_within_ = Base::is_within_at_begin();
    if (begins_within_) {
      met_by_ = way_.asked.begin.high, begin = {way_.moments.dt_begin, way_.moments.t_begin};
      return Verdict::yes;
    }
    bool possible = false;
    way_.walk.visit(
        Order::earlier_first,
        [this](const Period<double>& near) { return near.begin <= met_by_ && !begins_at_once(); },
        [&](std::size_t a, std::size_t b, const Period<double>&) {
          if (tests_.is_full()) take_begins();
          for (const PieceStay& stay : tests_.of(a, b, met_by_)) {
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
      last_ = way_.asked.begin;
    else if (lasts_until_met_by || !Kit::has_solids)  // stays of what fills its shape last a while
      go_on_from_met_by();
    else if (!enter(-Stay::inf))
      return unknown_instant();
    do follow();
    while (!lasts_to_the_end() && (goes_through_a_cut() || goes_on_within()));
    return latest_end();
  }

  /// After that: the last moment that certainly belongs to this contact, or one shortly before its end,
  /// between which no other contact begins; -infinity where none is known.
  double last_certain_moment() const { return last_.low; }

 private:
  /// They certainly touch when what is asked about begins.
  bool begins_at_once() const { return met_by_ <= way_.asked.begin.low; }

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
    if (begins_at_once()) return {way_.moments.dt_begin, way_.moments.t_begin};
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
    seen_.clear(), all_seen_ = last_is_moment_ = false;
    way_.walk.visit(
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
    if (seen_.size() == 1) {
      last_ = seen_[0].end, last_is_moment_ = seen_[0].is_moment;
      return true;
    }
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
    all_seen_ = false;  // as others may be tested
    const double next = Base::first_possible(last_.high), until = std::min(next, way_.asked.end.low);
    const double between = last_.high + (until - last_.high) / 2;
    end_in_doubt_ = !(last_.high < between && between < until);
    if (end_in_doubt_ || !within_.at(Dyadic(between))) return false;
    if (next == Stay::inf) return last_ = {way_.asked.end.high, way_.asked.end.high}, true;
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
      way_.walk.visit(Order::later_first, wanted,
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

  bool lasts_to_the_end() const { return last_.low >= way_.asked.end.high; }

  bool is_joined(const PieceStay& stay) const {
    if (stay.is_moment && last_is_moment_ && stay.end.low == last_.low && stay.end.high == last_.high)
      return true;
    return stay.is_certain() && stay.begin.high <= last_.low;
  }
  bool may_end_it(const PieceStay& stay) const { return is_joined(stay) && stay.end.high >= last_.low; }
  /// Whether it begins before the end is in doubt, or whether it is, and it would end after that.
  bool may_continue_it(const PieceStay& stay) const {
    return !is_joined(stay) && stay.begin.low <= last_.high && stay.end.high > last_.low;
  }

  /// Gives `use` all stays that may end the contact or continue it. Requires: follow().
  template <class Use>
  void at_the_end(Use&& use) {
    if (all_seen_) return static_cast<void>(std::for_each(seen_.begin(), seen_.end(), use));
    way_.walk.visit(
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
    if (way_.asked.end.meets(stay.end)) return false;
    const StayEnd<typename Kit::Condition>* only = nullptr;
    for (const auto& end : tests_.ends(stay)) {
      if (end.way == Way::in) continue;
      if (only) return false;
      only = &end;
    }
    return only && Kit::is_cut(only->condition);
  }

  Instant latest_end() {
    if (lasts_to_the_end()) return {way_.moments.dt_end, way_.moments.t_end};
    if (end_in_doubt_) return unknown_instant();
    Instant latest{-Stay::inf, -Stay::inf};
    at_the_end([this, &latest](const PieceStay& stay) {
      if (may_continue_it(stay)) latest = unknown_instant();
      if (latest.known() && may_end_it(stay)) latest = later(latest, instants_.end(stay, tests_.ends(stay)));
    });
    return latest;
  }

  StayInstants<Kit> instants_;
  std::vector<PieceStay>& seen_;  ///< by the last walk of follow()
  bool all_seen_ = false;         ///< and known still
  bool begins_within_ = false;    ///< one in the other
  bool end_in_doubt_ = false;
  bool last_is_moment_ = false;             ///< when the contact was entered again, alone
  double met_by_ = Stay::inf;               ///< by then they certainly touch
  Instant earliest_{Stay::inf, Stay::inf};  ///< of the begins that are known
  double unknown_from_ = Stay::inf;         ///< and since when one may be that is not
  Enclosure last_{-Stay::inf, -Stay::inf};  ///< the end of the contact, as far as it was followed
};

}  // namespace foresee
