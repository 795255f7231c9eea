// The ranges of changes that are clear of all intruders: bisection, with a certificate per intruder and range.
//
//   RangeBisection<2> bisection(changed.legs, intruders, interrupt);
//   for (const KRange& range : bisection.clear_ranges(-180, 180)) …
//
// Guarantee: every double of a returned range is clear (contact/clearance/separation.h), including its ends.
// The ranges are in ascending order and disjoint. What is between them is not proven clear.
//
// Turns at which convex outlines that rotate certainly touch are found first, in closed form; the turns between them
// are searched. One bisection serves all intruders. A range that is certainly clear of an intruder is so for both
// halves, so that intruder is left out of them. A range blocked by any intruder is not bisected. So each intruder is
// tested only near the ends that it causes. A range too narrow to bisect (2^-40 of all, or what rounding
// hides) is not clear. Where an intruder leaves more ranges undecided than usual, as along a grazing path,
// narrow ranges are given up earlier: at 2^-22 of all after a million evaluations of that intruder. After four
// million of it, or sixteen million of all, that is 2^-12. Intruders of several parts are tested per part once
// that is worth its cost. Up to some ten thousand intruders and parts are divided for good; the parts of further ones
// are made again at each use.
// Cost: turns are first divided into parts of at most 45 degrees. One certificate per intruder and part, some 100 per
// end. Memory: four bytes per undecided intruder and level, and some megabytes of parts.
#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "query/avoid/intruder.h"

namespace foresee {

struct KRange {
  double from, to;
};

template <int D>
class RangeBisection {
 public:
  using Legs = std::vector<std::unique_ptr<Changes>>;

  /// The intruders are tested in their order: the nearest should be first. An object that several legs meet is several
  /// intruders.
  RangeBisection(const Legs& legs, std::vector<Intruder<D>> intruders, Interrupt& interrupt);

  /// Requires: lo < hi.
  std::vector<KRange> clear_ranges(double lo, double hi);

 private:
  /// A range, and the families of its legs; those of later legs once they are needed.
  class Range {
   public:
    Range(const Legs& legs, double from_k, double to_k, bool coarse)
        : from(from_k),
          to(to_k),
          is_coarse(coarse),
          legs_(legs),
          of_first_leg_(trajectory_family<D>(*legs[0], from, to)) {}

    const TrajectoryFamily<D>& family(const Intruder<D>& intruder) const {
      const std::size_t leg = intruder.leg();
      if (leg == 0) return of_first_leg_;
      const auto known = of_later_legs_.find(leg);
      if (known != of_later_legs_.end()) return known->second;
      return of_later_legs_.emplace(leg, trajectory_family<D>(*legs_[leg], from, to)).first->second;
    }

    const double from, to;
    const bool is_coarse;  ///< one of the first parts of the whole, in which all intruders are tested

   private:
    const Legs& legs_;
    TrajectoryFamily<D> of_first_leg_;
    mutable std::unordered_map<std::size_t, TrajectoryFamily<D>> of_later_legs_;
  };
  using Numbers = std::vector<std::uint32_t>;  ///< of intruders and parts, as IntruderParts counts them
  /// The places in undecided_ of the intruders that one range is tested for.
  struct StackSlice {
    std::size_t begin, end;
  };

  /// Appends the clear ranges of [from, to] to clear_: tests these intruders, and cuts the range if some are
  /// undecided and none blocks it. `known_end`: an end of a clear range, at or outside an end of this one; or infinite.
  void search(double from, double to, StackSlice tested, double known_end);
  /// The verdict on an intruder, or on a part. If it is undecided, `undecided` gets its number, or those of its
  /// undecided parts. If many parts are undecided, the rest is not tested, but appended: narrower ranges decide.
  ClearanceVerdict test(std::uint32_t number, const Range& range, Numbers& undecided);
  /// The verdict on one convex set, or bound of several. Counts its cost as that of the intruder `whole`.
  ClearanceVerdict counted_verdict(const Intruder<D>& intruder, std::uint32_t whole, const Range& range);
  /// Searches the parts of a range: split at the end that an intruder causes, if one is guessed. Near a known end, it
  /// is split at the geometric mean of the distances from that end; else in the middle.
  void cut(double from, double to, StackSlice tested, double known_end);
  /// The end that the first of these intruders causes, if it causes one.
  std::optional<double> guessed_end(double from, double to, StackSlice tested);
  /// A range of this width that leaves one of these intruders undecided is not cut further.
  double give_up_width(StackSlice tested) const;

  // Outlines and prisms only:

  /// Whether a test of the parts of an undecided intruder, or part, is worth its cost.
  bool is_worth_dividing(std::uint32_t number, const Range& range);
  /// test() of all parts.
  ClearanceVerdict test_parts(std::uint32_t number, const Range& range, Numbers& undecided);
  /// The first verdict of its parts that is not clear; the parts are not kept.
  ClearanceVerdict verdict_on_parts(const Intruder<D>& intruder, std::uint32_t whole, const Range& range);
  /// Searches what is between the turns that certainly touch an intruder, if some are known. Whether it has searched
  /// all.
  bool search_between_touching_turns(double from, double to, StackSlice tested);

  const Legs& legs_;
  Steps step_;
  const bool turns_outlines_;
  IntruderParts<D> intruders_;
  double width_ = 0, min_change_ = 0;
  /// Of each intruder and its parts, without those of coarse ranges.
  std::vector<std::uint64_t> evaluations_;
  std::uint64_t all_evaluations_ = 0;
  Numbers undecided_;  ///< a stack: the undecided intruders of each enclosing range
  Numbers found_;      ///< scratch of search(): what one intruder leaves undecided
  std::vector<KRange> clear_;
};

}  // namespace foresee
