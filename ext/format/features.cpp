#include "format/features.h"

#include <algorithm>
#include <array>

#include "shape/kinds.h"

namespace foresee {
namespace {

/// Removes the first name from the list and returns it.
std::string_view pop_first(std::string_view& names) {
  const std::string_view first = names.substr(0, names.find(','));
  names.remove_prefix(std::min(names.size(), first.size() + 1));
  return first;
}

}  // namespace

std::span<const Feature> known_features() {
  using Table = const Declaration&;
  static constexpr std::array<Feature, 10> known{
      {{map_blocks, [](Table) { return true; }},
       // Records refer to rows of <name>_shape by number: with a column `shape`.
       {"shapes", [](Table table) { return is_stored_apart(table.layout.shape); }},
       // Rows of <name>_shape are meshes, and bounds have three axes: with `shape` and z, but without hz.
       {"meshes", [](Table table) { return table.layout.shape == Shape::mesh; }},
       // Shapes grow, so bounds move even in tables at rest: with `growth` or `growth_z`.
       {"growth", [](Table table) { return grows(table.layout); }},
       // Columns lat, lon are stored on the plane about an origin in `_meta`: in degrees, except on the globe.
       {"degrees", [](Table table) { return table.frame.kind == FrameKind::degrees; }},
       // Columns lat, lon are stored as geocentric metres: with `origin = globe`.
       {"globe", [](Table table) { return table.frame.on_globe(); }},
       // The declaration names the frame of the coordinates: with the option `frame`.
       {"frame", [](Table table) { return !table.frame.text.empty(); }},
       // Rows of <name>_shape are zones, with corners in degrees (form_blob.h): with a column `zone`.
       {"zones", [](Table table) { return table.has_zones(); }},
       // Records have a category or a mask, and entries of inner nodes the kinds beneath them: with either column.
       {"kinds", [](Table table) { return has_kinds(table.layout); }},
       // Objects may have plans, whose legs are in <name>_leg: with a column `plan`.
       {"plans", [](Table table) { return table.layout.has_plan; }}}};
  return known;
}

std::string features_of(const Declaration& declaration, std::span<const Feature> known) {
  std::string names;
  for (const Feature& feature : known) {
    if (!feature.is_used(declaration)) continue;
    if (!names.empty()) names += ',';
    names += feature.name;
  }
  return names;
}

bool has_feature(std::string_view names, std::string_view name) {
  while (!names.empty())
    if (pop_first(names) == name) return true;
  return false;
}

std::string unknown_feature(std::string_view names, std::span<const Feature> known) {
  while (!names.empty()) {
    const std::string_view name = pop_first(names);
    if (std::none_of(known.begin(), known.end(), [&](const Feature& one) { return one.name == name; }))
      return name.empty() ? "," : std::string(name);
  }
  return "";
}

}  // namespace foresee
