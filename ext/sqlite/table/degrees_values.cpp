// Values: latitude, longitude, speed and course of a row as numbers on the plane (docs/reference/degrees.md).
#include <algorithm>
#include <cmath>

#include "base/float_environment.h"
#include "base/number_text.h"
#include "sqlite/callback.h"
#include "sqlite/table/degrees_columns.h"
#include "sqlite/table/record_values.h"
#include "storage/rows/value_text.h"

namespace foresee {
namespace {

constexpr double half_a_knot = to_mps(0.5, SpeedUnit::knots);
/// In metres per second. A speed near the limit of doubles could be stored, and not be read.
constexpr double max_speed = 1e300;

/// Whether the value is the number that the column shows, or NULL where it shows none.
bool is_shown(sqlite3_value* value, const std::optional<double>& number) {
  if (!number) return is_null_or_empty(value);
  const int type = sqlite3_value_type(value);
  return (type == SQLITE_FLOAT || type == SQLITE_INTEGER) && sqlite3_value_double(value) == *number;
}

}  // namespace

/// A value of lat, lon, speed or course; nothing for an unknown speed or course.
std::optional<double> Values::degrees_number(const Column& column, std::int64_t id,
                                             sqlite3_value* value) const {
  const bool is_motion = column.geo == GeoColumn::speed || column.geo == GeoColumn::course;
  return is_motion ? speed_or_course(column, id, value) : latitude_or_longitude(column, id, value);
}

double Values::latitude_or_longitude(const Column& column, std::int64_t id, sqlite3_value* value) const {
  const double number = stored(column, id, value);
  const bool lat = column.geo == GeoColumn::lat;
  if (number == (lat ? 91 : 181))
    refuse(column.name, id, shown(value), "\"not available\" in AIS; leave the row out");
  if (std::abs(number) <= (lat ? 90 : 180)) return number;
  refuse(column.name, id, shown(value),
         lat ? "a latitude is within 90 degrees; write degrees north of the equator, -90 to 90"
             : "a longitude is within 180 degrees; write degrees east of Greenwich, -180 to 180");
}

/// Nothing for an unknown speed or course. 102.3 knots and 360 degrees are "not available" in AIS.
std::optional<double> Values::speed_or_course(const Column& column, std::int64_t id,
                                              sqlite3_value* value) const {
  if (is_null_or_empty(value)) return std::nullopt;
  const double number = stored(column, id, value);
  if (column.geo == GeoColumn::speed) {
    if (unit_ == SpeedUnit::knots && number == 102.3) return std::nullopt;
    if (number < 0)
      refuse(column.name, id, shown(value), "a speed is never negative; write 0 or more, and the course");
    if (to_mps(number, unit_) <= max_speed) return number;
    refuse(column.name, id, shown(value),
           "more than 1e300 metres per second; write the speed in " + std::string(name_of(unit_)) +
               ", or NULL if it is unknown");
  }
  if (number == 360) return std::nullopt;
  if (0 <= number && number < 360) return number;
  refuse(
      column.name, id, shown(value),
      "a course is at least 0 and below 360; write degrees clockwise from north, or NULL if it is unknown");
}

std::optional<Course> Values::course_of_row(std::int64_t id, const std::optional<double>& speed,
                                            const std::optional<double>& course, sqlite3_value* given) const {
  if (!speed) return std::nullopt;
  if (course) return Course{*speed, *course};
  if (to_mps(*speed, unit_) <= half_a_knot) return std::nullopt;  // it lies still
  const std::string needs =
      "a speed of " + foresee::shown(*speed) + " needs a course; write it, or NULL for the speed if ";
  if (is_null_or_empty(given)) refuse("course", id, "NULL", needs + "it is unknown");
  refuse("course", id, shown(given), "unknown, as in AIS, and " + needs + "unknown; 0 is north");
}

/// An UPDATE that leaves place or motion as they are, or writes what the columns show, keeps the stored bits. Where it
/// changes only some of the four, the others are what the columns show.
void Values::fill_degrees(std::int64_t id, sqlite3_value** motion, Store& store,
                          std::optional<std::int64_t> updated) {
  const FloatEnvironment environment;
  new_origin_.reset();
  std::vector<double> before;
  if (updated) before = store.read(*updated).value_or(before);
  const auto is_unchanged = [&](std::size_t i) {
    return !before.empty() && sqlite3_value_nochange(motion[degrees_[i]]);
  };
  const std::size_t count = degrees_.size();
  std::size_t unchanged = 0;
  while (unchanged < count && is_unchanged(unchanged)) ++unchanged;
  if (unchanged == count) return copy_degrees(before, true, true);

  std::array<std::optional<double>, 4> number;
  std::array<bool, 4> same{};
  if (!before.empty()) {
    const Fix shows = shown_fix(store, *updated, before.data());
    for (std::size_t i = 0; i < count; ++i) {
      number[i] = shown_number(columns_[degrees_[i]].geo, shows);
      same[i] = is_unchanged(i) || is_shown(motion[degrees_[i]], number[i]);
    }
  }
  for (std::size_t i = 0; i < count; ++i)
    if (!same[i]) number[i] = degrees_number(columns_[degrees_[i]], id, motion[degrees_[i]]);
  const bool same_place = same[0] && same[1], same_motion = same[2] && same[3];
  if (same_place && (same_motion || count == 2)) return copy_degrees(before, true, true);

  const Frame& frame = store.frame();
  const LatLon place{*number[0], *number[1]}, origin = frame.origin ? *frame.origin : origin_near(place);
  Fix fix{place, {}};
  if (count > 2) fix.course = course_of_row(id, number[2], number[3], motion[degrees_[3]]);
  const OnPlane point = on_plane(id, fix, origin, same_place);
  double* const x = &record_[static_cast<std::size_t>(at_.x)];
  x[0] = point.x, x[1] = point.y;
  if (count > 2) {
    double* const v = &record_[static_cast<std::size_t>(at_.v)];
    v[0] = point.v ? (*point.v)[0] : 0, v[1] = point.v ? (*point.v)[1] : 0;
  }
  if (same_place) copy_degrees(before, true, false);
  if (!frame.origin) new_origin_ = origin;
}

/// A place that an UPDATE leaves alone was near enough when it was stored.
OnPlane Values::on_plane(std::int64_t id, const Fix& fix, const LatLon& origin, bool same_place) const {
  const std::string row = table_ + ": row " + std::to_string(id);
  try {
    const OnPlane point = Frame{FrameKind::degrees, {}, origin, unit_}.to_plane(fix);
    const double distance = std::hypot(point.x, point.y);
    if (same_place || distance <= max_distance_from_origin) return point;
    throw Error("is " + foresee::shown(std::ceil(distance / 1000)) + " km from the origin '" +
                origin_text(origin) +
                "', the limit is 1500; create a table with a nearer origin, or use geo_to_globe");
  } catch (const Error& error) {
    throw Refusal(SQLITE_CONSTRAINT, row + ' ' + error.what());
  }
}

/// Keeps the stored bits of the place or of the motion.
void Values::copy_degrees(const std::vector<double>& before, bool place, bool motion) {
  const auto copy = [&](int offset) {
    if (offset != Offsets::absent)
      std::copy_n(&before[static_cast<std::size_t>(offset)], 2, &record_[static_cast<std::size_t>(offset)]);
  };
  if (place) copy(at_.x);
  if (motion) copy(at_.v);
}

}  // namespace foresee
