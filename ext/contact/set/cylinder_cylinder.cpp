#include "contact/set/round_ball.h"
#include "contact/set/shape_pairs.h"
#include "contact/set/sizes_of_both.h"

namespace foresee {

ContactSet cylinder_cylinder_set(const Setup& setup) {
  ContactSet set;
  const Size radius = radius_of_both(set, setup, setup.within),
             height = height_of_both(set, setup, setup.within_z);
  const Faces along_z{.axis = 2, .below = height, .above = height};
  add_ball(set, 2, radius, &along_z);
  return set;
}

}  // namespace foresee
