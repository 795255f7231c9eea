#include "geography/zone.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "base/number_text.h"
#include "geography/geodesic_edge.h"
#include "geography/plane.h"
#include "shape/outline/validity.h"
#include "shape/outline/wkt.h"

namespace foresee {
namespace {

/// "(7.9 53.9)"
std::string shown_corner(const Corner& corner) {
  return '(' + shown(corner) + ')';
}

LatLon place_of(const Corner& corner) {
  return canonical_place({corner.y, corner.x});
}

bool is_on_date_line(const Corner& corner) {
  return std::abs(corner.x) == 180;
}

void require_on_earth(const Corner& corner) {
  if (!(std::abs(corner.y) <= 90))
    throw Error("corner " + shown_corner(corner) + " has latitude " + shown(corner.y) +
                ", beyond 90; write longitude, then latitude");
  if (!(std::abs(corner.x) <= 180))
    throw Error("corner " + shown_corner(corner) + " has longitude " + shown(corner.x) +
                ", beyond 180; write " + shown(std::remainder(corner.x, 360)));
}

void require_within_reach(const Corner& corner, double distance, const LatLon& origin) {
  if (distance > max_distance_from_origin)
    throw Error("corner " + shown_corner(corner) + " is " + shown(std::ceil(distance / 1000)) +
                " km from the origin '" + shown(origin.lat) + ' ' + shown(origin.lon) +
                "'; write longitude first, and an origin within 1500 km");
}

/// Both ends are one place, and a reader means a line around the Earth.
void require_no_parallel(const Corner& a, const Corner& b) {
  if (std::abs(a.x - b.x) == 360 && a.y == b.y && std::abs(a.y) != 90)
    throw Error("edge (" + shown(a) + ", " + shown(b) +
                ") has no length: edges are shortest lines; write corners between its ends");
}

/// Projects ring by ring and remembers, for each corner of the plane, the corner that starts its edge.
class ZoneProjection {
 public:
  ZoneProjection(const Outline& degrees, const LatLon& origin, Interrupt& interrupt)
      : degrees_(degrees), origin_(origin), steps_(interrupt) {}

  Outline plane() {
    for (std::size_t part = 0, ring = 0; part < degrees_.parts(); ++part)
      for (const std::size_t first = ring; ring < degrees_.part_start(part + 1); ++ring) {
        ring == first ? plane_.begin_part() : plane_.begin_hole();
        add_ring(ring);
      }
    if (const auto flaw = flaw_of(plane_)) refuse(*flaw);
    return std::move(plane_);
  }

 private:
  void add_ring(std::size_t ring) {
    const std::span<const Corner> corners = degrees_.ring(ring);
    const std::size_t start = degrees_.ring_start(ring);
    for (const Corner& corner : corners) require_on_earth(corner);
    std::vector<Corner> points;
    points.reserve(corners.size());
    for (const Corner& corner : corners) {
      points.push_back(on_plane(place_of(corner)));
      require_within_reach(corner, std::hypot(points.back().x, points.back().y), origin_);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t next = (i + 1) % corners.size();
      require_no_parallel(corners[i], corners[next]);
      add(points[i], start + i);
      add_between(corners[i], corners[next], points[i], points[next], start + i);
      if (plane_.corners().size() > max_corners)
        throw Error("more than " + std::to_string(max_corners) +
                    " corners, with those that keep long edges straight on the Earth: simplify the zone");
    }
    if (plane_.close_ring()) starts_.pop_back();
  }

  /// Adds the corners that a long edge needs.
  void add_between(const Corner& a, const Corner& b, const Corner& from, const Corner& to,
                   std::size_t start) {
    const double reach = std::max(std::hypot(from.x, from.y), std::hypot(to.x, to.y));
    if (is_short_edge(std::hypot(from.x - to.x, from.y - to.y), reach)) return;
    for (const LatLon& place : cut_edge(place_of(a), place_of(b), reach)) add(on_plane(place), start);
  }

  Corner on_plane(const LatLon& place) {
    steps_.costly(1000);
    const OnPlane point = to_plane({place, {}}, origin_);
    return {point.x, point.y};
  }

  void add(const Corner& point, std::size_t start) {
    const std::size_t before = plane_.corners().size();
    plane_.add(point);
    // A repeated place: its edge starts at the later corner.
    if (plane_.corners().size() == before) starts_.pop_back();
    starts_.push_back(static_cast<std::uint32_t>(start));
  }

  /// The edge of the degrees that starts at this corner.
  std::pair<Corner, Corner> edge(std::uint32_t start) const {
    std::size_t ring = 0;
    while (degrees_.ring_start(ring + 1) <= start) ++ring;
    const bool last = start + 1 == degrees_.ring_start(ring + 1);
    return {degrees_.corners()[start], degrees_.corners()[last ? degrees_.ring_start(ring) : start + 1]};
  }

  /// Whether the two edges lie on the date line, one written with 180 and one with -180.
  bool meet_on_date_line(std::uint32_t a, std::uint32_t b) const {
    const auto [a0, a1] = edge(a);
    const auto [b0, b1] = edge(b);
    return is_on_date_line(a0) && is_on_date_line(a1) && is_on_date_line(b0) && is_on_date_line(b1) &&
           a0.x == a1.x && b0.x == b1.x && a0.x != b0.x;
  }

  /// Throws what is wrong, with the corners as they were written.
  [[noreturn]] void refuse(Flaw flaw) const {
    const bool two_edges = flaw.kind == Flaw::Kind::cross || flaw.kind == Flaw::Kind::overlap;
    flaw.a = starts_[flaw.a], flaw.b = starts_[std::min<std::size_t>(flaw.b, starts_.size() - 1)];
    if (two_edges && meet_on_date_line(flaw.a, flaw.b))
      throw Error("parts meet along the date line; write them as one polygon that passes from 179 to -179");
    const LatLon place = from_plane({flaw.place.x, flaw.place.y, {}}, origin_).place;
    const auto rounded = [](double degrees) { return std::round(degrees * 1e7) / 1e7 + 0.0; };
    flaw.place = {rounded(place.lon), rounded(place.lat)};
    throw Error(shown(flaw, degrees_));
  }

  const Outline& degrees_;
  LatLon origin_;
  Outline plane_;
  std::vector<std::uint32_t> starts_;
  Steps steps_;
};

}  // namespace

Outline zone_on_plane(const Outline& degrees, const LatLon& origin, Interrupt& interrupt) {
  const FloatEnvironment environment;
  return ZoneProjection(degrees, origin, interrupt).plane();
}

Zone read_zone(std::string_view text, const LatLon& origin, Interrupt& interrupt) {
  Zone zone{read_outline(text, WktUnit::degrees), {}};
  zone.plane = zone_on_plane(zone.degrees, origin, interrupt);
  return zone;
}

}  // namespace foresee
