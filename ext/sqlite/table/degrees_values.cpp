// RowReader: latitude, longitude, speed and course of a row as stored metres, on the plane or on the globe
// (docs/reference/degrees.md).
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/float_environment.h"
#include "base/number_text.h"
#include "database/value_text.h"
#include "sqlite/callback.h"
#include "sqlite/table/degrees_columns.h"
#include "sqlite/table/record_values.h"

namespace foresee {
namespace {

constexpr double half_a_knot = to_mps(0.5, SpeedUnit::knots);
/// In metres and metres per second. A number near the limit of doubles could be stored, and not be read. The curvature
/// of a path on the globe is a square.
constexpr double max_number = 1e300, max_speed_on_globe = 1e150;
/// The globe has no place nearer to its centre than 100 km.
constexpr double min_height = -6.2e6;

/// Whether the value is the number that the column shows, or NULL where it shows none.
bool is_shown(sqlite3_value* value, const std::optional<double>& number) {
  if (!number) return is_null_or_empty(value);
  const int type = sqlite3_value_type(value);
  return (type == SQLITE_FLOAT || type == SQLITE_INTEGER) && sqlite3_value_double(value) == *number;
}

std::size_t index_of(GeoColumn column) {
  return static_cast<std::size_t>(column);
}

}  // namespace

/// The value of a column; nothing for an unknown speed or course.
std::optional<double> RowReader::degrees_number(const Column& column, std::int64_t id,
                                                sqlite3_value* value) const {
  switch (column.geo) {
    case GeoColumn::speed:
    case GeoColumn::course:
      return speed_or_course(column, id, value);
    case GeoColumn::height:
    case GeoColumn::climb:
      return height_or_climb(column, id, value);
    default:
      return latitude_or_longitude(column, id, value);
  }
}

double RowReader::height_or_climb(const Column& column, std::int64_t id, sqlite3_value* value) const {
  const double number = number_to_store(column, id, value);
  if (std::abs(number) > max_number)
    refuse(column.name, id, shown(value), "more than 1e300; write metres, or metres per second");
  if (column.geo == GeoColumn::height && number < min_height)
    refuse(column.name, id, shown(value),
           "the centre of the Earth is 6.4e6 m down; write metres above the ellipsoid");
  return number;
}

double RowReader::latitude_or_longitude(const Column& column, std::int64_t id, sqlite3_value* value) const {
  const double number = number_to_store(column, id, value);
  const bool lat = column.geo == GeoColumn::lat;
  if (number == (lat ? 91 : 181))
    refuse(column.name, id, shown(value), "\"not available\" in AIS; leave the row out");
  if (std::abs(number) <= (lat ? 90 : 180)) return number;
  refuse(column.name, id, shown(value),
         lat ? "a latitude is within 90 degrees; write degrees north of the equator, -90 to 90"
             : "a longitude is within 180 degrees; write degrees east of Greenwich, -180 to 180");
}

/// Nothing for an unknown speed or course. 102.3 knots and 360 degrees are "not available" in AIS.
std::optional<double> RowReader::speed_or_course(const Column& column, std::int64_t id,
                                                 sqlite3_value* value) const {
  if (is_null_or_empty(value)) return std::nullopt;
  const double number = number_to_store(column, id, value);
  if (column.geo == GeoColumn::speed) {
    if (frame_.unit == SpeedUnit::knots && number == 102.3) return std::nullopt;
    if (number < 0)
      refuse(column.name, id, shown(value), "a speed is never negative; write 0 or more, and the course");
    if (to_mps(number, frame_.unit) <= (frame_.on_globe() ? max_speed_on_globe : max_number)) return number;
    refuse(column.name, id, shown(value),
           std::string("more than ") + (frame_.on_globe() ? "1e150" : "1e300") +
               " metres per second; write the speed in " + std::string(name_of(frame_.unit)) +
               ", or NULL if it is unknown");
  }
  if (number == 360) return std::nullopt;
  if (0 <= number && number < 360) return number;
  refuse(
      column.name, id, shown(value),
      "a course is at least 0 and below 360; write degrees clockwise from north, or NULL if it is unknown");
}

std::optional<Course> RowReader::course_of_row(std::int64_t id, const std::optional<double>& speed,
                                               const std::optional<double>& course,
                                               sqlite3_value* given) const {
  if (!speed) return std::nullopt;
  if (course) return Course{*speed, *course};
  if (to_mps(*speed, frame_.unit) <= half_a_knot) return std::nullopt;  // it is at rest
  const std::string needs =
      "a speed of " + foresee::shown(*speed) + " needs a course; write the course, or NULL for the speed";
  if (is_null_or_empty(given)) refuse("course", id, "NULL", needs);
  refuse("course", id, shown(given), "unknown, as in AIS, and " + needs + "; 0 is north");
}

/// An UPDATE that leaves place or motion as they are, or writes what the columns show, keeps the stored bits. Where it
/// changes only some of the columns, the others are what they show.
void RowReader::fill_degrees(std::int64_t id, sqlite3_value** motion, TableWriter& store,
                             std::optional<std::int64_t> updated) {
  const FloatEnvironment environment;
  new_origin_.reset();
  std::vector<double> before;
  if (updated) before = store.read(*updated).value_or(before);
  const auto is_unchanged = [&](std::size_t column) {
    return !before.empty() && sqlite3_value_nochange(motion[column]);
  };
  if (std::all_of(degrees_.begin(), degrees_.end(), is_unchanged)) {
    copy_place(before);
    return copy_motion(before);
  }

  Numbers numbers;
  std::array<bool, geo_columns> same;
  same.fill(true);  // also what is not declared
  sqlite3_value* course = nullptr;
  std::optional<Flight> shows;
  if (!before.empty()) shows = shown_report(store, *updated, before.data());
  for (const std::size_t i : degrees_) {
    const GeoColumn geo = columns_[i].geo;
    auto& number = numbers[index_of(geo)];
    if (geo == GeoColumn::course) course = motion[i];
    if (shows) number = shown_number(geo, *shows);
    same[index_of(geo)] = shows && (is_unchanged(i) || is_shown(motion[i], number));
    if (!same[index_of(geo)]) number = degrees_number(columns_[i], id, motion[i]);
  }
  const auto are_same = [&](std::initializer_list<GeoColumn> columns) {
    return std::all_of(columns.begin(), columns.end(),
                       [&](GeoColumn column) { return same[index_of(column)]; });
  };
  const bool same_place = are_same({GeoColumn::lat, GeoColumn::lon, GeoColumn::height});
  const bool same_motion = are_same({GeoColumn::speed, GeoColumn::course, GeoColumn::climb});
  if (same_place && same_motion) {
    copy_place(before);
    return copy_motion(before);
  }

  const Flight report = report_of(id, numbers, course);
  const Frame& frame = store.frame();
  const LatLon origin = frame.origin ? *frame.origin : origin_near(report.fix.place);
  store_degrees(metres_of_row(id, report, origin, same_place));
  if (same_place) copy_place(before);
  if (frame.chooses_origin()) new_origin_ = origin;
}

Flight RowReader::report_of(std::int64_t id, const Numbers& numbers, sqlite3_value* course) const {
  const auto number = [&](GeoColumn column) { return numbers[index_of(column)]; };
  Flight report{{{*number(GeoColumn::lat), *number(GeoColumn::lon)}, {}},
                number(GeoColumn::height).value_or(0),
                number(GeoColumn::climb).value_or(0)};
  if (course)
    report.fix.course = course_of_row(id, number(GeoColumn::speed), number(GeoColumn::course), course);
  return report;
}

/// A place that an UPDATE leaves alone was near enough when it was stored.
Metres RowReader::metres_of_row(std::int64_t id, const Flight& report, const LatLon& origin,
                                bool same_place) const {
  Frame frame{.kind = frame_.kind, .unit = frame_.unit};
  if (!frame.on_globe()) frame.origin = origin;
  Metres point{};
  try {
    point = frame.to_metres(report);
  } catch (const Error& error) {
    // Opposite the origin no velocity is defined: such a place is refused for its distance, as those around it.
    if (!frame.on_globe())
      require_near(id, report.fix.place, frame.to_metres({{report.fix.place, {}}, 0, 0}), origin);
    throw Refusal(SQLITE_CONSTRAINT, table_ + ": row " + std::to_string(id) + ": " + error.what());
  }
  if (!frame.on_globe() && !same_place) require_near(id, report.fix.place, point, origin);
  return point;
}

void RowReader::require_near(std::int64_t id, const LatLon& place, const Metres& point,
                             const LatLon& origin) const {
  const double distance = std::hypot(point.x[0], point.x[1]);
  if (distance <= max_distance_from_origin) return;
  throw Refusal(SQLITE_CONSTRAINT,
                table_ + ": lat, lon of row " + std::to_string(id) + " are " + foresee::shown(place.lat) +
                    ", " + foresee::shown(place.lon) + ": " + foresee::shown(std::ceil(distance / 1000)) +
                    " km from the origin '" + origin_text(origin) +
                    "', the limit is 1500; create a table with a nearer origin, or with origin = globe");
}

void RowReader::store_degrees(const Metres& point) {
  const std::size_t axes = frame_.axes_of_place();
  const auto store = [&](int offset, const std::array<double, 3>& from) {
    if (offset != Offsets::absent) std::copy_n(from.begin(), axes, record_.begin() + offset);
  };
  const OnGlobe::Motion motion = point.motion.value_or(OnGlobe::Motion{});
  store(at_.x, point.x);
  store(at_.v, motion.v);
  store(at_.a, motion.a);
}

/// Keeps the stored bits.
void RowReader::copy_place(const std::vector<double>& before) {
  std::copy_n(before.begin() + at_.x, frame_.axes_of_place(), record_.begin() + at_.x);
}
void RowReader::copy_motion(const std::vector<double>& before) {
  const bool is_declared = std::any_of(degrees_.begin(), degrees_.end(),
                                       [this](std::size_t i) { return columns_[i].geo == GeoColumn::speed; });
  if (!is_declared) return;  // a row without its plan is at rest
  for (const int offset : {at_.v, at_.a})
    if (offset != Offsets::absent)
      std::copy_n(before.begin() + offset, frame_.axes_of_place(), record_.begin() + offset);
}

}  // namespace foresee
