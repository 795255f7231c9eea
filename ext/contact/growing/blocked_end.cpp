#include "contact/growing/blocked_end.h"

#include "contact/growing/straight_approach.h"

namespace foresee::contact {

template <int D>
std::optional<double> end_between(const std::function<const Encounter<D>&(double)>& met_at,
                                  const OwnMotion& base, const Change& change, double p, double q,
                                  double width) {
  constexpr double beyond = 1e300;
  const auto gap_at = [&](double k) {
    const Encounter<D>& met = met_at(k);
    const RoughWay<D> way = relative(met, rough_way<D>(base, change, k));
    if ((way.a != 0).any() || !(way.begin <= way.end)) return beyond;
    return straight_approach<D>(met.extents, way.x, way.v, way.begin, way.end).gap;
  };
  double low = p, high = q, low_gap = gap_at(p), high_gap = gap_at(q);
  if (!(low_gap > 0 ? high_gap <= 0 : high_gap > 0) || std::max(low_gap, high_gap) >= beyond)
    return std::nullopt;
  // Regula falsi, the end that stays halved (Illinois); steps of half the width close the bracket.
  for (int look = 0, side = 0; high - low > width; ++look) {
    if (look == 60) return std::nullopt;
    double k = low + (high - low) * (low_gap / (low_gap - high_gap));
    if (look % 8 == 7) k = low + 0.5 * (high - low);
    k = std::clamp(k, low + 0.5 * width, high - 0.5 * width);
    if (!(k > low && k < high)) return std::nullopt;
    const double gap = gap_at(k);
    if (gap >= beyond) return std::nullopt;
    const int now = (gap > 0) == (low_gap > 0) ? -1 : 1;
    (now < 0 ? low : high) = k, (now < 0 ? low_gap : high_gap) = gap;
    if (now == side) (now < 0 ? high_gap : low_gap) *= 0.5;
    side = now;
  }
  return low + 0.5 * (high - low);
}

template std::optional<double> end_between<1>(const std::function<const Encounter<1>&(double)>&,
                                              const OwnMotion&, const Change&, double, double, double);
template std::optional<double> end_between<2>(const std::function<const Encounter<2>&(double)>&,
                                              const OwnMotion&, const Change&, double, double, double);
template std::optional<double> end_between<3>(const std::function<const Encounter<3>&(double)>&,
                                              const OwnMotion&, const Change&, double, double, double);

}  // namespace foresee::contact
