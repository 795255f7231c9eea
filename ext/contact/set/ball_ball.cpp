#include "contact/set/round_ball.h"
#include "contact/set/shape_pairs.h"

namespace foresee::contact {

ContactSet ball_ball_set(const Setup& setup) {
  ContactSet set;
  const int radius = set.sum(set.in_both(setup.a.at.r, setup.b.at.r), set.given(setup.within));
  add_ball(set, setup.a.layout.axes, radius);
  return set;
}

}  // namespace foresee::contact
