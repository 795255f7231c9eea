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

#include "contact/certified/pair_context.h"
#include "contact/certified/pair_tests.h"
#include "contact/minkowski/relative_motion.h"

namespace foresee {

/// `Traits`: what the pieces are (pair_context.h).
template <class Traits>
class EndpointRounding {
  static constexpr int D = Traits::axes, Degree = Traits::degree;
  using PieceConstraint = typename Traits::PieceConstraint;
  template <class T>
  using Sizes = typename Traits::template Sizes<T>;

 public:
  /// The context must outlive this.
  explicit EndpointRounding(const PairContext<Traits>& context) : context_(context) {}

  /// The start. Requires: the interval is certain, and `ends` are its candidates.
  Instant begin(const UncertainInterval& interval, std::span<const EndpointCandidate<PieceConstraint>> ends) {
    Instant begin{-unbounded, -unbounded};
    if (context_.queried.begin.meets(interval.begin)) begin = context_.lifetime.start();
    for (const EndpointCandidate<PieceConstraint>& end : ends)
      if (end.direction == CrossingDirection::entering)
        begin = later(begin, instant<CrossingDirection::entering>(end));
    return begin.dt > -unbounded ? begin : unknown_instant();
  }
  Instant end(const UncertainInterval& interval, std::span<const EndpointCandidate<PieceConstraint>> ends) {
    Instant last{unbounded, unbounded};
    if (context_.queried.end.meets(interval.end)) last = context_.lifetime.end();
    for (const EndpointCandidate<PieceConstraint>& end : ends)
      if (end.direction == CrossingDirection::leaving)
        last = earlier(last, instant<CrossingDirection::leaving>(end));
    return last.dt < unbounded ? last : unknown_instant();
  }

 private:
  template <CrossingDirection direction>
  Instant instant(const EndpointCandidate<PieceConstraint>& end) {
    const double width = (end.at.high - end.at.low) * (1 + 4 * unit_roundoff);
    const double base = std::clamp(end.at.low + 0.5 * width, 0.0, context_.queried.end.high);
    const auto place = place_at(base);
    const DoubleDouble value = with_polynomial<0>(end.constraint, place, expanded_at(*fine_sizes_, base),
                                                  [](const auto& p) { return p[0]; });
    return with_polynomial<Degree>(end.constraint, expanded_at<Degree>(context_.relative, base),
                                   expanded_at(context_.sizes, base), [&](const auto& p) {
                                     return rounded_crossing<direction>(p, value, context_.relative.underflow,
                                                                        context_.setup.horizon.now, base,
                                                                        width);
                                   });
  }

  std::array<Coefficients<DoubleDouble, 0>, D> place_at(double tau) {
    if (!fine_sizes_) {
      fine_sizes_.emplace(Traits::template sizes_of<DoubleDouble>(context_.setup, context_.row_a,
                                                                  context_.row_b, context_.a));
      relative_ = relative_motion_of<DoubleDouble, D>(context_.setup, context_.row_a, context_.row_b);
    }
    std::array<Coefficients<DoubleDouble, 0>, D> place;
    const DoubleDouble t{tau, 0};
    for (std::size_t j = 0; j < D; ++j)
      place[j][0] = relative_[j][0] + t * (relative_[j][1] + t * relative_[j][2]);
    return place;
  }

  const PairContext<Traits>& context_;
  std::optional<Sizes<DoubleDouble>> fine_sizes_;  ///< with relative_: computed when first needed
  RelativeMotion<DoubleDouble, D> relative_;
};

}  // namespace foresee
