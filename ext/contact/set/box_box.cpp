#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"

namespace foresee::contact {

ContactSet box_box_set(const Setup& setup) {
  ContactSet set;
  // In one dimension a ball is an interval.
  const int ball = setup.a.layout.axes == 1 ? set.in_both(setup.a.at.r, setup.b.at.r) : no_length;
  const int more = set.sum(ball, set.given(setup.within));
  std::vector<Faces> faces = faces_of_boxes(set, setup);
  for (Faces& f : faces) f = grown(set, f, more);
  add_box(set, faces);
  return set;
}

}  // namespace foresee::contact
