#include "contact/set/round_ball.h"
#include "contact/set/shape_pairs.h"

namespace foresee::contact {

ContactSet cylinder_cylinder_set(const Setup& setup) {
  ContactSet set;
  const int radius = set.sum(set.in_both(setup.a.at.r, setup.b.at.r), set.given(setup.within));
  const int height = set.sum(set.in_both(setup.a.at.hz, setup.b.at.hz), set.given(setup.within_z));
  const Faces along_z{.axis = 2, .below = height, .above = height};
  add_ball(set, 2, radius, &along_z);
  return set;
}

}  // namespace foresee::contact
