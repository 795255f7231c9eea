// Declaration of a moving_objects table: columns in their order, auxiliary columns and options of CREATE
// VIRTUAL TABLE.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geography/frame.h"
#include "shape/row_layout.h"

namespace foresee {

/// In a table that takes degrees: what is computed from the stored metres when the column is read. `height` and `climb`
/// are z and vz on the globe; on the plane these two are stored.
enum class GeoColumn : std::uint8_t { none, lat, lon, height, speed, course, climb };
constexpr std::size_t geo_columns = 7;

/// A declared motion column (the id is not one of them) and its place in the stored record.
struct MotionColumn {
  /// As in docs/reference/moving_objects.md#columns: t, x, vy, m, r, shape, category, until.
  std::string name;
  int place;                        ///< index of its double in the record
  bool is_form = false;             ///< the double is the number of an outline or mesh
  bool is_kind = false;             ///< the double is a category or a mask, which reads back as an integer
  GeoColumn geo = GeoColumn::none;  ///< `place` is then that of an axis
  bool is_plan = false;             ///< the double is the number of a plan's first chunk
};

/// `+name TYPE`: a value that is stored with each object and not interpreted.
struct AuxiliaryColumn {
  std::string name;
  std::string type;  ///< text after the name, possibly empty
};

/// The name of the column that places outlines by longitude and latitude, in place of `shape`.
constexpr std::string_view zone_column = "zone";

struct Declaration {
  Layout layout;
  std::vector<MotionColumn> columns = {};  ///< in declaration order
  std::vector<AuxiliaryColumn> auxiliaries = {};
  double horizon = 60;  ///< look-ahead that the tree is optimized for
  Frame frame =
      {};  ///< as declared: without an origin, the first position stored chooses it (TableReader::frame)

  /// Objects are zones: outlines about the origin of the plane, at rest in it.
  bool has_zones() const {
    return std::any_of(columns.begin(), columns.end(),
                       [](const MotionColumn& column) { return column.name == zone_column; });
  }
};

}  // namespace foresee
