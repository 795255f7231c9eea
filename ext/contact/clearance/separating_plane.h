// Does a plane stand between an object and all the changed motions of another, throughout some moments? The
// proof that avoidance rests on (separation.h), with every rounding counted.
#pragma once

#include "contact/clearance/trajectory_family.h"
#include "numbers/double_double.h"

namespace foresee {

/// Nothing is lost to underflow that is larger.
inline constexpr double min_gap = 0x1p-960;
/// The squares of shorter normals would vanish.
inline constexpr double min_normal = 0x1p-400;

/// c0 + c1 tau + c2 tau^2 > 0 throughout [begin, end]; false where doubles do not tell.
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

/// n (other) - most of n (own), from below.
template <int D>
double min_of(const Vec<D>& n, const Vec<D>& other, const Vec<D>& error, const VectorSet<D>& own) {
  const double along = (n * other).sum(), most = own.support(n);
  return along - most -
         ((n.abs() * (error + 8 * unit_roundoff * other.abs())).sum() + 4 * unit_roundoff * std::abs(most));
}

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
