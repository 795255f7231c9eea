#include "geography/geodesic_edge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geography/ellipsoid.h"

namespace foresee {
namespace {

/// The largest curvature of the ellipsoid, at the equator: 1 / (M N) = 1 / b^2 with M = a (1 - e^2), N = a.
constexpr double largest_curvature = 1 / (semi_minor * semi_minor);

/// The number of equal pieces, by the bound of the header.
int pieces_of(double length, double from_origin) {
  constexpr double deviation = 1;  // metres
  const double bend = 1.1 * 2 / 3 * largest_curvature * from_origin;
  return std::max(1, static_cast<int>(std::ceil(length * std::sqrt(bend / (8 * deviation)))));
}

}  // namespace

LatLon canonical_place(const LatLon& place) {
  if (std::abs(place.lat) == 90) return {place.lat, 0};
  const double lon = std::remainder(place.lon, 360);
  return {place.lat + 0.0, lon == -180 ? 180 : lon + 0.0};
}

bool is_short_edge(double length, double from_origin) {
  return pieces_of(length, from_origin) == 1;
}

std::vector<LatLon> cut_edge(const LatLon& a, const LatLon& b, double from_origin) {
  const auto key = [](const LatLon& place) { return std::pair(place.lat, place.lon); };
  const bool reversed = key(b) < key(a);
  const LatLon &from = reversed ? b : a, &to = reversed ? a : b;
  const Geodesic line = geodesic_between(from, to);
  const int pieces = pieces_of(line.distance, from_origin);
  std::vector<LatLon> between;
  between.reserve(static_cast<std::size_t>(pieces - 1));
  for (int i = 1; i < pieces; ++i)
    between.push_back(geodesic_from(from, line.azimuth, line.distance * i / pieces).place);
  if (reversed) std::reverse(between.begin(), between.end());
  return between;
}

}  // namespace foresee
