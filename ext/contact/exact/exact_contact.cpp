#include "contact/exact/exact_contact.h"

#include <algorithm>
#include <cmath>

#include "numbers/crossed_root.h"
#include "numbers/time_intervals.h"

namespace foresee {
namespace {

class ExactPair {
 public:
  ExactPair(PiecePolynomials& polynomials, const ExactLifetime& lifetime)
      : polynomials_(polynomials), lifetime_(lifetime), begin_(lifetime.begin), end_(lifetime.end) {}

  bool touches() {
    for (const ConstraintUnion::Piece& piece : polynomials_.set().pieces())
      if (!held(piece).empty()) return true;
    return false;
  }

  NeededPieces needed(std::size_t limit) {
    const std::vector<Held> chain = chain_of(all_held());
    NeededPieces needed{{}, HUGE_VAL};
    std::size_t count = chain.size();
    if (count > limit) {
      const double until = std::nextafter(chain[limit].interval.first->at.low().rounded(), -HUGE_VAL);
      if (lifetime_.begin < Dyadic(until)) needed.until = until, count = limit;
    }
    for (std::size_t i = 0; i < count; ++i) needed.pieces.push_back(chain[i].piece);
    std::sort(needed.pieces.begin(), needed.pieces.end());
    needed.pieces.erase(std::unique(needed.pieces.begin(), needed.pieces.end()), needed.pieces.end());
    return needed;
  }

  std::optional<ContactTimes> times(const TouchesBetween& between) {
    std::vector<TimeInterval> intervals = intervals_of_all();
    if (intervals.empty()) return {};
    std::size_t joined = join_first(intervals);
    while (between && goes_on_after(intervals, joined, between)) {
      if (joined == intervals.size()) {
        intervals.push_back({intervals[0].first, &end_});
        ++joined;
        break;
      }
      intervals[0].last = first_after(intervals, joined)->first;
      joined = joined_to_first(intervals);
    }
    return times_of(intervals.data(), joined);
  }

  std::vector<ContactTimes> contacts() {
    std::vector<ContactTimes> contacts;
    for (std::vector<TimeInterval> left = intervals_of_all(); !left.empty();) {
      const std::size_t joined = join_first(left);
      contacts.push_back(times_of(left.data(), joined));
      left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(joined));
    }
    return contacts;
  }

 private:
  /// In no order.
  std::vector<TimeInterval> intervals_of_all() {
    std::vector<TimeInterval> intervals;
    for (const ConstraintUnion::Piece& piece : polynomials_.set().pieces())
      for (const TimeInterval& interval : held(piece)) intervals.push_back(interval);
    return intervals;
  }

  /// Moves the earliest interval, and those connected with it, to the front, and returns their number.
  std::size_t join_first(std::vector<TimeInterval>& intervals) {
    std::iter_swap(intervals.begin(), std::min_element(intervals.begin(), intervals.end(), starts_before));
    return joined_to_first(intervals);
  }

  /// One interval in which a piece holds.
  struct Held {
    TimeInterval interval;
    std::uint32_t piece;
  };

  /// All intervals of all pieces, sorted by start; of those with the same start the longest is first.
  std::vector<Held> all_held() {
    std::vector<Held> all;
    std::uint32_t number = 0;
    for (const ConstraintUnion::Piece& piece : polynomials_.set().pieces()) {
      for (const TimeInterval& interval : held(piece)) all.push_back({interval, number});
      ++number;
    }
    std::sort(all.begin(), all.end(), [this](const Held& a, const Held& b) {
      const int order = compared(*a.interval.first, *b.interval.first);
      return order != 0 ? order < 0 : compared(*a.interval.last, *b.interval.last) > 0;
    });
    return all;
  }

  /// The smallest subset with the same union. The next one is, of the intervals that start before the last
  /// one ends, the one with the latest end.
  std::vector<Held> chain_of(const std::vector<Held>& all) {
    std::vector<Held> chain;
    for (std::size_t i = 0; i < all.size();) {
      for (const Held* next = &all[i++]; next;) {
        chain.push_back(*next);
        AlgebraicRoot &end = *next->interval.last, *latest = &end;
        next = nullptr;
        for (; i < all.size() && compared(*all[i].interval.first, end) <= 0; ++i)
          if (compared(*all[i].interval.last, *latest) > 0) next = &all[i], latest = all[i].interval.last;
      }
    }
    return chain;
  }

  int compared(AlgebraicRoot& a, AlgebraicRoot& b) {
    polynomials_.step();
    return compare(a, b);
  }

  Instant instant(AlgebraicRoot& time) const {
    const PairLifetime& m = lifetime_.rounded;
    if (&time == &begin_) return {m.dt_start, m.t_start};
    if (&time == &end_) return {m.dt_end, m.t_end};
    return {rounded(time, Dyadic()), rounded(time, lifetime_.now)};
  }

  /// The earliest interval that is not joined to the first one; all such intervals start after the joined
  /// ones end.
  static std::vector<TimeInterval>::iterator first_after(std::vector<TimeInterval>& intervals,
                                                         std::size_t joined) {
    return std::min_element(
        intervals.begin() + static_cast<std::ptrdiff_t>(joined), intervals.end(),
        [](const TimeInterval& a, const TimeInterval& b) { return compare(*a.first, *b.first) < 0; });
  }

  /// Whether the pair touches from the end of the joined intervals until the start of the next one.
  bool goes_on_after(std::vector<TimeInterval>& intervals, std::size_t joined,
                     const TouchesBetween& between) {
    AlgebraicRoot* last = intervals[0].last;
    for (std::size_t i = 1; i < joined; ++i)
      if (compare(*intervals[i].last, *last) > 0) last = intervals[i].last;
    AlgebraicRoot& next = joined == intervals.size() ? end_ : *first_after(intervals, joined)->first;
    return compare(*last, next) < 0 && between(time_between(*last, next));
  }

  /// Requires: a < b.
  static Dyadic time_between(AlgebraicRoot& a, AlgebraicRoot& b) {
    for (int bits = 128;; bits *= 2) {
      const Dyadic low = a.known ? *a.known : a.enclosure(bits).high();
      const Dyadic high = b.known ? *b.known : b.enclosure(bits).low();
      if (low < high) return half_of(low + high);
    }
  }

  /// The intervals in which all conditions of the piece hold.
  TimeIntervals held(const ConstraintUnion::Piece& piece) {
    polynomials_.step();
    const ConstraintUnion& set = polynomials_.set();
    const auto all = set.members(piece.all);
    const auto around = set.members(piece.around), beyond = set.members(piece.beyond);
    TimeIntervals met{{&begin_, &end_}};
    for (std::size_t i = 0; i < all.size() && !met.empty(); ++i)
      if (all[i] != piece.ball) met = common(met, sublevel_intervals(all[i]));
    if (piece.ball < 0) return met;
    for (std::size_t i = 0; i < beyond.size() && !met.empty(); ++i)
      met = common(met, complement(sublevel_intervals(beyond[i]), {begin_, end_}));
    if (met.empty()) return met;
    LazyPolynomial& polynomial = polynomials_.polynomial(polynomials_.number_of(piece.ball));
    TimeIntervals near = met;
    if (is_bent(polynomial))
      for (std::size_t i = 0; i < around.size() && !near.empty(); ++i)
        near = common(near, sublevel_intervals(around[i]));
    if (near.empty()) return near;
    return common(met, inside_while(near, polynomial));
  }

  /// Whether the roots are costly, so that a filter by `around` pays.
  static bool is_bent(const LazyPolynomial& polynomial) {
    return polynomial.rough()[3].sign() != 0 || polynomial.rough()[4].sign() != 0;
  }

  /// The intervals of a costly polynomial, which belongs to one piece alone: computed only around the
  /// intervals that the rest of the piece leaves.
  TimeIntervals inside_while(const TimeIntervals& rest, LazyPolynomial& polynomial) {
    const AlgebraicRoot &first = *rest.front().first, &last = *rest.back().last;
    AlgebraicRoot *from = &begin_, *to = &end_;
    if (&first != &begin_) from = known_time(first.at.low().dyadic(), begin_);
    if (&last != &end_) to = known_time(last.at.high().dyadic(), end_);
    return foresee::sublevel_intervals(polynomial, {*from, *to});
  }

  /// The time as an end of an interval; `limit` if it is outside the lifetime.
  AlgebraicRoot* known_time(const Dyadic& time, AlgebraicRoot& limit) {
    if (time < lifetime_.begin || lifetime_.end < time) return &limit;
    made_times_.push_back(time);
    known_times_.emplace_back(made_times_.back());
    return &known_times_.back();
  }

  const TimeIntervals& sublevel_intervals(int primitive) {
    const std::size_t number = polynomials_.number_of(primitive);
    if (inside_.size() <= number) inside_.resize(number + 1);
    std::optional<TimeIntervals>& known = inside_[number];
    if (!known) {
      polynomials_.step();  // a piece may have tens of thousands of conditions
      known = foresee::sublevel_intervals(polynomials_.polynomial(number), {begin_, end_});
    }
    return *known;
  }

  /// Two intervals that certainly overlap are one contact, whichever starts first: their starts need no exact
  /// comparison.
  static bool starts_before(const TimeInterval& a, const TimeInterval& b) {
    const int rough = (a.first->at - b.first->at).sign();
    if (rough != unknown_sign) return rough < 0;
    if ((b.last->at - a.first->at).sign() == 1 && (a.last->at - b.first->at).sign() == 1) return false;
    return compare(*a.first, *b.first) < 0;
  }

  /// Moves the intervals that are connected with the first to the front, and returns their number. In
  /// approximate order of their starts nearly all are tested once.
  std::size_t joined_to_first(std::vector<TimeInterval>& intervals) {
    std::sort(intervals.begin() + 1, intervals.end(), [](const TimeInterval& a, const TimeInterval& b) {
      return a.first->at.rounded() < b.first->at.rounded();
    });
    std::vector<AlgebraicRoot*> latest{intervals[0].last};
    std::size_t joined = 1;
    for (bool more = true; more;) {
      more = false;
      for (std::size_t i = joined; i < intervals.size(); ++i) {
        if (!joins(intervals[i], latest)) continue;
        reach(intervals[i].last, latest);
        std::swap(intervals[i], intervals[joined++]);
        more = true;
      }
    }
    return joined;
  }

  bool joins(const TimeInterval& interval, const std::vector<AlgebraicRoot*>& latest) {
    return std::any_of(latest.begin(), latest.end(),
                       [&](AlgebraicRoot* last) { return compared(*interval.first, *last) <= 0; });
  }

  /// `latest` has the ends reached that 128 bits do not prove to be earlier than another one.
  static void reach(AlgebraicRoot* end, std::vector<AlgebraicRoot*>& latest) {
    for (const AlgebraicRoot* known : latest)
      if (known == end || (end->at - known->at).sign() == -1) return;
    std::erase_if(latest, [end](const AlgebraicRoot* known) { return (known->at - end->at).sign() == -1; });
    latest.push_back(end);
  }

  /// Start and end of connected intervals. Rounding is monotone: ends that 128 bits do not tell apart are
  /// rounded one by one and then compared.
  ContactTimes times_of(const TimeInterval* intervals, std::size_t count) const {
    AlgebraicRoot *first = intervals[0].first, *last = intervals[0].last;
    Instant begin = instant(*first), end = instant(*last);
    for (std::size_t i = 1; i < count; ++i) {
      if (intervals[i].first != first && (intervals[i].first->at - first->at).sign() != 1)
        begin = earlier(begin, instant(*intervals[i].first));
      const int longer = (intervals[i].last->at - last->at).sign();
      if (intervals[i].last == last || longer == -1) continue;
      end = later(end, instant(*intervals[i].last));
      if (longer == 1) last = intervals[i].last;
    }
    return {begin.t, end.t, begin.dt, end.dt};
  }

  PiecePolynomials& polynomials_;
  const ExactLifetime& lifetime_;
  AlgebraicRoot begin_, end_;
  std::vector<std::optional<TimeIntervals>> inside_;  ///< of each polynomial
  std::deque<Dyadic> made_times_;
  std::deque<AlgebraicRoot> known_times_;
};

}  // namespace

NeededPieces needed_pieces(PiecePolynomials& polynomials, const ExactLifetime& lifetime, std::size_t limit) {
  return ExactPair(polynomials, lifetime).needed(limit);
}

bool exact_touches(PiecePolynomials& polynomials, const ExactLifetime& lifetime) {
  return ExactPair(polynomials, lifetime).touches();
}

std::optional<ContactTimes> exact_times(PiecePolynomials& polynomials, const ExactLifetime& lifetime,
                                        const TouchesBetween& between) {
  return ExactPair(polynomials, lifetime).times(between);
}

std::vector<ContactTimes> exact_contacts(PiecePolynomials& polynomials, const ExactLifetime& lifetime) {
  return ExactPair(polynomials, lifetime).contacts();
}

}  // namespace foresee
