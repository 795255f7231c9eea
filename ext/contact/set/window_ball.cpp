#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"
#include "contact/set/sizes_of_both.h"

namespace foresee {

ContactSet window_ball_set(const Setup& setup) {
  ContactSet set;
  add_rounded_box(set, faces_of_window(set, setup), radius_of_both(set, setup, 0));
  return set;
}

}  // namespace foresee
