#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"

namespace foresee::contact {

ContactSet window_box_set(const Setup& setup) {
  ContactSet set;
  const std::vector<Faces> boxes = faces_of_boxes(set, setup);
  // In one dimension a ball is an interval.
  const int ball = setup.a.layout.axes == 1 ? set.in_both(setup.a.at.r, setup.b.at.r) : no_length;
  std::vector<Faces> faces = faces_of_window(set, setup);
  for (Faces& f : faces) {
    const int half = boxes[static_cast<std::size_t>(f.axis)].above;
    f = grown(set, f, set.sum(half, ball));
  }
  add_box(set, faces);
  return set;
}

}  // namespace foresee::contact
