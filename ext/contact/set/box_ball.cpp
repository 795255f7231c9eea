#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"
#include "contact/set/sizes_of_both.h"

namespace foresee {

ContactSet box_ball_set(const Setup& setup) {
  ContactSet set;
  add_rounded_box(set, faces_of_boxes(set, setup), radius_of_both(set, setup, setup.within));
  return set;
}

}  // namespace foresee
