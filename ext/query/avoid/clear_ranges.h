// Which changes of a range are clear of all intruders? Ranges of k, proven by certificate and halving.
//
//   ClearRanges<2> search(base, change, met, interrupt);
//   for (const KRange& range : search.between(-180, 180)) …
//
// Guarantee: every double of an answered range is clear (contact/clearance/separation.h), with its ends; the
// ranges rise and are apart. What lies between them is not proven clear.
//
// All intruders together go down by halves: a range that is certainly clear of one of them is so for both
// halves, and one that touches anybody is left alone, so that each intruder is looked at only where it
// matters: near the ends that it makes. A range too narrow to halve (2^-40 of all, or what rounding hides) is
// not clear. Where more is in doubt than usual, as along a path that grazes, narrow ranges are given up
// earlier: 2^-22 of all after a million looks, 2^-12 after four. What has parts is looked at part by part
// once that is worth it; so that it takes no more memory than some ten thousand of them, more are made anew
// each time. Cost: one certificate an intruder, some 100 for each end. Memory: four bytes for each intruder
// on the way down.
#pragma once

#include <unordered_map>
#include <utility>
#include <vector>

#include "base/interrupt_steps.h"
#include "query/avoid/intruder_certificate.h"

namespace foresee {

struct KRange {
  double from, to;
};

template <int D>
class ClearRanges {
 public:
  /// The intruders in the order in which they are looked at: near ones first.
  ClearRanges(const OwnMotion& base, const Change& change, std::vector<IntruderCertificate<D>> intruders,
              Interrupt& interrupt);

  /// Requires: lo < hi.
  std::vector<KRange> between(double lo, double hi);

 private:
  struct Range {
    double from, to;
    bool is_first;
    TrajectoryFamily<D> family;
  };
  /// `near`: an end that is known, beside the range, or infinite.
  void search(double from, double to, std::size_t begin, std::size_t end, double near);
  /// Counts what it costs.
  ClearanceVerdict certify(const IntruderCertificate<D>& intruder, const Range& range);
  /// Of its parts the first that is not clear; they are not kept.
  ClearanceVerdict certify_parts(const IntruderCertificate<D>& intruder, const Range& range);
  /// Whether nothing of the range is clear of an intruder; what is left in doubt of it is open, from the
  /// `first` of it on. Where many of its parts are, no more are looked at: shorter ranges tell.
  bool blocks(std::uint32_t intruder, const Range& range, std::size_t first);
  /// Where its parts are among the intruders: made once.
  std::pair<std::uint32_t, std::uint32_t> parts_of(std::uint32_t intruder);
  /// In two: at the end that an intruder makes, if one is guessed; near a known end, where ever less room is
  /// in doubt, at the mean of the distances from it as numbers of digits; else in the middle.
  void cut(double from, double to, std::size_t begin, std::size_t end, double near);
  std::optional<double> guessed_end(double from, double to, std::size_t begin, std::size_t end) const;
  double narrowest() const;

  const OwnMotion& base_;
  Change change_;
  std::vector<IntruderCertificate<D>> intruders_;  ///< then parts of them
  std::unordered_map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>> parts_;
  Steps step_;
  double width_ = 0, min_change_ = 0;
  std::uint64_t evaluations_ = 0;    ///< beyond the first at each intruder
  std::vector<std::uint32_t> open_;  ///< of each range on the way down, its intruders in doubt
  std::vector<KRange> clear_;
};

}  // namespace foresee
