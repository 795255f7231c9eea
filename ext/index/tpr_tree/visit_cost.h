// Cost model of a TPR-tree: the expected number of queries that visit an entry, for the choice of children
// and splits.
//
// A window of side `query` meets a box of widths w with probability proportional to the product of w + query.
// The product is integrated over the tree's look-ahead, which starts at the clock (Saltenis et al. 2000). The
// side of the query comes from the TPR*-tree (Tao et al. 2003) and keeps flat boxes comparable. Simpson's
// rule with three times is exact for uniform motion in one to three axes. Unbounded widths count as very
// wide; every cost is a finite number.
//
// If all objects beneath an entry end, a query visits it only if their times meet. Its cost is then the mean
// product times how far apart the objects are in time, with the duration of a typical query added. The mean is
// over the whole life, unless the lives are current (reference_times.h). An entry without an end costs more
// than any that ends.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "index/tpr_tree/reference_times.h"

namespace foresee {

/// The side of a typical window, and how long it lasts.
struct TypicalQuery {
  double side = 0, duration = 0;
};

template <int D>
class VisitCost {
 public:
  /// The start, middle and end of the time for which the product is integrated, in seconds from the epoch; and
  /// the weight of an entry in time, 1 without an end.
  struct Window {
    std::array<double, 3> elapsed;
    double weight;
  };

  /// The cost of entries whose bounds are at `epoch`, for a look-ahead of `duration`.
  VisitCost(const ReferenceTimes& times, double clock, double duration, double epoch)
      : times_(times), epoch_(epoch) {
    for (int i = 0; i < 3; ++i)
      elapsed_[static_cast<std::size_t>(i)] = elapsed_at(clock + 0.5 * i * duration);
  }

  double operator()(const Entry<D>& entry, const TypicalQuery& query) const {
    const Bounds<D>& bounds = entry.bounds;
    const Vec<D> x = bounds.x_upper - bounds.x_lower + query.side, v = bounds.v_upper - bounds.v_lower,
                 a = (bounds.a_upper - bounds.a_lower) * 0.5;
    auto product = [&](double s) { return within_reason(x + s * (v + s * a)).product(); };
    auto integral = [&](const std::array<double, 3>& at) {
      return product(at[0]) + 4 * product(at[1]) + product(at[2]);
    };
    if (!ends(entry.times)) return integral(elapsed_);
    const Window window = window_of(entry.times, query.duration);
    return integral(window.elapsed) * window.weight;
  }

  /// The sum of these entries' costs.
  double operator()(std::span<const Entry<D>> entries, const TypicalQuery& query) const {
    double sum = 0;
    for (const Entry<D>& entry : entries) sum += (*this)(entry, query);
    return sum;
  }

  /// The query whose side and duration are this fraction of an entry's.
  TypicalQuery query_like(double fraction, const Entry<D>& entry) const {
    return {fraction * mean_width(entry.bounds, entry.times),
            ends(entry.times) ? fraction * spread(entry.times) : 0};
  }

  /// The mean of those of these entries.
  TypicalQuery query_like(double fraction, std::span<const Entry<D>> entries) const {
    TypicalQuery mean;
    const auto count = static_cast<double>(entries.size());
    for (const Entry<D>& entry : entries) {
      const TypicalQuery query = query_like(fraction, entry);
      mean.side += query.side / count, mean.duration += query.duration / count;
    }
    return mean;
  }

  /// The mean width over the axes, at half the look-ahead or in the middle of the lives.
  double mean_width(const Bounds<D>& bounds, const Times& times) const {
    const double s = middle(times);
    const Vec<D> widths = (bounds.x_upper - bounds.x_lower) + s * (bounds.v_upper - bounds.v_lower) +
                          (0.5 * s * s) * (bounds.a_upper - bounds.a_lower);
    return within_reason(widths).sum() / D;
  }

  /// Seconds between the epoch and half the look-ahead, or the middle of the entry's life.
  double middle(const Times& times) const {
    return times_.is_clock(times) ? elapsed_[1] : elapsed_at(times_.of(times));
  }
  const ReferenceTimes& reference_times() const { return times_; }
  /// The window of entries without an end.
  const std::array<double, 3>& endless() const { return elapsed_; }
  /// Without branches: a choice calls it for every child.
  Window window_of(const Times& times, double query_duration) const {
    const double weight = std::clamp(spread(times) + query_duration, 0x1p-300, 0x1p100) * 0x1p-101;
    const bool by_clock = times_.is_clock(times);
    const double middle = middle_of(times);
    return {{by_clock ? elapsed_[0] : elapsed_at(times.t_min), by_clock ? elapsed_[1] : elapsed_at(middle),
             by_clock ? elapsed_[2] : elapsed_at(times.until_max)},
            ends(times) ? weight : 1};
  }

  /// Spread in time of the objects beneath; a time that they share adds no cost.
  static double spread(const Times& times) {
    return std::min(std::max(times.t_max - times.t_min, times.until_max - times.t_max), 1e100);
  }
  /// Stored bounds may be arbitrary: negative and NaN widths are replaced.
  static double within_reason(double width) { return width < widest ? (width > 0 ? width : 0) : widest; }

 private:
  static constexpr double widest = 1e100;  // its cube is finite

  static Vec<D> within_reason(const Vec<D>& widths) {
    return (widths < widest).select(widths.max(0.0), widest);
  }
  double elapsed_at(double time) const { return std::clamp(std::abs(time - epoch_), 1e-100, 1e100); }

  ReferenceTimes times_;
  double epoch_;
  std::array<double, 3> elapsed_;
};

}  // namespace foresee
