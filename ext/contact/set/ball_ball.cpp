#include "contact/set/round_ball.h"
#include "contact/set/shape_pairs.h"
#include "contact/set/sizes_of_both.h"

namespace foresee {

ContactSet ball_ball_set(const Setup& setup) {
  ContactSet set;
  add_ball(set, setup.a.layout.axes, radius_of_both(set, setup, setup.within));
  return set;
}

}  // namespace foresee
