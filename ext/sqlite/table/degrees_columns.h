// Columns lat, lon, speed and course of a stored record, as a table in degrees shows them.
//
//   const Fix fix = shown_fix(store, 42, record);         // one geodesic
//   shown_number(GeoColumn::course, fix)                  // nothing: it lies still
//
// Throws StoreError (SQLITE_CORRUPT_VTAB) for a place or speed that no report has, and without an origin.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "base/float_environment.h"
#include "geography/frame.h"
#include "storage/table/store.h"

namespace foresee {

/// Requires: a table in degrees. `state`: of a statement that reads repeatedly.
inline Fix shown_fix(Store& store, std::int64_t id, const double* record,
                     StatementReadState* state = nullptr) try {
  const FloatEnvironment environment;
  const Offsets& at = store.format().at;
  OnPlane point{record[at.x], record[at.x + 1], {}};
  if (at.v != Offsets::absent) point.v = {record[at.v], record[at.v + 1]};
  return rounded(store.frame_of_objects(state).from_plane(point));
} catch (const StoreError&) {
  throw;
} catch (const Error& error) {
  store.damaged("object " + std::to_string(id) + ": " + error.what());
}

inline std::optional<double> shown_number(GeoColumn column, const Fix& fix) {
  switch (column) {
    case GeoColumn::lat:
      return fix.place.lat;
    case GeoColumn::lon:
      return fix.place.lon;
    case GeoColumn::speed:
      if (fix.course) return fix.course->speed;
      break;
    case GeoColumn::course:
      if (fix.course && !std::isnan(fix.course->degrees)) return fix.course->degrees;
      break;
    case GeoColumn::none:
      break;
  }
  return std::nullopt;
}

}  // namespace foresee
