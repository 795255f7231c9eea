#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"
#include "contact/set/sizes_of_both.h"

namespace foresee {

ContactSet window_box_set(const Setup& setup) {
  ContactSet set;
  const std::vector<Faces> boxes = faces_of_boxes(set, setup);
  // In one dimension a ball is an interval.
  const Size ball = setup.a.layout.axes == 1 ? radius_of_both(set, setup, 0) : Size{};
  std::vector<Faces> faces = faces_of_window(set, setup);
  for (Faces& f : faces)
    f = grown_faces(set, f, set.sum(boxes[static_cast<std::size_t>(f.axis)].above, ball));
  add_box(set, faces);
  return set;
}

}  // namespace foresee
