// Outputs lat and lon of a table-valued function: the place on the Earth of a row's point on the plane.
//
//   PlaceOutput place({.kind = FrameKind::degrees, .origin = LatLon{53.9, 7.9}});      // Store::frame()
//   place.output(context, GeoColumn::lat, 1000, 2000);      // NULL for a plain table
//   place.next_row();
//
// The numbers are those that the table's columns show. NULL for a point that is farther from the origin than any
// place. Cost: one geodesic per row that is read.
#pragma once

#include <optional>
#include <utility>

#include "base/error.h"
#include "base/float_environment.h"
#include "geography/frame.h"
#include "storage/format/declaration.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

class PlaceOutput {
 public:
  explicit PlaceOutput(Frame frame) : frame_(std::move(frame)) {}

  void next_row() { is_known_ = false; }

  void output(sqlite3_context* context, GeoColumn column, double x, double y) const {
    if (!frame_.in_degrees() || !frame_.origin) return;
    if (!is_known_) place_ = find(x, y), is_known_ = true;
    if (place_) sqlite3_result_double(context, column == GeoColumn::lat ? place_->lat : place_->lon);
  }

 private:
  std::optional<LatLon> find(double x, double y) const {
    const FloatEnvironment environment;
    try {
      return rounded(frame_.from_plane({x, y, {}})).place;
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  Frame frame_;
  mutable std::optional<LatLon> place_;  ///< of the current row, if it is known
  mutable bool is_known_ = false;
};

}  // namespace foresee
