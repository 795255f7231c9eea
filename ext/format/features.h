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

#include "format/declaration.h"

namespace foresee {

struct Feature {
  std::string_view name;  ///< one word
  bool (*is_used)(const Declaration&);
};

/// Rows of <name>_map are blocks of ids (format/id_block.h). Every new table has this feature.
constexpr std::string_view map_blocks = "blocks";

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
