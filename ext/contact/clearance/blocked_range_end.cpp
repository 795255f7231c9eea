#include "contact/clearance/blocked_range_end.h"

#include <algorithm>

#include "contact/clearance/straight_approach.h"

namespace foresee {

template <int D>
SignedDistance gap_of(const Encounter<D>& encounter, const Changes& changes, double k) {
  const TrajectoryEstimate<D> path = relative(encounter, changes.estimate<D>(k));
  if ((path.a != 0).any() || !(path.begin <= path.end)) return std::nullopt;
  return straight_approach<D>(encounter.extents, path.x, path.v, path.begin, path.end).gap;
}

template <int D>
SignedDistance opening_rate_of(const Encounter<D>& encounter, const Changes& changes, double k) {
  const TrajectoryEstimate<D> path = relative(encounter, changes.estimate<D>(k));
  if ((path.a != 0).any() || encounter.extents.grows || encounter.extents.sum) return std::nullopt;
  return (encounter.x * path.v).sum();
}

std::optional<double> end_between(const std::function<SignedDistance(double)>& distance_at, double p,
                                  double q, double width) {
  double low = p, high = q;
  const SignedDistance at_p = distance_at(p), at_q = at_p ? distance_at(q) : std::nullopt;
  if (!at_q || (*at_p > 0) == (*at_q > 0)) return std::nullopt;
  double low_gap = *at_p, high_gap = *at_q;
  // Regula falsi with the retained end halved (Illinois); steps of half the width close the bracket.
  for (int evaluation = 0, side = 0; high - low > width; ++evaluation) {
    if (evaluation == 60) return std::nullopt;
    double k = low + (high - low) * (low_gap / (low_gap - high_gap));
    if (evaluation % 8 == 7) k = low + 0.5 * (high - low);
    k = std::clamp(k, low + 0.5 * width, high - 0.5 * width);
    if (!(k > low && k < high)) return std::nullopt;
    const SignedDistance gap = distance_at(k);
    if (!gap) return std::nullopt;
    const int now = (*gap > 0) == (low_gap > 0) ? -1 : 1;
    (now < 0 ? low : high) = k, (now < 0 ? low_gap : high_gap) = *gap;
    if (now == side) (now < 0 ? high_gap : low_gap) *= 0.5;
    side = now;
  }
  return low + 0.5 * (high - low);
}

template SignedDistance gap_of<1>(const Encounter<1>&, const Changes&, double);
template SignedDistance gap_of<2>(const Encounter<2>&, const Changes&, double);
template SignedDistance gap_of<3>(const Encounter<3>&, const Changes&, double);
template SignedDistance opening_rate_of<1>(const Encounter<1>&, const Changes&, double);
template SignedDistance opening_rate_of<2>(const Encounter<2>&, const Changes&, double);
template SignedDistance opening_rate_of<3>(const Encounter<3>&, const Changes&, double);

}  // namespace foresee
