#include "shape/outline/cut_outline.h"

#include "shape/outline/turn.h"

namespace foresee {

Outline CutOutline::as_it_lies(double heading) const {
  if (heading == 0) return outline_;
  std::call_once(touched_, [this] { edge_touch_ = edge_touch_of(outline_); });
  Outline lies = turned(outline_, heading);
  check_turned(outline_, edge_touch_, lies, heading);
  return lies;
}

}  // namespace foresee
