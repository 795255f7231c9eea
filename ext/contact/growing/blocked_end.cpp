#include "contact/growing/blocked_end.h"

#include <algorithm>

#include "contact/growing/straight_approach.h"

namespace foresee {

template <int D>
Clearance gap_of(const Encounter<D>& met, const OwnMotion& base, const Change& change, double k) {
  const RoughWay<D> way = relative(met, rough_way<D>(base, change, k));
  if ((way.a != 0).any() || !(way.begin <= way.end)) return std::nullopt;
  return straight_approach<D>(met.extents, way.x, way.v, way.begin, way.end).gap;
}

template <int D>
Clearance parting_of(const Encounter<D>& met, const OwnMotion& base, const Change& change, double k) {
  const RoughWay<D> way = relative(met, rough_way<D>(base, change, k));
  if ((way.a != 0).any() || met.extents.grows || met.extents.sum) return std::nullopt;
  return (met.x * way.v).sum();
}

std::optional<double> end_between(const std::function<Clearance(double)>& clearance_at, double p, double q,
                                  double width) {
  double low = p, high = q;
  const Clearance at_p = clearance_at(p), at_q = at_p ? clearance_at(q) : std::nullopt;
  if (!at_q || (*at_p > 0) == (*at_q > 0)) return std::nullopt;
  double low_gap = *at_p, high_gap = *at_q;
  // Regula falsi, the end that stays halved (Illinois); steps of half the width close the bracket.
  for (int look = 0, side = 0; high - low > width; ++look) {
    if (look == 60) return std::nullopt;
    double k = low + (high - low) * (low_gap / (low_gap - high_gap));
    if (look % 8 == 7) k = low + 0.5 * (high - low);
    k = std::clamp(k, low + 0.5 * width, high - 0.5 * width);
    if (!(k > low && k < high)) return std::nullopt;
    const Clearance gap = clearance_at(k);
    if (!gap) return std::nullopt;
    const int now = (*gap > 0) == (low_gap > 0) ? -1 : 1;
    (now < 0 ? low : high) = k, (now < 0 ? low_gap : high_gap) = *gap;
    if (now == side) (now < 0 ? high_gap : low_gap) *= 0.5;
    side = now;
  }
  return low + 0.5 * (high - low);
}

template Clearance gap_of<1>(const Encounter<1>&, const OwnMotion&, const Change&, double);
template Clearance gap_of<2>(const Encounter<2>&, const OwnMotion&, const Change&, double);
template Clearance gap_of<3>(const Encounter<3>&, const OwnMotion&, const Change&, double);
template Clearance parting_of<1>(const Encounter<1>&, const OwnMotion&, const Change&, double);
template Clearance parting_of<2>(const Encounter<2>&, const OwnMotion&, const Change&, double);
template Clearance parting_of<3>(const Encounter<3>&, const OwnMotion&, const Change&, double);

}  // namespace foresee
