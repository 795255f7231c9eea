// Uncertain intervals of contact for pairs of convex pieces: each pair is tested once and its result kept.
//
//   for (const PieceInterval& interval : tests.of(piece_a, piece_b)) best = std::min(best, interval.begin.high);
//
// This is the part of a test that does not depend on the kind of piece. The contact set of two pieces is a
// union of parts, each the intersection of some constraints. Test, which derives from PairTests, has a
// function test(pair, by). It calls start_test(), then for each part keep() with its constraints and
// end_part(). It may stop and return false if the two surely touch no earlier than after `by`.
//
// The memory for all this is a PieceWorkspace, which one pair of objects after another uses.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/repeatable_choice.h"
#include "contact/certified/uncertain_interval.h"
#include "numbers/crossed_root.h"

namespace foresee {

/// The numbers of two pieces, one of each object.
struct PiecePair {
  std::uint32_t a, b;

  friend auto operator<=>(const PiecePair&, const PiecePair&) = default;
};

/// The pairs of pieces that were tested, with a number each: a hash set with open addressing, which clear()
/// empties in constant time.
class TestedPairs {
 public:
  void clear() {
    ++round_;
    count_ = 0;
  }
  std::uint32_t size() const { return count_; }

  /// The number of a pair, counted from 0, and whether the pair is new.
  struct Entry {
    std::uint32_t number;
    bool is_new;
  };
  Entry add(const PiecePair& pair) {
    if (2 * count_ >= slots_.size()) grow();
    Slot& slot = slot_of(pair);
    const bool is_new = slot.round != round_;
    if (is_new) slot = {pair, count_++, round_};
    return {slot.number, is_new};
  }

 private:
  struct Slot {
    PiecePair pair = {};
    std::uint32_t number = 0;
    std::uint64_t round = 0;  ///< a slot of another round is free
  };

  Slot& slot_of(const PiecePair& pair) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = ((std::uint64_t{pair.a} << 32 | pair.b) * by_golden_ratio >> 32) & mask;
    while (slots_[i].round == round_ && slots_[i].pair != pair) i = (i + 1) & mask;
    return slots_[i];
  }

  void grow() {
    std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.round == round_) slot_of(slot.pair) = slot;
  }

  std::vector<Slot> slots_;
  std::uint64_t round_ = 1;
  std::uint32_t count_ = 0;
};

/// A root of a constraint's polynomial at which an interval of contact may start or end.
template <class PieceConstraint>
struct EndpointCandidate {
  PieceConstraint constraint;
  CrossingDirection direction;
  Enclosure at;
};

/// An uncertain interval in which two pieces touch, and the candidates for its two ends.
struct PieceInterval : UncertainInterval {
  std::uint32_t first_end, end_count;  ///< among all ends
  bool is_instant = false;             ///< start and end are one root, so it is certain

  bool is_certain() const { return is_instant || UncertainInterval::is_certain(); }
};

/// The memory of the tests, used for one pair of objects after another.
template <class PieceConstraint>
struct PieceWorkspace {
  struct Tested {
    std::uint32_t first_interval = 0, interval_count = 0;
    bool is_complete = false;  ///< false: the pair touches later than was queried
  };
  TestedPairs numbers;
  std::vector<Tested> tested;  ///< by those numbers
  std::vector<PieceInterval> intervals;
  std::vector<EndpointCandidate<PieceConstraint>> ends;
  std::vector<PieceInterval> seen;
  // Of the part in work:
  std::vector<EndpointCandidate<PieceConstraint>> all_ends;
  std::size_t shared_ends = 0;  ///< so many of these belong to all parts
  IntervalUnion clipped, outer;

  std::uint64_t tests = 0;  ///< of two pieces, in all pairs of objects so far

  void clear() {
    numbers.clear();
    tested.clear();
    intervals.clear();
    ends.clear();
  }
};

template <class Test, class PieceConstraint>
class PairTests {
 public:
  /// The intervals in which two pieces touch; valid until the next call. Those that start later than `by` may
  /// be missing.
  std::span<const PieceInterval> of(std::size_t a, std::size_t b, double by = unbounded) {
    const PiecePair pair{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)};
    if (!times_wanted_ || is_full()) space_.clear();
    if (!times_wanted_) return test_of(pair, by).intervals;  // decide() tests each pair once
    const auto [number, is_new] = space_.numbers.add(pair);
    if (is_new) space_.tested.emplace_back();
    auto& tested = space_.tested[number];
    if (!tested.is_complete) {
      const auto first = static_cast<std::uint32_t>(space_.intervals.size());
      const auto [intervals, is_complete] = test_of(pair, by);
      tested = {first, static_cast<std::uint32_t>(intervals.size()), is_complete};
    }
    return std::span<const PieceInterval>(space_.intervals)
        .subspan(tested.first_interval, tested.interval_count);
  }

  /// The next test of a new pair discards all results. So the memory for a pair of objects is bounded; a
  /// discarded pair is tested again when it is needed again.
  bool is_full() const {
    return space_.tested.size() + space_.intervals.size() + space_.ends.size() >= max_known;
  }

  /// All intervals that are known.
  std::span<const PieceInterval> all() const { return space_.intervals; }
  std::span<const EndpointCandidate<PieceConstraint>> ends(const PieceInterval& interval) const {
    return std::span<const EndpointCandidate<PieceConstraint>>(space_.ends)
        .subspan(interval.first_end, interval.end_count);
  }

 protected:
  /// `Context`: a PairContext, which must outlive this like the space.
  template <class Context>
  PairTests(const Context& context, PieceWorkspace<PieceConstraint>& space)
      : queried_(context.queried), times_wanted_(context.times_wanted), space_(space) {
    space.clear();
  }

  void start_test() {
    ++space_.tests;
    space_.clipped.start(queried_);
    space_.all_ends.clear();
    space_.shared_ends = 0;
  }
  /// Makes the constraints so far constraints of all parts that follow.
  void share() {
    space_.outer.start(space_.clipped);
    space_.shared_ends = space_.all_ends.size();
  }
  void start_part() {
    space_.clipped.start(space_.outer);
    space_.all_ends.resize(space_.shared_ends);
  }
  /// Adds the times at which all constraints of the part hold to the intervals.
  void end_part() {
    for (const UncertainInterval& interval : space_.clipped) add(interval, false);
  }

  void keep(const PieceConstraint& constraint, const SublevelIntervals& inside) {
    if (space_.clipped.empty()) return;
    space_.clipped.keep(inside);
    if (!times_wanted_) return;
    for (int i = 0; i < inside.count; ++i) {
      const UncertainInterval& interval = inside.list[static_cast<std::size_t>(i)];
      if (interval.begin.high > -unbounded)
        space_.all_ends.push_back({constraint, CrossingDirection::entering, interval.begin});
      if (interval.end.low < unbounded)
        space_.all_ends.push_back({constraint, CrossingDirection::leaving, interval.end});
    }
  }

  /// Adds an interval with the candidates that its ends may be.
  void add(const UncertainInterval& interval, bool is_instant) {
    const auto first_end = static_cast<std::uint32_t>(space_.ends.size());
    for (const EndpointCandidate<PieceConstraint>& end : space_.all_ends)
      if (end.at.meets(end.direction == CrossingDirection::entering ? interval.begin : interval.end))
        space_.ends.push_back(end);
    const auto count = static_cast<std::uint32_t>(space_.ends.size()) - first_end;
    space_.intervals.push_back({interval, first_end, count, is_instant});
  }

  /// Whether the last interval answers the query: the two touch, or, if times are wanted, they touch all the
  /// time.
  bool is_decided() const {
    if (space_.intervals.empty() || !space_.intervals.back().is_certain()) return false;
    const PieceInterval& last = space_.intervals.back();
    return !times_wanted_ || (last.begin.high <= queried_.begin.low && last.end.low >= queried_.end.high);
  }

  const UncertainInterval queried_;
  const bool times_wanted_;
  PieceWorkspace<PieceConstraint>& space_;

 private:
  /// Entries of all kinds: some megabytes.
  static constexpr std::size_t max_known = 1 << 15;

  struct Tested {
    std::span<const PieceInterval> intervals;
    bool is_complete;
  };
  /// Tests a pair and appends its intervals.
  [[gnu::noinline]] Tested test_of(const PiecePair& pair, double by) {
    const std::size_t first = space_.intervals.size();
    const bool is_complete = static_cast<Test&>(*this).test(pair, by);
    return {std::span<const PieceInterval>(space_.intervals).subspan(first), is_complete};
  }
};

}  // namespace foresee
