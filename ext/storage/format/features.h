// Features of a stored table that version 0.1 of foresee does not know, as a list of names in `_meta`.
//
//   features_of(declaration)                          // "blocks,shapes", the value of features in _meta
//   unknown_feature("blocks,tiles") == "tiles"        // the first name that this library does not know
//
// The format number defines the layout of nodes; a feature is anything else that a reader must know. A
// library that does not know a feature would give wrong results, so it refuses the table and names the
// feature.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "storage/format/declaration.h"

namespace foresee {

struct Feature {
  std::string_view name;  ///< one word
  bool (*is_used)(const Declaration&);
};

/// Rows of <name>_map are blocks of ids (format/id_block.h). Every new table has this feature.
constexpr std::string_view map_blocks = "blocks";

/// Records refer to rows of <name>_shape by number. Tables with a column `shape` have this feature.
constexpr std::string_view stored_shapes = "shapes";

/// Rows of <name>_shape are meshes, and bounds have three axes. Tables with `shape` and z, but without hz,
/// have this feature.
constexpr std::string_view stored_meshes = "meshes";

/// Shapes grow, so bounds move even in tables at rest. Tables with `growth` or `growth_z` have this feature.
constexpr std::string_view stored_growth = "growth";

/// Columns lat, lon are stored on the plane about an origin in `_meta`. Tables in degrees have this feature, except
/// those on the globe.
constexpr std::string_view stored_degrees = "degrees";

/// Columns lat, lon are stored as geocentric metres. Tables with `origin = globe` have this feature.
constexpr std::string_view stored_globe = "globe";

/// Rows of <name>_shape are zones, with corners in degrees (format/outline_blob.h). Tables with a column `zone`
/// have this feature.
constexpr std::string_view stored_zones = "zones";

/// The declaration names the frame of the coordinates. Tables with the option `frame` have this feature.
constexpr std::string_view named_frame = "frame";

/// Records have a category or a mask, and entries of inner nodes the kinds beneath them. Tables with `category`
/// or `mask` have this feature.
constexpr std::string_view stored_kinds = "kinds";

/// Objects may have plans, whose legs are in <name>_leg. Tables with a column `plan` have this feature.
constexpr std::string_view stored_plans = "plans";

/// Maximum length in bytes of the list that is read.
constexpr std::size_t max_features = 1000;

/// The features that this library knows.
std::span<const Feature> known_features();

/// The comma-separated names of the features that a table uses.
std::string features_of(const Declaration& declaration, std::span<const Feature> known = known_features());

/// True if `name` is in the comma-separated list `names`.
bool has_feature(std::string_view names, std::string_view name);

/// The first name that is not known; "" if all are known.
std::string unknown_feature(std::string_view names, std::span<const Feature> known = known_features());

}  // namespace foresee
