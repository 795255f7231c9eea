// Proof that a plane separates an object from all changed motions of another during an interval of time.
//
// It is the proof of every clear range (separation.h); all rounding errors are included.
#pragma once

#include "contact/clearance/trajectory_family.h"
#include "numbers/double_double.h"

namespace foresee {

/// A larger gap is not lost to underflow.
inline constexpr double min_gap = 0x1p-960;
/// The squares of shorter normals would underflow.
inline constexpr double min_normal = 0x1p-400;

/// c0 + c1 tau + c2 tau^2 > 0 throughout [begin, end]; false if doubles cannot decide it.
inline bool surely_positive(double c0, double c1, double c2, double begin, double end) {
  const auto above = [&](double tau) {
    const double size = std::abs(c0) + tau * (std::abs(c1) + tau * std::abs(c2));
    return c0 + tau * (c1 + tau * c2) > 8 * unit_roundoff * size + min_gap;
  };
  if (!above(begin) || !above(end)) return false;
  if (!(c2 > 0) || !(c1 < 0) || -c1 <= 2 * c2 * begin || -c1 >= 2 * c2 * end) return true;
  const double dip = c1 * (c1 / (4 * c2));
  return c0 - dip > 8 * unit_roundoff * (std::abs(c0) + dip) + min_gap;
}

/// Lower bound of n (other) - n (own) over all of `own`.
template <int D>
double min_of(const Vec<D>& n, const Vec<D>& other, const Vec<D>& error, const VectorSet<D>& own) {
  const double along = (n * other).sum(), support = own.support(n);
  return along - support -
         ((n.abs() * (error + 8 * unit_roundoff * other.abs())).sum() +
          4 * unit_roundoff * std::abs(support));
}

/// Whether a plane of normal n separates the two throughout [begin, end], for every change: a proof.
template <int D>
bool plane_proves(const Encounter<D>& encounter, const MotionSet<D>& all, const Vec<D>& n, double begin,
                  double end) {
  if (!(n.abs().maxCoeff() >= min_normal)) return false;
  double inflation = 0;  // in x and y
  if constexpr (D > 1)
    if (encounter.inflation > 0)
      inflation = encounter.inflation * (std::abs(n[0]) + std::abs(n[1])) * (1 + 0x1p-50);
  const double reach = encounter.extents.support(n) + inflation,
               growth = encounter.extents.grows ? encounter.extents.growth.support(n) : 0;
  const double c0 = min_of<D>(n, encounter.x, encounter.ex, all.place) - reach;
  const double v = min_of<D>(n, encounter.v, encounter.ev, all.velocity);
  const double c1 = growth == 0 ? v : v - growth - 4 * unit_roundoff * (std::abs(v) + growth);
  const double c2 = 0.5 * min_of<D>(n, encounter.a, Vec<D>(Vec<D>::Zero()), all.acceleration);
  return surely_positive(c0 - 4 * unit_roundoff * (std::abs(c0) + std::abs(reach)), c1, c2, begin, end);
}

}  // namespace foresee
