// The start and end of an interval of contact as correctly rounded doubles (Ziv's test,
// numbers/crossed_root.h).
//
// Each end is a root of a constraint's polynomial. One Newton step from the middle of the root's enclosure,
// with the value in DoubleDouble and a bound on the error, gives the rounded root. Rounding is monotone, so
// each root is rounded separately and the latest start, or the earliest end, is chosen after that. The result
// is NaN where the bound does not decide the rounding.
#pragma once

#include <algorithm>
#include <optional>

#include "contact/certain/crossing.h"
#include "contact/pieces/pair_tests.h"
#include "contact/set/relative_motion.h"

namespace foresee {

/// `Traits`: what the pieces are (pair_context.h).
template <class Traits>
class EndpointRounding {
  static constexpr int D = Traits::axes, Degree = Traits::degree;
  using PieceConstraint = typename Traits::PieceConstraint;
  template <class T>
  using Sizes = typename Traits::template Sizes<T>;

 public:
  EndpointRounding(const Setup& setup, const double* row_a, const double* row_b,
                   const CertainMotion<D>& certain, const Sizes<Bounded>& sizes, const PairLifetime& lifetime,
                   const UncertainInterval& queried)
      : setup_(setup),
        row_a_(row_a),
        row_b_(row_b),
        certain_(certain),
        lifetime_(lifetime),
        queried_(queried),
        sizes_(sizes) {}

  /// The start. Requires: the interval is certain, and `ends` are its candidates.
  Instant begin(const UncertainInterval& interval, std::span<const EndpointCandidate<PieceConstraint>> ends) {
    Instant begin{-UncertainInterval::inf, -UncertainInterval::inf};
    if (queried_.begin.meets(interval.begin)) begin = {lifetime_.dt_start, lifetime_.t_start};
    for (const EndpointCandidate<PieceConstraint>& end : ends)
      if (end.direction == CrossingDirection::entering)
        begin = later(begin, instant<CrossingDirection::entering>(end));
    return begin.dt > -UncertainInterval::inf ? begin : unknown_instant();
  }
  Instant end(const UncertainInterval& interval, std::span<const EndpointCandidate<PieceConstraint>> ends) {
    Instant last{UncertainInterval::inf, UncertainInterval::inf};
    if (queried_.end.meets(interval.end)) last = {lifetime_.dt_end, lifetime_.t_end};
    for (const EndpointCandidate<PieceConstraint>& end : ends)
      if (end.direction == CrossingDirection::leaving)
        last = earlier(last, instant<CrossingDirection::leaving>(end));
    return last.dt < UncertainInterval::inf ? last : unknown_instant();
  }

 private:
  template <CrossingDirection direction>
  Instant instant(const EndpointCandidate<PieceConstraint>& end) {
    const double width = (end.at.high - end.at.low) * (1 + 4 * unit_roundoff);
    const double base = std::clamp(end.at.low + 0.5 * width, 0.0, queried_.end.high);
    const auto place = place_at(base);
    const DoubleDouble value = with_polynomial<0>(end.constraint, place, expanded_at(*fine_sizes_, base),
                                                  [](const auto& p) { return p[0]; });
    return with_polynomial<Degree>(
        end.constraint, expanded_at<Degree>(certain_, base), expanded_at(sizes_, base), [&](const auto& p) {
          const double lost = certain_.underflow + 0x1p-1060, slope = p[1].value;
          // DoubleDouble loses at most 2^-97 of what the double bound counts in 2^-53.
          const double error = p[0].error_bound(lost) * 0x1p-44 + certain_.underflow;
          const double span = std::max(width, 2 * std::abs(value.high / slope));
          return root_of<direction>({value, error, slope, p[1].error_bound(lost), bend(p, lost, span)},
                                    setup_.horizon.now, base, width);
        });
  }

  /// An upper bound on |p''| / 2 over `span`.
  template <std::size_t N>
  static double bend(const std::array<Bounded, N>& p, double lost, double span) {
    double bend = 0, weight = 1;
    for (std::size_t k = 2; k < N; ++k, weight *= span)
      bend += weight * static_cast<double>(k * (k - 1)) * (std::abs(p[k].value) + p[k].error_bound(lost));
    return bend;
  }

  std::array<Coefficients<DoubleDouble, 0>, D> place_at(double tau) {
    if (!fine_sizes_) {
      fine_sizes_ = Traits::template sizes_of<DoubleDouble>(setup_, row_a_, row_b_);
      relative_ = relative_motion_of<DoubleDouble, D>(setup_, row_a_, row_b_);
    }
    std::array<Coefficients<DoubleDouble, 0>, D> place;
    const DoubleDouble t{tau, 0};
    for (std::size_t j = 0; j < D; ++j)
      place[j][0] = relative_.x[j] + t * (relative_.v[j] + t * relative_.a[j]);
    return place;
  }

  const Setup& setup_;
  const double *row_a_, *row_b_;
  const CertainMotion<D>& certain_;
  const PairLifetime& lifetime_;
  const UncertainInterval& queried_;
  const Sizes<Bounded>& sizes_;
  std::optional<Sizes<DoubleDouble>> fine_sizes_;  ///< with relative_: computed when first needed
  RelativeMotion<DoubleDouble, D> relative_;
};

}  // namespace foresee
