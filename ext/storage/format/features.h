// What does a stored table use that version 0.1 of foresee did not know?
//
//   features_of(declaration)                          // "blocks,shapes", which _meta keeps
//   unknown_feature("blocks,tiles") == "tiles"        // of two, this library knows the first
//
// The format's number says how nodes are drawn; a feature says that there is more to a table than that. A
// library that does not know one of them would answer wrongly, so it refuses the table and says which.
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

/// Rows of <name>_map that are blocks of ids (format/id_block.h). Every new table has it.
constexpr std::string_view map_blocks = "blocks";

/// What <name>_shape has, which records name by number. Tables with a column `shape` have it.
constexpr std::string_view stored_shapes = "shapes";

/// That what it has are meshes, and bounds those of three axes. Tables with `shape` and z, but no hz, have
/// it.
constexpr std::string_view stored_meshes = "meshes";

/// That shapes grow: bounds move in tables at rest too. Tables with `growth` or `growth_z` have it.
constexpr std::string_view stored_growth = "growth";

/// Bytes that are read of their names.
constexpr std::size_t max_features = 1000;

/// Those that this library knows.
std::span<const Feature> known_features();

/// The names of those that a table uses, with commas between them.
std::string features_of(const Declaration& declaration, std::span<const Feature> known = known_features());

/// Is `name` one of `names`?
bool has_feature(std::string_view names, std::string_view name);

/// The first name that is not known; "" if all are.
std::string unknown_feature(std::string_view names, std::span<const Feature> known = known_features());

}  // namespace foresee
