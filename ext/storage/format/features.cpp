#include "storage/format/features.h"

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
  static constexpr std::array<Feature, 10> known{
      {{map_blocks, [](const Declaration&) { return true; }},
       {stored_shapes, [](const Declaration& declared) { return is_stored_apart(declared.layout.shape); }},
       {stored_meshes, [](const Declaration& declared) { return declared.layout.shape == Shape::mesh; }},
       {stored_growth, [](const Declaration& declared) { return grows(declared.layout); }},
       {stored_degrees,
        [](const Declaration& declared) { return declared.frame.kind == FrameKind::degrees; }},
       {stored_globe, [](const Declaration& declared) { return declared.frame.on_globe(); }},
       {named_frame, [](const Declaration& declared) { return !declared.frame.text.empty(); }},
       {stored_zones, [](const Declaration& declared) { return declared.has_zones(); }},
       {stored_kinds, [](const Declaration& declared) { return has_kinds(declared.layout); }},
       {stored_plans, [](const Declaration& declared) { return declared.layout.has_plan; }}}};
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
