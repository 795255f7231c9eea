#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"

namespace foresee::contact {

ContactSet box_ball_set(const Setup& setup) {
  ContactSet set;
  const int radius = set.sum(set.in_both(setup.a.at.r, setup.b.at.r), set.given(setup.within));
  add_rounded_box(set, faces_of_boxes(set, setup), radius);
  return set;
}

}  // namespace foresee::contact
