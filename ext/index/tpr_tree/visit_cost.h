// Cost model of a TPR-tree: the expected number of queries that visit given bounds, for the choice of
// children and splits.
//
// A window of side `query` meets a box of widths w with probability proportional to the product of w + query.
// The product is integrated over the tree's look-ahead, which starts at the clock (Saltenis et al. 2000). The
// side of the query comes from the TPR*-tree (Tao et al. 2003) and keeps flat boxes comparable. Simpson's
// rule with three times is exact for uniform motion in one to three axes. Unbounded widths count as very
// wide; every cost is a finite number.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "index/tpr_tree/bounds.h"

namespace foresee {

template <int D>
class VisitCost {
 public:
  /// The cost of bounds at `epoch`.
  VisitCost(double clock, double duration, double epoch) {
    for (int i = 0; i < 3; ++i)
      elapsed_[static_cast<std::size_t>(i)] =
          std::clamp(std::abs(clock + 0.5 * i * duration - epoch), 1e-100, 1e100);
  }

  double operator()(const Bounds<D>& bounds, double query) const {
    const Vec<D> x = bounds.x_upper - bounds.x_lower + query, v = bounds.v_upper - bounds.v_lower,
                 a = (bounds.a_upper - bounds.a_lower) * 0.5;
    auto product = [&](double s) { return within_reason(x + s * (v + s * a)).prod(); };
    return product(elapsed_[0]) + 4 * product(elapsed_[1]) + product(elapsed_[2]);
  }

  /// The mean width over the axes, at half the look-ahead.
  double mean_width(const Bounds<D>& bounds) const {
    const double s = elapsed_[1];
    const Vec<D> widths = (bounds.x_upper - bounds.x_lower) + s * (bounds.v_upper - bounds.v_lower) +
                          (0.5 * s * s) * (bounds.a_upper - bounds.a_lower);
    return within_reason(widths).sum() / D;
  }

  /// Seconds between the epoch and half the look-ahead.
  double middle() const { return elapsed_[1]; }
  /// Seconds between the epoch and the start (0), middle (1) or end (2) of the look-ahead.
  double elapsed(int time) const { return elapsed_[static_cast<std::size_t>(time)]; }

  /// Stored bounds may be arbitrary: negative and NaN widths are replaced.
  static double within_reason(double width) { return width < widest ? (width > 0 ? width : 0) : widest; }

 private:
  static constexpr double widest = 1e100;  // its cube is finite

  static Vec<D> within_reason(const Vec<D>& widths) {
    return (widths < widest).select(widths.max(0.0), widest);
  }

  std::array<double, 3> elapsed_;
};

}  // namespace foresee
