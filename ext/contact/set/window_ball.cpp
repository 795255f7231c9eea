#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"

namespace foresee::contact {

ContactSet window_ball_set(const Setup& setup) {
  ContactSet set;
  add_rounded_box(set, faces_of_window(set, setup), set.in_both(setup.a.at.r, setup.b.at.r));
  return set;
}

}  // namespace foresee::contact
