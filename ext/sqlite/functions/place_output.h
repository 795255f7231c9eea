// Outputs lat, lon and height of a table-valued function: the place on the Earth of a row's stored position.
//
//   PlaceOutput place({.kind = FrameKind::degrees, .origin = LatLon{53.9, 7.9}}, 2);      // Store::frame(), its axes
//   place.output(context, GeoColumn::lat, position);   // NULL for a plain table
//   place.next_row();
//
// The numbers are those that the table's columns show. The height is z, on the globe that above the ellipsoid. NULL for
// a position that is no place: farther from the origin than any, or near the centre of the Earth.
// Cost: one geodesic per row that is read.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/float_environment.h"
#include "geography/frame.h"
#include "storage/format/declaration.h"
#include "storage/rows/sqlite_api.h"

namespace foresee {

/// The column of the first, second and third output.
constexpr GeoColumn geo_column_of(int output) {
  return output == 0 ? GeoColumn::lat : output == 1 ? GeoColumn::lon : GeoColumn::height;
}

class PlaceOutput {
 public:
  PlaceOutput(Frame frame, int axes) : frame_(std::move(frame)), axes_(axes) {}

  void next_row() { is_known_ = false; }

  void output(sqlite3_context* context, GeoColumn column, const std::array<double, 3>& x) const {
    if (!frame_.knows_places() || (column == GeoColumn::height && axes_ < 3)) return;
    if (!is_known_) report_ = find(x), is_known_ = true;
    if (!report_) return;
    const LatLon& place = report_->fix.place;
    sqlite3_result_double(context, column == GeoColumn::lat   ? place.lat
                                   : column == GeoColumn::lon ? place.lon
                                                              : report_->height);
  }

 private:
  std::optional<Flight> find(std::array<double, 3> x) const {
    const FloatEnvironment environment;
    if (axes_ < 3) x[2] = 0;
    try {
      return frame_.shown({x, {}});
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
