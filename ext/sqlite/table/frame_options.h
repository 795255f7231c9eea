// Frame of a moving_objects table as its declaration says it: columns lat, lon, speed, course, and the options
// origin, speed_unit and frame.
//
//   FrameOptions options;
//   options.read_if_known(parse_argument("speed_unit = knots"));      // true: an option of the frame
//   const Frame frame = options.frame(words);                // of all declared columns
//
// Throws Error for a declaration that no table can have (docs/reference/degrees.md). Examples are x beside lat,
// lat without lon, an acceleration in degrees, and an origin of a plain table.
#pragma once

#include <optional>
#include <vector>

#include "geography/frame.h"
#include "sqlite/table/layout_rules.h"
#include "sqlite/table/table_arguments.h"

namespace foresee {

class FrameOptions {
 public:
  /// Whether the option is one of the frame; then its value is checked and kept.
  bool read_if_known(const Argument& argument);

  /// Requires: no word occurs twice.
  Frame frame(const std::vector<DeclaredWord>& words) const;

 private:
  void require_plane() const;
  Frame frame_of_zones(const DeclaredWord& zone, const std::vector<DeclaredWord>& words) const;

  std::optional<Argument> origin_, unit_, text_;
  Frame given_;
};

}  // namespace foresee
