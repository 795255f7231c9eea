#include "geography/frame.h"

#include <array>
#include <charconv>
#include <cmath>

#include "base/number_text.h"

namespace foresee {
namespace {

constexpr std::array<std::string_view, 3> unit_names{"mps", "knots", "kmh"};

/// The number with `decimals` (a power of ten) that it is within `error` of, else the number itself.
double short_decimal(double number, double decimals, double error) {
  constexpr double max_scaled = 1e15;  // beyond it a double has fewer decimals
  if (!(std::abs(number) * decimals < max_scaled)) return number;
  const double rounded = std::round(number * decimals) / decimals + 0.0;
  return std::abs(number - rounded) <= error ? rounded : number;
}

std::optional<double> parse_number(std::string_view text) {
  double number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (stop != text.data() + text.size() || error != std::errc()) return std::nullopt;
  return number;
}

/// A text in SQL quotes, as CREATE takes it.
std::string in_quotes(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? "''" : std::string(1, letter);
  return quoted + "'";
}

std::string named_origin(const Frame& frame) {
  if (frame.on_globe()) return "globe";
  return frame.origin ? in_quotes(origin_text(*frame.origin)) : "none";
}

std::string declared_origin(const Frame& frame) {
  return frame.chooses_origin() ? "an origin" : "origin = " + named_origin(frame);
}

/// A height on the globe: its error grows with the distance from the centre of the Earth.
double rounded_height(double height) {
  return short_decimal(height, 1e6, 4e-15 * (semi_major + std::abs(height)));
}

}  // namespace

std::string_view name_of(SpeedUnit unit) {
  return unit_names[static_cast<std::size_t>(unit)];
}

std::optional<SpeedUnit> speed_unit_of(std::string_view name) {
  for (std::size_t i = 0; i < unit_names.size(); ++i)
    if (unit_names[i] == name) return static_cast<SpeedUnit>(i);
  return std::nullopt;
}

Metres Frame::to_metres(const Flight& report) const {
  Flight metric = report;
  auto& course = metric.fix.course;
  if (course) course->speed = to_mps(course->speed, unit);
  if (on_globe()) {
    if (!course && metric.climb != 0) course = Course{0, 0};
    return to_globe(metric);
  }
  const OnPlane point = to_plane(metric.fix, *origin);
  Metres stored{{point.x, point.y, report.height}, {}};
  if (point.v) stored.motion = {{(*point.v)[0], (*point.v)[1], report.climb}, {}};
  return stored;
}

Flight Frame::from_metres(const Metres& point) const {
  Flight report;
  if (on_globe()) {
    report = from_globe(point);
    // Of an object at rest on the ground the climb alone is left, with its rounding error.
    if (point.motion && point.motion->a == std::array<double, 3>{})
      report.fix.course = Course{0, std::nan("")};
  } else {
    OnPlane flat{point.x[0], point.x[1], {}};
    if (point.motion) flat.v = {point.motion->v[0], point.motion->v[1]};
    report = {from_plane(flat, *origin), point.x[2], point.motion ? point.motion->v[2] : 0};
  }
  if (auto& course = report.fix.course) course->speed = from_mps(course->speed, unit);
  return report;
}

Flight Frame::shown(const Metres& point) const {
  Flight report = from_metres(point);
  report.fix = rounded(report.fix);
  if (!on_globe()) return report;
  report.height = rounded_height(report.height);
  report.climb = short_decimal(report.climb, 1e9, 2e-12);
  return report;
}

std::string Frame::name() const {
  if (in_degrees()) return on_globe() ? "globe" : "degrees";
  return text.empty() ? "plane" : text;
}

Fix rounded(const Fix& fix) {
  constexpr double error = 2e-12, course_error = 2e-11;  // above what the projection and its inverse add
  const auto degrees = [&](double number) { return short_decimal(number, 1e9, error); };
  Fix result{{degrees(fix.place.lat), degrees(fix.place.lon)}, {}};
  if (result.place.lon <= -180) result.place.lon = 180;
  if (!fix.course) return result;
  // Some kilometres from the origin, lengths across the direction to it have lost three digits.
  const double speed_error = error + 4e-13 * fix.course->speed;
  // An object that moves is not shown at rest.
  const double speed = short_decimal(fix.course->speed, 1e9, speed_error);
  const double course = short_decimal(fix.course->degrees, 1e6, course_error);
  result.course = Course{speed == 0 ? fix.course->speed : speed, course >= 360 ? 0 : course};
  return result;
}

std::string origin_text(const LatLon& origin) {
  return shown(origin.lat) + " " + shown(origin.lon);
}

std::optional<LatLon> parse_origin(std::string_view text) {
  const std::size_t space = text.find(' ');
  if (space == std::string_view::npos) return std::nullopt;
  const auto lat = parse_number(text.substr(0, space)), lon = parse_number(text.substr(space + 1));
  if (!lat || !lon || !(std::abs(*lat) <= 90) || !(std::abs(*lon) <= 180)) return std::nullopt;
  return LatLon{*lat + 0.0, *lon + 0.0};
}

LatLon origin_near(const LatLon& place) {
  const double lon = std::round(place.lon * 10) / 10 + 0.0;
  return {std::round(place.lat * 10) / 10 + 0.0, lon == -180 ? 180 : lon};
}

std::string frame_conflict(const std::string& table, const Frame& frame, const std::string& other,
                           const Frame& frame_of_other) {
  const Frame &a = frame, &b = frame_of_other;
  if (a.in_degrees() != b.in_degrees()) {
    const bool first = a.in_degrees();
    const std::string &geo = first ? table : other, &plain = first ? other : table;
    return geo + " has lat, lon, " + plain + " has x, y: their coordinates do not match; create " + plain +
           " with lat, lon and " + declared_origin(first ? a : b);
  }
  if (a.in_degrees()) {
    const bool one_kind = a.kind == b.kind;
    if (one_kind && (a.on_globe() || !a.origin || !b.origin || same_origin(a, b))) return "";
    return table + " has origin " + named_origin(a) + ", " + other + " has " + named_origin(b) +
           ": their coordinates do not match; create " + (a.chooses_origin() ? table : other) + " with " +
           declared_origin(a.chooses_origin() ? b : a);
  }
  if (a.text == b.text) return "";
  const auto described = [](const Frame& one) {
    return one.text.empty() ? std::string("none") : in_quotes(one.text);
  };
  const bool from_first = !a.text.empty();
  return table + " has frame " + described(a) + ", " + other + " has " + described(b) +
         ": their coordinates do not match; create " + (from_first ? other : table) +
         " with frame = " + described(from_first ? a : b);
}

}  // namespace foresee
