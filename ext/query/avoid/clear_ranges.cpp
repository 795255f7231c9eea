#include "query/avoid/clear_ranges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "contact/clearance/blocked_range_end.h"
#include "contact/clearance/separation.h"
#include "numbers/correct_rounding.h"

namespace foresee {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();
/// In degrees: hardly any near object is clear of all courses of a wider arc.
constexpr double widest_arc = 45;
/// In degrees: in a narrower one, rounding errors are not small beside the narrowest ranges.
constexpr double min_width_for_closed_form = 1;
/// Undecided, of one intruder.
constexpr std::size_t many_parts = 64;

template <int D>
bool has_turning_outlines(const std::vector<IntruderCertificate<D>>& intruders) {
  return std::any_of(intruders.begin(), intruders.end(),
                     [](const IntruderCertificate<D>& one) { return one.is_around_turns(); });
}

/// The turns of a range that are not known to touch.
class TurnGaps {
 public:
  struct Gap {
    double from, to;
    double near;  ///< a known end beside it, or infinite
    TurnsBetween turns;
  };

  TurnGaps(double from, double to) { add(from, to, nowhere); }

  const std::vector<Gap>& gaps() const { return gaps_; }

  /// Takes out the turns that touch, and those within `aside` of them.
  void take_out(const TouchingTurns& touching, double aside) {
    const double first = touching.from - aside, last = touching.to + aside;
    if (gaps_.empty() || !(first < gaps_.back().to && last > gaps_.front().from)) return;
    before_.swap(gaps_);
    gaps_.clear();
    for (const Gap& gap : before_) {
      if (!(first < gap.to && last > gap.from)) {
        gaps_.push_back(gap);
        continue;
      }
      if (first > gap.from) add(gap.from, first, gap.near <= gap.from ? gap.near : touching.from);
      if (last < gap.to) add(last, gap.to, touching.to);
    }
  }

 private:
  void add(double from, double to, double near) {
    gaps_.push_back({from, to, near, {quick_sine_cosine(from), quick_sine_cosine(to)}});
  }

  std::vector<Gap> gaps_, before_;
};

}  // namespace

template <int D>
ClearRanges<D>::ClearRanges(const Legs& legs, std::vector<IntruderCertificate<D>> intruders,
                            Interrupt& interrupt)
    : legs_(legs),
      step_(interrupt),
      turns_outlines_(legs[0]->turns() && has_turning_outlines(intruders)),
      intruders_(std::move(intruders), step_) {}

template <int D>
std::vector<KRange> ClearRanges<D>::find(double lo, double hi) {
  width_ = hi - lo;
  min_change_ = 0;
  for (const auto& leg : legs_) min_change_ = std::max(min_change_, leg->min_change(lo, hi));
  clear_.clear();
  const std::size_t all = intruders_.count_of_wholes();
  open_.resize(all);
  std::iota(open_.begin(), open_.end(), 0U);
  evaluations_.assign(all, 0);
  const int parts = legs_[0]->turns() ? static_cast<int>(std::ceil(width_ / widest_arc)) : 1;
  const auto part_start = [&](int part) { return lo + part * (width_ / parts); };
  for (int part = 0; part < parts; ++part)
    search(part_start(part), part + 1 < parts ? part_start(part + 1) : hi, 0, all, nowhere);
  return std::move(clear_);
}

/// The usual end is found in some hundred evaluations; a grazing path takes hundreds of thousands.
template <int D>
double ClearRanges<D>::narrowest(std::size_t begin, std::size_t end) const {
  constexpr std::uint64_t usual = 1 << 20;
  double share = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint64_t own = evaluations_[intruders_.whole_of(open_[i])];
    const bool many = own >= 4 * usual || all_evaluations_ >= 16 * usual;
    share = std::max(share, many ? 0x1p-12 : own >= usual ? 0x1p-22 : 0x1p-40);
  }
  return std::max(min_change_, width_ * share);
}

template <int D>
ClearanceVerdict ClearRanges<D>::certify(const IntruderCertificate<D>& intruder, std::uint32_t whole,
                                         const Range& range) {
  const auto [verdict, evaluations] = intruder.certify(range.family(intruder));
  step_.costly(static_cast<unsigned>((16 + intruder.corners()) * (1 + evaluations)));
  if (!range.is_coarse) evaluations_[whole] += evaluations, all_evaluations_ += evaluations;
  return verdict;
}

template <int D>
bool ClearRanges<D>::blocks(std::uint32_t intruder, const Range& range, std::size_t first) {
  const IntruderCertificate<D>& one = intruders_[intruder];
  const std::uint32_t whole = intruders_.whole_of(intruder);
  ClearanceVerdict verdict = certify(one, whole, range);
  if (verdict == ClearanceVerdict::open && one.has_parts() && is_worth_dividing(intruder, range)) {
    if (intruders_.is_divided(intruder) || !intruders_.is_full())
      return any_part_blocks(intruder, range, first);
    verdict = certify_parts(one, whole, range);
  }
  if (verdict == ClearanceVerdict::open) open_.push_back(intruder);
  return verdict == ClearanceVerdict::blocked;
}

template <int D>
void ClearRanges<D>::search(double from, double to, std::size_t begin, std::size_t end, double near) {
  const Range range(legs_, from, to, begin == 0);
  const std::size_t first_open = open_.size();
  for (std::size_t i = begin; i < end; ++i) {
    if (!blocks(open_[i], range, open_.size())) continue;
    std::swap(open_[i], open_[begin]);  // it probably blocks the next range too
    open_.resize(first_open);
    return;
  }
  const std::size_t last_open = open_.size();
  const double middle = from + 0.5 * (to - from);
  if (last_open == first_open) {
    if (!clear_.empty() && clear_.back().to == from)
      clear_.back().to = to;
    else
      clear_.push_back({from, to});
  } else if (to - from > narrowest(first_open, last_open) && from < middle && middle < to) {
    if (!range.is_coarse || !turns_outlines_ || !search_beside_touching(from, to, first_open, last_open))
      cut(from, to, first_open, last_open, near);
  }
  open_.resize(first_open);
}

template <int D>
void ClearRanges<D>::cut(double from, double to, std::size_t begin, std::size_t end, double near) {
  const double min_width = narrowest(begin, end), aside = 0.25 * min_width;
  const auto found = guessed_end(from, to, begin, end);
  // Beside a known end another guess may be noise: it must reduce the range.
  const double margin = near == nowhere ? 0 : std::max(4 * min_width, 0.125 * (to - from));
  if (found && from + margin < *found - aside && *found + aside < to - margin) {
    search(from, *found - aside, begin, end, *found);
    search(*found - aside, *found + aside, begin, end, *found);
    search(*found + aside, to, begin, end, *found);
    return;
  }
  double middle = from + 0.5 * (to - from);
  const double first = std::max(std::abs(from - near), min_width),
               last = std::max(std::abs(to - near), min_width);
  // The geometric mean of the distances from the known end. Ranges of a set that rotates are proven up to larger
  // widths (IntruderCertificate::turns()), so there the farther part is smaller.
  const auto between_distances = [&](double nearer, double farther) {
    const double mean = std::sqrt(nearer) * std::sqrt(farther);
    return intruders_[open_[begin]].turns()
               ? std::sqrt(std::sqrt(mean) * std::sqrt(farther)) * std::sqrt(farther)
               : mean;
  };
  if (near <= from && last > 8 * first) middle = near + between_distances(first, last);
  if (near >= to && first > 8 * last) middle = near - between_distances(last, first);
  if (!(from < middle && middle < to)) return;
  search(from, middle, begin, end, near);
  search(middle, to, begin, end, near);
}

/// The end that the first open intruder causes, if it causes one.
template <int D>
std::optional<double> ClearRanges<D>::guessed_end(double from, double to, std::size_t begin,
                                                  std::size_t end) {
  constexpr std::size_t few = 2;
  const IntruderCertificate<D>& intruder = intruders_[open_[begin]];
  if (end - begin > few || intruder.has_parts()) return std::nullopt;
  const Changes& leg = *legs_[intruder.leg()];
  const auto distance_at = [&](double k) {
    return intruder.touches_at_change() ? opening_rate_of<D>(intruder.encounter(), leg, k)
                                        : gap_of<D>(intruder.encounter_at(k), leg, k);
  };
  return end_between(distance_at, from, to, 0.25 * narrowest(begin, end));
}

// Outlines and prisms.

template <int D>
bool ClearRanges<D>::is_worth_dividing(std::uint32_t intruder, const Range& range) {
  const IntruderCertificate<D>& one = intruders_[intruder];
  return (intruders_.is_divided(intruder) && one.is_around_turns()) ||
         one.is_worth_splitting(range.family(one));
}

template <int D>
bool ClearRanges<D>::any_part_blocks(std::uint32_t intruder, const Range& range, std::size_t first) {
  const auto [begin, end] = intruders_.parts_of(intruder);
  for (std::uint32_t part = begin; part < end; ++part) {
    if (open_.size() - first >= many_parts)
      open_.push_back(part);
    else if (blocks(part, range, first))
      return true;
  }
  return false;
}

template <int D>
ClearanceVerdict ClearRanges<D>::certify_parts(const IntruderCertificate<D>& intruder, std::uint32_t whole,
                                               const Range& range) {
  for (const IntruderCertificate<D>& part : intruder.parts()) {
    ClearanceVerdict verdict = certify(part, whole, range);
    if (verdict == ClearanceVerdict::open && part.is_worth_splitting(range.family(part)))
      verdict = certify_parts(part, whole, range);
    if (verdict != ClearanceVerdict::clear) return verdict;
  }
  return ClearanceVerdict::clear;
}

/// The nearest come first: they leave small gaps, which hardly any farther one touches.
template <int D>
bool ClearRanges<D>::search_beside_touching(double from, double to, std::size_t begin, std::size_t end) {
  if (D != 2 || width_ < min_width_for_closed_form) return false;
  const double aside = 0.25 * narrowest(begin, end);
  TurnGaps left(from, to);
  const auto& gaps = left.gaps();
  const TrajectoryEstimate<D> own = legs_[0]->template estimate<D>(0);
  for (std::size_t i = begin; i < end; ++i) {
    const IntruderCertificate<D>& whole = intruders_[open_[i]];
    if (!whole.is_around_turns() || intruders_.is_full()) continue;
    step_.costly(16);
    const auto may_touch = [&](const TurnGaps::Gap& gap) {
      return disc_may_touch<D>(whole.encounter(), own, gap.turns);
    };
    if (std::none_of(gaps.begin(), gaps.end(), may_touch) || !whole.is_sole()) continue;
    const IntruderCertificate<D>& part = intruders_[intruders_.parts_of(open_[i]).begin];
    for (const TouchingTurns& touching : touching_turns<D>(part.encounter_at(0), own))
      for (const double circle : {-360.0, 0.0, 360.0}) {
        left.take_out({touching.from + circle, touching.to + circle}, aside);
        if (gaps.empty()) return true;
      }
  }
  if (gaps.size() == 1 && gaps[0].from == from && gaps[0].to == to) return false;
  for (const TurnGaps::Gap& gap : gaps) search(gap.from, gap.to, begin, end, gap.near);
  return true;
}

template class ClearRanges<1>;
template class ClearRanges<2>;
template class ClearRanges<3>;

}  // namespace foresee
