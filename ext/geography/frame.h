// Coordinate frame of a table: plain metres, or latitude and longitude on the plane about an origin or on the globe.
//
//   const Frame frame{.kind = FrameKind::degrees, .origin = LatLon{53.9, 7.9}, .unit = SpeedUnit::knots};
//   const Metres stored = frame.to_metres({{{53.99, 7.85}, {{14, 91}}}});   // 14 knots; the bits of geo_to_plane
//   const Flight report = frame.from_metres(stored);                    // report.fix.course->speed in knots
//   const Flight read = frame.shown(stored);                            // as the table's columns show it
//   frame_conflict("ships", frame, "zones", {}) != ""                   // "ships has lat, lon, zones has …"
//
// Speeds are in the unit of the frame. TableReader::frame() is that of a table; origin is empty in a table in degrees
// that takes the first stored position as its origin and has none yet. Cost: that of geography/plane.h and globe.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geography/globe.h"
#include "geography/plane.h"

namespace foresee {

enum class FrameKind : std::uint8_t {
  plane,    ///< metres, as the user projected them
  degrees,  ///< latitude and longitude, stored on the plane about the origin
  globe,    ///< latitude and longitude, stored as geocentric metres
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

/// A report as a table stores it: on the plane x, y and the height, without acceleration; on the globe as to_globe().
using Metres = OnGlobe;

struct Frame {
  FrameKind kind = FrameKind::plane;
  std::string text = {};              ///< of a plane: what CREATE says of it, as in frame = 'harbour'
  std::optional<LatLon> origin = {};  ///< of degrees: see above
  SpeedUnit unit = SpeedUnit::mps;

  /// Whether the table has lat, lon.
  bool in_degrees() const { return kind != FrameKind::plane; }
  bool on_globe() const { return kind == FrameKind::globe; }
  /// The axes that lat, lon and, on the globe, the height are stored on.
  std::size_t axes_of_place() const { return on_globe() ? 3 : 2; }
  /// Whether the first position stored chooses the origin.
  bool chooses_origin() const { return kind == FrameKind::degrees && !origin; }
  /// Whether a stored position is known to be a place on the Earth.
  bool knows_places() const { return in_degrees() && !chooses_origin(); }

  /// The stored numbers of a report whose speed is in `unit`. Requires: knows_places(). Throws as to_plane, to_globe.
  Metres to_metres(const Flight& report) const;
  /// Place, height, climb, speed in `unit`, and course in [0, 360); NaN for the course of an object at rest. Requires:
  /// knows_places(). Throws as from_plane, from_globe.
  Flight from_metres(const Metres& point) const;
  /// The same as the columns of a table show it: rounded().
  Flight shown(const Metres& point) const;

  /// 'plane', 'degrees', 'globe', or the table's own text: column `frame` of foresee_tables.
  std::string name() const;

  friend bool operator==(const Frame& a, const Frame& b) {
    return a.kind == b.kind && a.text == b.text && a.unit == b.unit && same_origin(a, b);
  }
  friend bool same_origin(const Frame& a, const Frame& b) {
    if (!a.origin || !b.origin) return !a.origin && !b.origin;
    // One notation of the date line. At a pole the longitude counts: it turns the axes of the plane.
    const auto lon_of = [](const Frame& one) { return one.origin->lon == -180 ? 180 : one.origin->lon; };
    return a.origin->lat == b.origin->lat && lon_of(a) == lon_of(b);
  }
};

/// Reports with few decimals are read back as they were written. A place within 2e-12 of a number with 9 decimals
/// becomes that number. So does a speed, within 2e-12 and 4e-13 of itself, and a course within 2e-11 of one with 6. A
/// longitude is in (-180, 180], a course in [0, 360).
/// On the globe a height within 3e-8 m (far above it, 4e-15 of itself) of a number with 6 decimals becomes that number.
Fix rounded(const Fix& fix);

/// "53.9 7.9".
std::string origin_text(const LatLon& origin);
/// Nothing unless the text is a latitude within 90 and a longitude within 180 degrees, with a space between.
std::optional<LatLon> parse_origin(std::string_view text);
/// The origin of a table whose first position this is: rounded to a tenth of a degree, the date line as 180.
LatLon origin_near(const LatLon& place);

/// "" if objects of the two tables may be compared. Else an error that names both and says what to write. Two speed
/// units, equal texts and an origin that is not chosen yet are no conflict.
std::string frame_conflict(const std::string& table, const Frame& frame, const std::string& other,
                           const Frame& frame_of_other);

}  // namespace foresee
