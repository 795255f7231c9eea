#include "query/avoid/range_bisection.h"

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
/// In degrees: in a narrower one, rounding errors are not small relative to the narrowest ranges.
constexpr double min_width_for_closed_form = 1;
/// Undecided, of one intruder.
constexpr std::size_t many_parts = 64;

template <int D>
bool has_turning_outlines(const std::vector<Intruder<D>>& intruders) {
  return std::any_of(intruders.begin(), intruders.end(),
                     [](const Intruder<D>& one) { return one.is_around_turns(); });
}

/// The turns of a range that are not known to touch.
class TurnGaps {
 public:
  struct Gap {
    double from, to;
    double known_end;  ///< as in search()
    TurnsBetween turns;
  };

  TurnGaps(double from, double to) { add(from, to, nowhere); }

  const std::vector<Gap>& gaps() const { return gaps_; }

  /// Removes the turns that touch, and those within `aside` of them.
  void cut_out(const TouchingTurns& touching, double aside) {
    const double first = touching.from - aside, last = touching.to + aside;
    if (gaps_.empty() || !(first < gaps_.back().to && last > gaps_.front().from)) return;
    before_.swap(gaps_);
    gaps_.clear();
    for (const Gap& gap : before_) {
      if (!(first < gap.to && last > gap.from)) {
        gaps_.push_back(gap);
        continue;
      }
      if (first > gap.from) add(gap.from, first, gap.known_end <= gap.from ? gap.known_end : touching.from);
      if (last < gap.to) add(last, gap.to, touching.to);
    }
  }

 private:
  void add(double from, double to, double known_end) {
    gaps_.push_back({from, to, known_end, {quick_sine_cosine(from), quick_sine_cosine(to)}});
  }

  std::vector<Gap> gaps_, before_;
};

}  // namespace

template <int D>
RangeBisection<D>::RangeBisection(const Legs& legs, std::vector<Intruder<D>> intruders, Interrupt& interrupt)
    : legs_(legs),
      step_(interrupt),
      turns_outlines_(legs[0]->turns() && has_turning_outlines(intruders)),
      intruders_(std::move(intruders), step_) {}

template <int D>
std::vector<KRange> RangeBisection<D>::clear_ranges(double lo, double hi) {
  width_ = hi - lo;
  min_change_ = 0;
  for (const auto& leg : legs_) min_change_ = std::max(min_change_, leg->min_change(lo, hi));
  clear_.clear();
  const std::size_t all = intruders_.count_of_wholes();
  undecided_.resize(all);
  std::iota(undecided_.begin(), undecided_.end(), 0U);
  evaluations_.assign(all, 0);
  const int parts = legs_[0]->turns() ? static_cast<int>(std::ceil(width_ / widest_arc)) : 1;
  const auto part_start = [&](int part) { return lo + part * (width_ / parts); };
  for (int part = 0; part < parts; ++part)
    search(part_start(part), part + 1 < parts ? part_start(part + 1) : hi, {0, all}, nowhere);
  return std::move(clear_);
}

template <int D>
void RangeBisection<D>::search(double from, double to, StackSlice tested, double known_end) {
  const bool is_coarse = tested.begin == 0;  // at the bottom of the stack are all intruders
  const Range range(legs_, from, to, is_coarse);
  const std::size_t begin = undecided_.size();
  for (std::size_t i = tested.begin; i < tested.end; ++i) {
    found_.clear();
    if (test(undecided_[i], range, found_) == ClearanceVerdict::blocked) {
      std::swap(undecided_[i], undecided_[tested.begin]);  // it probably blocks the next range too
      undecided_.resize(begin);
      return;
    }
    for (const std::uint32_t number : found_) undecided_.push_back(number);
  }
  const StackSlice left{begin, undecided_.size()};
  const double middle = from + 0.5 * (to - from);
  if (left.begin == left.end) {
    if (!clear_.empty() && clear_.back().to == from)
      clear_.back().to = to;
    else
      clear_.push_back({from, to});
  } else if (to - from > give_up_width(left) && from < middle && middle < to) {
    if (!range.is_coarse || !turns_outlines_ || !search_between_touching_turns(from, to, left))
      cut(from, to, left, known_end);
  }
  undecided_.resize(begin);
}

template <int D>
ClearanceVerdict RangeBisection<D>::test(std::uint32_t number, const Range& range, Numbers& undecided) {
  const Intruder<D>& intruder = intruders_[number];
  const std::uint32_t whole = intruders_.whole_of(number);
  ClearanceVerdict verdict = counted_verdict(intruder, whole, range);
  if (verdict == ClearanceVerdict::undecided && intruder.has_parts() && is_worth_dividing(number, range)) {
    if (intruders_.is_divided(number) || !intruders_.is_full()) return test_parts(number, range, undecided);
    verdict = verdict_on_parts(intruder, whole, range);
  }
  if (verdict == ClearanceVerdict::undecided) undecided.push_back(number);
  return verdict;
}

template <int D>
ClearanceVerdict RangeBisection<D>::counted_verdict(const Intruder<D>& intruder, std::uint32_t whole,
                                                    const Range& range) {
  const auto [verdict, evaluations] = intruder.verdict_on(range.family(intruder));
  step_.costly(static_cast<unsigned>((16 + intruder.corners()) * (1 + evaluations)));
  if (range.is_coarse) return verdict;
  evaluations_[whole] += evaluations;
  all_evaluations_ += evaluations;
  return verdict;
}

template <int D>
void RangeBisection<D>::cut(double from, double to, StackSlice tested, double known_end) {
  const double min_width = give_up_width(tested), aside = 0.25 * min_width;
  const auto found = guessed_end(from, to, tested);
  // Near a known end another guess may be noise: it must reduce the range.
  const double margin = known_end == nowhere ? 0 : std::max(4 * min_width, 0.125 * (to - from));
  if (found && from + margin < *found - aside && *found + aside < to - margin) {
    search(from, *found - aside, tested, *found);
    search(*found - aside, *found + aside, tested, *found);
    search(*found + aside, to, tested, *found);
    return;
  }
  double middle = from + 0.5 * (to - from);
  const double first = std::max(std::abs(from - known_end), min_width),
               last = std::max(std::abs(to - known_end), min_width);
  // The geometric mean of the distances from the known end. Ranges of a set that rotates are proven up to larger
  // widths (Intruder::rotates()), so there the farther part is smaller.
  const auto between_distances = [&](double nearer, double farther) {
    const double mean = std::sqrt(nearer) * std::sqrt(farther);
    return intruders_[undecided_[tested.begin]].rotates()
               ? std::sqrt(std::sqrt(mean) * std::sqrt(farther)) * std::sqrt(farther)
               : mean;
  };
  if (known_end <= from && last > 8 * first) middle = known_end + between_distances(first, last);
  if (known_end >= to && first > 8 * last) middle = known_end - between_distances(last, first);
  if (!(from < middle && middle < to)) return;
  search(from, middle, tested, known_end);
  search(middle, to, tested, known_end);
}

template <int D>
std::optional<double> RangeBisection<D>::guessed_end(double from, double to, StackSlice tested) {
  constexpr std::size_t few = 2;
  const Intruder<D>& intruder = intruders_[undecided_[tested.begin]];
  if (tested.end - tested.begin > few || intruder.has_parts()) return std::nullopt;
  const Changes& leg = *legs_[intruder.leg()];
  const auto distance_at = [&](double k) {
    return intruder.touches_at_start() ? opening_rate_of<D>(intruder.encounter(), leg, k)
                                       : gap_of<D>(intruder.encounter_at(k), leg, k);
  };
  return end_between(distance_at, from, to, 0.25 * give_up_width(tested));
}

/// The usual end is found in some hundred evaluations; a grazing path takes hundreds of thousands.
template <int D>
double RangeBisection<D>::give_up_width(StackSlice tested) const {
  constexpr std::uint64_t usual = 1 << 20;
  double share = 0;
  for (std::size_t i = tested.begin; i < tested.end; ++i) {
    const std::uint64_t own = evaluations_[intruders_.whole_of(undecided_[i])];
    const bool many = own >= 4 * usual || all_evaluations_ >= 16 * usual;
    share = std::max(share, many ? 0x1p-12 : own >= usual ? 0x1p-22 : 0x1p-40);
  }
  return std::max(min_change_, width_ * share);
}

// Outlines and prisms.

template <int D>
bool RangeBisection<D>::is_worth_dividing(std::uint32_t number, const Range& range) {
  const Intruder<D>& intruder = intruders_[number];
  return (intruders_.is_divided(number) && intruder.is_around_turns()) ||
         intruder.is_worth_splitting(range.family(intruder));
}

template <int D>
ClearanceVerdict RangeBisection<D>::test_parts(std::uint32_t number, const Range& range, Numbers& undecided) {
  const std::size_t before = undecided.size();
  const auto [begin, end] = intruders_.parts_of(number);
  for (std::uint32_t part = begin; part < end; ++part) {
    if (undecided.size() >= many_parts)
      undecided.push_back(part);
    else if (test(part, range, undecided) == ClearanceVerdict::blocked)
      return ClearanceVerdict::blocked;
  }
  return undecided.size() == before ? ClearanceVerdict::clear : ClearanceVerdict::undecided;
}

template <int D>
ClearanceVerdict RangeBisection<D>::verdict_on_parts(const Intruder<D>& intruder, std::uint32_t whole,
                                                     const Range& range) {
  for (const Intruder<D>& part : intruder.parts()) {
    ClearanceVerdict verdict = counted_verdict(part, whole, range);
    if (verdict == ClearanceVerdict::undecided && part.is_worth_splitting(range.family(part)))
      verdict = verdict_on_parts(part, whole, range);
    if (verdict != ClearanceVerdict::clear) return verdict;
  }
  return ClearanceVerdict::clear;
}

/// The nearest come first: they leave small gaps, which hardly any farther one touches.
template <int D>
bool RangeBisection<D>::search_between_touching_turns(double from, double to, StackSlice tested) {
  if (D != 2 || width_ < min_width_for_closed_form) return false;
  const double aside = 0.25 * give_up_width(tested);
  TurnGaps left(from, to);
  const auto& gaps = left.gaps();
  const TrajectoryEstimate<D> own = legs_[0]->template estimate<D>(0);
  for (std::size_t i = tested.begin; i < tested.end; ++i) {
    const Intruder<D>& whole = intruders_[undecided_[i]];
    if (!whole.is_around_turns() || intruders_.is_full()) continue;
    step_.costly(16);
    const auto may_touch = [&](const TurnGaps::Gap& gap) {
      return disc_may_touch<D>(whole.encounter(), own, gap.turns);
    };
    if (std::none_of(gaps.begin(), gaps.end(), may_touch) || !whole.is_sole()) continue;
    const Intruder<D>& part = intruders_[intruders_.parts_of(undecided_[i]).begin];
    for (const TouchingTurns& touching : touching_turns<D>(part.encounter_at(0), own))
      for (const double circle : {-360.0, 0.0, 360.0}) {
        left.cut_out({touching.from + circle, touching.to + circle}, aside);
        if (gaps.empty()) return true;
      }
  }
  if (gaps.size() == 1 && gaps[0].from == from && gaps[0].to == to) return false;
  for (const TurnGaps::Gap& gap : gaps) search(gap.from, gap.to, tested, gap.known_end);
  return true;
}

template class RangeBisection<1>;
template class RangeBisection<2>;
template class RangeBisection<3>;

}  // namespace foresee
