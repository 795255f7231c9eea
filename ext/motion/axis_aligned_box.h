// Axis-aligned boxes, extents around a position, and bounds that are rounded outward.
#pragma once

#include <cmath>
#include <limits>

#include "motion/motion.h"

namespace foresee {

template <int D>
struct Box {
  Vec<D> lower;
  Vec<D> upper;

  static Box empty() {
    const double inf = std::numeric_limits<double>::infinity();
    return {Vec<D>::constant(inf), Vec<D>::constant(-inf)};
  }
  bool is_empty() const { return !(lower <= upper).all(); }
  /// Whether the closed boxes intersect: boxes that touch do.
  bool meets(const Box& other) const { return (lower <= other.upper).all() && (other.lower <= upper).all(); }
};

/// The bounding box of a shape relative to its position: its reach below and above on each axis. The position
/// need not be the middle, and may lie outside.
template <int D>
struct Extents {
  Vec<D> lower, upper;

  /// The extents of a point.
  static Extents none() { return {Vec<D>::zero(), Vec<D>::zero()}; }
};

/// Extents of equal reach to both sides.
template <int D>
Extents<D> symmetric(const Vec<D>& half) {
  return {-half, half};
}

/// Grown by `margin` on both sides of every axis.
template <int D>
Extents<D> grown(const Extents<D>& extents, const Vec<D>& margin) {
  return {extents.lower - margin, extents.upper + margin};
}

/// The reach of the farther side.
template <int D>
Vec<D> reach_of(const Extents<D>& extents) {
  return extents.lower.abs().max(extents.upper.abs());
}

struct Ends {
  double lower, upper;
};

/// [lower - below, upper + above], rounded outward; infinite where no double holds it.
inline Ends grown(double lower, double upper, double below, double above) {
  constexpr double u = 0x1p-53, inf = std::numeric_limits<double>::infinity();
  const double more_below = below + 8 * u * std::abs(below), more_above = above + 8 * u * std::abs(above);
  const double low = lower - more_below, high = upper + more_above;
  const double safe_low = low - (4 * u * std::abs(low) + 0x1p-1022);
  const double safe_high = high + (4 * u * std::abs(high) + 0x1p-1022);
  const bool sound = std::isfinite(lower) && std::isfinite(upper) && std::isfinite(more_below + more_above);
  return {sound && std::isfinite(safe_low) ? safe_low : -inf,
          sound && std::isfinite(safe_high) ? safe_high : inf};
}

}  // namespace foresee
