// Coordinate frame of a table: plain metres, or latitude and longitude on the plane about an origin.
//
//   const Frame frame{.kind = FrameKind::degrees, .origin = LatLon{53.9, 7.9}, .unit = SpeedUnit::knots};
//   const OnPlane stored = frame.to_plane({{53.99, 7.85}, {{14, 91}}});   // 14 knots; the bits of geo_to_plane
//   const Fix shown = frame.from_plane(stored);                         // shown.course->speed in knots
//   const Fix read = rounded(shown);                                    // as the table's columns show it
//   frame_conflict("ships", frame, "zones", {}) != ""                   // "ships has lat, lon, zones has …"
//
// Speeds are in the unit of the frame. A Store says its frame (Store::frame); origin is empty in a table in degrees
// that takes the first stored position as its origin and has none yet. Cost: that of geography/plane.h.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geography/plane.h"

namespace foresee {

enum class FrameKind : std::uint8_t {
  plane,    ///< metres, as the user projected them
  degrees,  ///< latitude and longitude, stored on the plane about the origin
};

enum class SpeedUnit : std::uint8_t { mps, knots, kmh };

std::string_view name_of(SpeedUnit unit);
std::optional<SpeedUnit> speed_unit_of(std::string_view name);
/// A speed in metres per second: knots are speed * 1852 / 3600, kmh speed / 3.6.
constexpr double to_mps(double speed, SpeedUnit unit) {
  return unit == SpeedUnit::knots ? speed * 1852 / 3600 : unit == SpeedUnit::kmh ? speed / 3.6 : speed;
}
constexpr double from_mps(double speed, SpeedUnit unit) {
  return unit == SpeedUnit::knots ? speed * 3600 / 1852 : unit == SpeedUnit::kmh ? speed * 3.6 : speed;
}

struct Frame {
  FrameKind kind = FrameKind::plane;
  std::string text = {};              ///< of a plane: what CREATE says of it, as in frame = 'harbour'
  std::optional<LatLon> origin = {};  ///< of degrees: see above
  SpeedUnit unit = SpeedUnit::mps;

  bool in_degrees() const { return kind == FrameKind::degrees; }

  /// The stored numbers of a report whose speed is in `unit`. Requires: an origin. Throws as foresee::to_plane.
  OnPlane to_plane(const Fix& fix) const;
  /// Place, speed in `unit`, and course in [0, 360); NaN for the course of an object at rest. Requires: an origin.
  /// Throws as foresee::from_plane.
  Fix from_plane(const OnPlane& point) const;

  /// 'plane', 'degrees', or the table's own text: column `frame` of foresee_tables.
  std::string name() const;

  friend bool operator==(const Frame& a, const Frame& b) {
    return a.kind == b.kind && a.text == b.text && a.unit == b.unit && same_origin(a, b);
  }
  friend bool same_origin(const Frame& a, const Frame& b) {
    if (!a.origin || !b.origin) return !a.origin && !b.origin;
    return a.origin->lat == b.origin->lat && a.origin->lon == b.origin->lon;
  }
};

/// A place or speed within 2e-12 of a number with 9 decimals becomes that number, a course within 2e-11 of one with 6:
/// reports with few decimals are read back as they were written. A longitude is in (-180, 180], a course in [0, 360).
Fix rounded(const Fix& fix);

/// "53.9 7.9".
std::string origin_text(const LatLon& origin);
/// Nothing unless the text is a latitude within 90 and a longitude within 180 degrees, with a space between.
std::optional<LatLon> parse_origin(std::string_view text);
/// The origin of a table whose first position this is: rounded to a tenth of a degree, the date line as 180.
LatLon origin_near(const LatLon& place);

/// The greatest distance of a position from the origin of its table.
inline constexpr double max_distance_from_origin = 1500e3;

/// "" if objects of the two tables may be compared. Else an error that names both and says what to write. Two speed
/// units, equal texts and an origin that is not chosen yet are no conflict.
std::string frame_conflict(const std::string& table, const Frame& frame, const std::string& other,
                           const Frame& frame_of_other);

}  // namespace foresee
