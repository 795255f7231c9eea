// The ranges of changes that are clear of all intruders: certificates and bisection.
//
//   ClearRanges<2> search(changed.legs, certificates, interrupt);
//   for (const KRange& range : search.find(-180, 180)) …
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

#include "query/avoid/intruder_certificate.h"

namespace foresee {

struct KRange {
  double from, to;
};

template <int D>
class ClearRanges {
 public:
  using Legs = std::vector<std::unique_ptr<Changes>>;

  /// The intruders are tested in their order: the nearest should be first. An object that several legs meet is several
  /// intruders.
  ClearRanges(const Legs& legs, std::vector<IntruderCertificate<D>> intruders, Interrupt& interrupt);

  /// Requires: lo < hi.
  std::vector<KRange> find(double lo, double hi);

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

    const TrajectoryFamily<D>& family(const IntruderCertificate<D>& intruder) const {
      const std::size_t leg = intruder.leg();
      if (leg == 0) return of_first_leg_;
      const auto known = of_later_legs_.find(leg);
      if (known != of_later_legs_.end()) return known->second;
      return of_later_legs_.emplace(leg, trajectory_family<D>(*legs_[leg], from, to)).first->second;
    }

    const double from, to;
    const bool is_coarse;  ///< one of the parts of the whole, beside which all intruders are tested

   private:
    const Legs& legs_;
    TrajectoryFamily<D> of_first_leg_;
    mutable std::unordered_map<std::size_t, TrajectoryFamily<D>> of_later_legs_;
  };
  /// `near`: a known end beside the range, or infinite.
  void search(double from, double to, std::size_t begin, std::size_t end, double near);
  /// Whether the intruder blocks all of the range. It is appended to open_ if it is undecided, or its undecided parts
  /// are, from index `first` on. If many are undecided, the rest is not tested: narrower ranges decide.
  bool blocks(std::uint32_t intruder, const Range& range, std::size_t first);
  /// The verdict on one intruder, or on a part of the intruder `whole`; counts its cost.
  ClearanceVerdict certify(const IntruderCertificate<D>& intruder, std::uint32_t whole, const Range& range);
  /// Splits a range: at the end that an intruder causes, if one is guessed. Near a known end, it splits at
  /// the geometric mean of the distances from that end; else in the middle.
  void cut(double from, double to, std::size_t begin, std::size_t end, double near);
  std::optional<double> guessed_end(double from, double to, std::size_t begin, std::size_t end);
  /// The largest width at which a range is given up that one of these intruders of open_ leaves open.
  double narrowest(std::size_t begin, std::size_t end) const;

  // Outlines and prisms only:

  /// Whether a test of the parts of an undecided intruder, or part, is worth its cost.
  bool is_worth_dividing(std::uint32_t intruder, const Range& range);
  bool any_part_blocks(std::uint32_t intruder, const Range& range, std::size_t first);
  /// The first verdict of its parts that is not clear; the parts are not kept.
  ClearanceVerdict certify_parts(const IntruderCertificate<D>& intruder, std::uint32_t whole,
                                 const Range& range);
  /// Searches beside the turns that certainly touch an intruder, if some are known. Whether it has searched all.
  bool search_beside_touching(double from, double to, std::size_t begin, std::size_t end);

  const Legs& legs_;
  Steps step_;
  const bool turns_outlines_;
  IntruderParts<D> intruders_;
  double width_ = 0, min_change_ = 0;
  std::vector<std::uint64_t>
      evaluations_;  ///< of each intruder and its parts, without those of coarse ranges
  std::uint64_t all_evaluations_ = 0;
  std::vector<std::uint32_t> open_;  ///< a stack: the undecided intruders of each enclosing range
  std::vector<KRange> clear_;
};

}  // namespace foresee
