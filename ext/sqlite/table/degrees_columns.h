// Columns lat, lon, speed and course of a stored record, on the globe also z and vz, as a table in degrees shows them.
//
//   const Flight report = shown_report(store, 42, record);         // one geodesic
//   shown_number(GeoColumn::course, report)                        // nothing: it is at rest
//
// Throws StoreError (SQLITE_CORRUPT_VTAB) for a place or speed that no report has, and without an origin.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "base/float_environment.h"
#include "geography/frame.h"
#include "storage/table/table_reader.h"

namespace foresee {

/// Place and motion of a record of a table in degrees.
inline Metres metres_of(const Frame& frame, const Offsets& at, const double* record) {
  Metres point{};
  const std::size_t axes = frame.axes_of_place();
  const auto copy = [&](int offset, std::array<double, 3>& to) {
    std::copy_n(record + offset, axes, to.begin());
  };
  copy(at.x, point.x);
  if (at.v == Offsets::absent) return point;
  copy(at.v, point.motion.emplace().v);
  if (at.a != Offsets::absent) copy(at.a, point.motion->a);
  return point;
}

/// Requires: a table in degrees. `state`: of a statement that reads repeatedly.
inline Flight shown_report(TableReader& store, std::int64_t id, const double* record,
                           StatementReadState* state = nullptr) try {
  const FloatEnvironment environment;
  const Frame& frame = store.frame_of_objects(state);
  return frame.shown(metres_of(frame, store.format().at, record));
} catch (const StoreError&) {
  throw;
} catch (const Error& error) {
  store.damaged("object " + std::to_string(id) + ": " + error.what());
}

inline std::optional<double> shown_number(GeoColumn column, const Flight& report) {
  const auto& [place, course] = report.fix;
  switch (column) {
    case GeoColumn::lat:
      return place.lat;
    case GeoColumn::lon:
      return place.lon;
    case GeoColumn::height:
      return report.height;
    case GeoColumn::climb:
      return report.climb;
    case GeoColumn::speed:
      if (course) return course->speed;
      break;
    case GeoColumn::course:
      if (course && !std::isnan(course->degrees)) return course->degrees;
      break;
    case GeoColumn::none:
      break;
  }
  return std::nullopt;
}

}  // namespace foresee
