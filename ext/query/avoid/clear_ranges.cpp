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
/// How many intruders keep their parts, a kilobyte each.
constexpr std::size_t max_split = 1 << 15;

}  // namespace

template <int D>
ClearRanges<D>::ClearRanges(const Legs& legs, std::vector<IntruderCertificate<D>> intruders,
                            Interrupt& interrupt)
    : legs_(legs), intruders_(std::move(intruders)), step_(interrupt) {}

template <int D>
std::vector<KRange> ClearRanges<D>::between(double lo, double hi) {
  width_ = hi - lo;
  min_change_ = 0;
  for (const auto& leg : legs_) min_change_ = std::max(min_change_, leg->min_change(lo, hi));
  clear_.clear();
  const std::size_t all = intruders_.size();
  open_.resize(all);
  std::iota(open_.begin(), open_.end(), 0U);
  whole_ = open_;
  evaluations_.assign(all, 0);
  const int parts = legs_[0]->turns() ? static_cast<int>(std::ceil(width_ / widest_arc)) : 1;
  const auto part_start = [&](int part) { return lo + part * (width_ / parts); };
  for (int part = 0; part < parts; ++part)
    search(part_start(part), part + 1 < parts ? part_start(part + 1) : hi, 0, all, nowhere);
  return std::move(clear_);
}

/// The usual end is found in some hundred evaluations; a grazing path takes hundreds of thousands.
template <int D>
double ClearRanges<D>::narrowest(std::uint32_t intruder) const {
  constexpr std::uint64_t usual = 1 << 20;
  const std::uint64_t own = evaluations_[whole_[intruder]];
  const bool many = own >= 4 * usual || all_evaluations_ >= 16 * usual;
  return std::max(min_change_, width_ * (many ? 0x1p-12 : own >= usual ? 0x1p-22 : 0x1p-40));
}

template <int D>
double ClearRanges<D>::narrowest(std::size_t begin, std::size_t end) const {
  double widest = 0;
  for (std::size_t i = begin; i < end; ++i) widest = std::max(widest, narrowest(open_[i]));
  return widest;
}

template <int D>
std::pair<std::uint32_t, std::uint32_t> ClearRanges<D>::parts_of(std::uint32_t intruder) {
  const auto found = parts_.find(intruder);
  if (found != parts_.end()) return found->second;
  std::vector<IntruderCertificate<D>> parts = intruders_[intruder].parts();
  for (const IntruderCertificate<D>& part : parts) step_.costly(static_cast<unsigned>(part.corners()));
  const auto begin = static_cast<std::uint32_t>(intruders_.size());
  for (IntruderCertificate<D>& part : parts) intruders_.push_back(std::move(part));
  whole_.resize(intruders_.size(), whole_[intruder]);
  return parts_[intruder] = {begin, static_cast<std::uint32_t>(intruders_.size())};
}

template <int D>
ClearanceVerdict ClearRanges<D>::certify(const IntruderCertificate<D>& intruder, std::uint32_t whole,
                                         const Range& range) {
  std::uint64_t evaluations = 0;
  const ClearanceVerdict verdict = intruder.certify(range.family(intruder), evaluations);
  step_.costly(static_cast<unsigned>((16 + intruder.corners()) * (1 + evaluations)));
  if (!range.is_first) evaluations_[whole] += evaluations, all_evaluations_ += evaluations;
  return verdict;
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

template <int D>
bool ClearRanges<D>::blocks(std::uint32_t intruder, const Range& range, std::size_t first) {
  const std::uint32_t whole = whole_[intruder];
  ClearanceVerdict verdict = certify(intruders_[intruder], whole, range);
  const bool known = verdict == ClearanceVerdict::open && parts_.count(intruder) > 0;
  const bool is_split = verdict == ClearanceVerdict::open &&
                        ((known && intruders_[intruder].is_around_turns()) ||
                         intruders_[intruder].is_worth_splitting(range.family(intruders_[intruder])));
  const bool kept = is_split && (parts_.size() < max_split || known);
  if (is_split && !kept) verdict = certify_parts(intruders_[intruder], whole, range);
  if (verdict == ClearanceVerdict::open && !kept) open_.push_back(intruder);
  if (!kept) return verdict == ClearanceVerdict::blocked;
  const auto [begin, end] = parts_of(intruder);
  for (std::uint32_t part = begin; part < end; ++part) {
    if (open_.size() - first >= many_parts)
      open_.push_back(part);
    else if (blocks(part, range, first))
      return true;
  }
  return false;
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
    if (!range.is_first || !search_beside_touching(from, to, first_open, last_open))
      cut(from, to, first_open, last_open, near);
  }
  open_.resize(first_open);
}

/// The nearest come first: they leave small gaps, which hardly any farther one touches.
template <int D>
bool ClearRanges<D>::search_beside_touching(double from, double to, std::size_t begin, std::size_t end) {
  if (D != 2 || !legs_[0]->turns() || width_ < min_width_for_closed_form) return false;
  struct Gap {
    double from, to, near;
    TurnsBetween turns;
  };
  const double aside = 0.25 * narrowest(begin, end);
  const auto gap_of = [](double first, double last, double near) {
    return Gap{first, last, near, {quick_sine_cosine(first), quick_sine_cosine(last)}};
  };
  std::vector<Gap> gaps, left;
  const TrajectoryEstimate<D> own = legs_[0]->template estimate<D>(0);
  for (std::size_t i = begin; i < end; ++i) {
    const IntruderCertificate<D>& whole = intruders_[open_[i]];
    if (!whole.is_around_turns() || parts_.size() >= max_split) continue;
    step_.costly(16);
    if (gaps.empty()) gaps.push_back(gap_of(from, to, nowhere));
    const auto may_touch = [&](const Gap& gap) {
      return disc_may_touch<D>(whole.encounter(), own, gap.turns);
    };
    if (std::none_of(gaps.begin(), gaps.end(), may_touch) || !whole.is_sole()) continue;
    const IntruderCertificate<D>& part = intruders_[parts_of(open_[i]).first];
    for (const TouchingTurns& touching : touching_turns<D>(part.encounter_at(0), own))
      for (const double circle : {-360.0, 0.0, 360.0}) {
        const double first = touching.from + circle - aside, last = touching.to + circle + aside;
        if (!(first < to && last > from)) continue;
        left.clear();
        for (const Gap& gap : gaps) {
          if (!(first < gap.to && last > gap.from)) {
            left.push_back(gap);
            continue;
          }
          if (first > gap.from)
            left.push_back(gap_of(gap.from, first, gap.near <= gap.from ? gap.near : touching.from + circle));
          if (last < gap.to) left.push_back(gap_of(last, gap.to, touching.to + circle));
        }
        gaps.swap(left);
        if (gaps.empty()) return true;
      }
  }
  if (gaps.empty() || (gaps.size() == 1 && gaps[0].from == from && gaps[0].to == to)) return false;
  for (const Gap& gap : gaps) search(gap.from, gap.to, begin, end, gap.near);
  return true;
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
                                                  std::size_t end) const {
  constexpr std::size_t few = 2;
  const IntruderCertificate<D>& intruder = intruders_[open_[begin]];
  if (end - begin > few || intruder.has_parts()) return std::nullopt;
  const Changes& leg = *legs_[intruder.leg()];
  const auto distance_at = [&](double k) {
    return intruder.touches_first() ? opening_rate_of<D>(intruder.encounter(), leg, k)
                                    : gap_of<D>(intruder.encounter_at(k), leg, k);
  };
  return end_between(distance_at, from, to, 0.25 * narrowest(begin, end));
}

template class ClearRanges<1>;
template class ClearRanges<2>;
template class ClearRanges<3>;

}  // namespace foresee
