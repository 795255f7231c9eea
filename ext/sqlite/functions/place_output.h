// Outputs lat, lon, height, speed, course and climb of a table-valued function: place and motion on the Earth of a row.
//
//   PlaceOutput place({.kind = FrameKind::degrees, .origin = LatLon{53.9, 7.9}}, 2);      // Store's frame(), its axes
//   place.output(context, GeoColumn::lat, row);           // NULL for a plain table
//   place.next_row();
//
// The numbers are those that the table's columns show. The height is z, on the globe that above the ellipsoid. NULL for
// a position that is no place: farther from the origin than any, or near the centre of the Earth; and for the course of
// an object at rest. Cost: one geodesic per row that is read.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/float_environment.h"
#include "database/sqlite_api.h"
#include "format/declaration.h"
#include "geography/frame.h"
#include "query/position/positions.h"
#include "sqlite/table/degrees_columns.h"

namespace foresee {

/// The column of these outputs, counted from lat: in the order of GeoColumn.
constexpr GeoColumn geo_column_of(int output) {
  return static_cast<GeoColumn>(1 + output);
}

class PlaceOutput {
 public:
  PlaceOutput(Frame frame, int axes) : frame_(std::move(frame)), axes_(axes) {}

  void next_row() { is_known_ = false; }

  void output(sqlite3_context* context, GeoColumn column, const PositionRow& row) const {
    const bool on_height = column == GeoColumn::height || column == GeoColumn::climb;
    if (!frame_.knows_places() || (on_height && axes_ < 3)) return;
    if (!is_known_) report_ = find({row.x, {{row.v, row.a}}}), is_known_ = true;
    if (!report_) return;
    if (const auto number = shown_number(column, *report_)) sqlite3_result_double(context, *number);
  }

 private:
  std::optional<Flight> find(Metres point) const {
    const FloatEnvironment environment;
    if (axes_ < 3) point.x[2] = point.motion->v[2] = 0;
    try {
      return frame_.shown(point);
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  Frame frame_;
  int axes_;
  mutable std::optional<Flight> report_;  ///< of the current row, if it is a place
  mutable bool is_known_ = false;
};

}  // namespace foresee
