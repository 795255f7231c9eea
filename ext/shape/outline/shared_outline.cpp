#include "shape/outline/shared_outline.h"

#include "shape/outline/outline_rotation.h"

namespace foresee {

Outline SharedOutline::rotated(double heading) const {
  if (heading == 0) return outline_;
  std::call_once(checked_, [this] { edge_touch_ = edge_touch_of(outline_); });
  Outline turned_outline = turned(outline_, heading);
  check_turned(outline_, edge_touch_, turned_outline, heading);
  return turned_outline;
}

}  // namespace foresee
