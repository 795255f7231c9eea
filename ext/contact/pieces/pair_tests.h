// When do two pieces touch, certainly and possibly? What is the same whatever the pieces are: each pair is
// tested once, as long as there are not too many, and what its conditions leave of the time asked about are
// its stays.
//
//   for (const PieceInterval& interval : tests.of(piece_a, piece_b)) best = std::min(best, interval.begin.high);
//
// Test, which derives from this, has a function test(pair, by): it calls begin_test() and then, for each part
// of where the two touch, keep() with its conditions and end_part(). It may leave that, and return false,
// where they surely touch no earlier than after `by`.
#pragma once

#include <algorithm>
#include <span>

#include "contact/pieces/piece_workspace.h"

namespace foresee {

template <class Test, class Condition>
class PairTests {
 public:
  /// The stays of two pieces, until others are asked for. Those that begin later than `by` may be left out.
  std::span<const PieceInterval> of(std::size_t a, std::size_t b, double by = UncertainInterval::inf) {
    const PiecePair pair{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)};
    if (!times_wanted_ || is_full()) space_.clear();
    if (!times_wanted_) return test_of(pair, by).intervals;  // whoever wants no times asks once
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

  /// Before another pair is tested all are forgotten: so the memory for a pair of objects is bounded, and
  /// they are tested again if they are asked for again.
  bool is_full() const {
    return space_.tested.size() + space_.intervals.size() + space_.ends.size() >= max_known;
  }

  /// All stays that are known.
  std::span<const PieceInterval> all() const { return space_.intervals; }
  std::span<const EndpointCandidate<Condition>> ends(const PieceInterval& interval) const {
    return std::span<const EndpointCandidate<Condition>>(space_.ends)
        .subspan(interval.first_end, interval.end_count);
  }

 protected:
  PairTests(const UncertainInterval& queried, bool times_wanted, PieceWorkspace<Condition>& space)
      : queried_(queried), times_wanted_(times_wanted), space_(space) {
    space.clear();
  }

  void begin_test() {
    ++space_.tests;
    space_.clipped.start(queried_);
    space_.all_ends.clear();
    space_.shared_ends = 0;
  }
  /// What was kept so far is kept in all parts.
  void share() {
    space_.outer.start(space_.clipped);
    space_.shared_ends = space_.all_ends.size();
  }
  void begin_part() {
    space_.clipped.start(space_.outer);
    space_.all_ends.resize(space_.shared_ends);
  }
  /// What all conditions leave of the time asked about joins the stays.
  void end_part() {
    for (const UncertainInterval& interval : space_.clipped) add(interval, false);
  }

  void keep(const Condition& condition, const SublevelIntervals& inside) {
    if (space_.clipped.empty()) return;
    space_.clipped.keep(inside);
    if (!times_wanted_) return;
    for (int i = 0; i < inside.count; ++i) {
      const UncertainInterval& interval = inside.list[static_cast<std::size_t>(i)];
      if (interval.begin.high > -UncertainInterval::inf)
        space_.all_ends.push_back({condition, CrossingDirection::entering, interval.begin});
      if (interval.end.low < UncertainInterval::inf)
        space_.all_ends.push_back({condition, CrossingDirection::leaving, interval.end});
    }
  }

  /// A stay, with those ends that may be its own.
  void add(const UncertainInterval& interval, bool is_instant) {
    const auto first_end = static_cast<std::uint32_t>(space_.ends.size());
    for (const EndpointCandidate<Condition>& end : space_.all_ends)
      if (end.at.meets(end.direction == CrossingDirection::entering ? interval.begin : interval.end))
        space_.ends.push_back(end);
    const auto count = static_cast<std::uint32_t>(space_.ends.size()) - first_end;
    space_.intervals.push_back({interval, first_end, count, is_instant});
  }

  /// The last stay tells all that is asked: that they touch, or that they do all the time.
  bool is_decided() const {
    if (space_.intervals.empty() || !space_.intervals.back().is_certain()) return false;
    const PieceInterval& last = space_.intervals.back();
    return !times_wanted_ || (last.begin.high <= queried_.begin.low && last.end.low >= queried_.end.high);
  }

  const UncertainInterval queried_;
  const bool times_wanted_;
  PieceWorkspace<Condition>& space_;

 private:
  /// Some megabytes.
  static constexpr std::size_t max_known = 1 << 15;

  struct Tested {
    std::span<const PieceInterval> intervals;
    bool is_complete;
  };
  /// Their stays join all others.
  [[gnu::noinline]] Tested test_of(const PiecePair& pair, double by) {
    const std::size_t first = space_.intervals.size();
    const bool is_complete = static_cast<Test&>(*this).test(pair, by);
    return {std::span<const PieceInterval>(space_.intervals).subspan(first), is_complete};
  }
};

}  // namespace foresee
