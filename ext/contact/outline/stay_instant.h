// The instant at which a stay begins or ends, rounded once: the roots of its conditions there, each by one
// Newton step from the middle of its enclosure, with the value in DoubleDouble and an error radius (Ziv's
// test, numbers/crossed_root.h). Rounding keeps order, so each root is rounded apart. What this cannot tell
// is NaN.
#pragma once

#include <algorithm>
#include <optional>

#include "contact/certain/crossing.h"
#include "contact/outline/piece_tests.h"

namespace foresee::contact {

template <int D, int Degree>
class StayInstants {
 public:
  StayInstants(const Setup& setup, const double* row_a, const double* row_b, const CertainMotion<D>& certain,
               const Moments& moments, const Stay& asked)
      : setup_(setup), row_a_(row_a), row_b_(row_b), certain_(certain), moments_(moments), asked_(asked) {}

  /// Requires: the stay is certain, and these are its ends.
  Instant begin(const Stay& stay, std::span<const StayEnd> ends) {
    Instant begin{-Stay::inf, -Stay::inf};
    if (asked_.begin.meets(stay.begin)) begin = {moments_.dt_begin, moments_.t_begin};
    for (const StayEnd& end : ends)
      if (end.way == Way::in) begin = later(begin, instant<Way::in>(end));
    return begin;
  }
  Instant end(const Stay& stay, std::span<const StayEnd> ends) {
    Instant last{Stay::inf, Stay::inf};
    if (asked_.end.meets(stay.end)) last = {moments_.dt_end, moments_.t_end};
    for (const StayEnd& end : ends)
      if (end.way == Way::out) last = earlier(last, instant<Way::out>(end));
    return last;
  }

 private:
  template <Way way>
  Instant instant(const StayEnd& end) {
    const double base = std::clamp(end.at.low + 0.5 * (end.at.high - end.at.low), 0.0, asked_.end.high);
    const double width = (end.at.high - end.at.low) * (1 + 4 * unit_roundoff);
    Powers<Bounded, Degree> x[D];
    Powers<DoubleDouble, 0> place[D];
    const auto& relative = this->relative();
    for (int j = 0; j < D; ++j) {
      const AxisView<> view = view_from<Degree>(certain_.axis[j], base, certain_.underflow);
      x[j][0] = {view.p, view.ep}, x[j][1] = {view.q, view.eq};
      if constexpr (Degree > 1) x[j][2] = {view.a, view.ea};
      const DoubleDouble tau{base, 0};
      place[j][0] = relative.x[j] + tau * (relative.v[j] + tau * relative.a[j]);
    }
    const Powers<Bounded, Degree> p = polynomial_of<Degree>(end.condition, x, half_height<Bounded>());
    const DoubleDouble value = polynomial_of<0>(end.condition, place, half_height<DoubleDouble>())[0];
    // DoubleDouble loses at most 2^-97 of what the double bound counts in 2^-53.
    const double lost = certain_.underflow + 0x1p-1060;
    double bend = 0;
    if constexpr (Degree > 1) bend = std::abs(p[2].value) + p[2].error_bound(lost);
    return root_of<way>({value, p[0].error_bound(lost) * 0x1p-44 + certain_.underflow, p[1].value,
                         p[1].error_bound(lost), bend},
                        setup_.horizon.now, base, width);
  }

  template <class T>
  T half_height() const {
    return D < 3 ? T{} : half_height_of<T>(setup_, row_a_, row_b_);
  }

  const RelativeMotion<DoubleDouble, D>& relative() {
    if (!relative_) relative_ = relative_motion_of<DoubleDouble, D>(setup_, row_a_, row_b_);
    return *relative_;
  }

  const Setup& setup_;
  const double *row_a_, *row_b_;
  const CertainMotion<D>& certain_;
  const Moments& moments_;
  const Stay& asked_;
  std::optional<RelativeMotion<DoubleDouble, D>> relative_;
};

}  // namespace foresee::contact
