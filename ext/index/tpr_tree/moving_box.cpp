#include "index/tpr_tree/moving_box.h"

namespace foresee {

template <int D>
MovingBox<D> moving_window(const Vec<D>& lower, const Vec<D>& upper, const Vec<D>& velocity,
                           const Horizon& horizon) {
  const double infinity = std::numeric_limits<double>::infinity(), reach = horizon.h + shortest_reach;
  MovingBox<D> box{lower, upper, velocity, velocity, {0, horizon.h}};
  auto round_outward = [&](Vec<D>& face, Vec<D>& speed) {
    face = lower_end<D>(face, (face.abs() + speed.abs() * reach) * rounding_pad + smallest_pad);
    speed = (face >= -largest_bound).select(speed, 0.0);
    face = (speed.abs() * std::max(1.0, reach) <= largest_bound).select(face, -infinity);
    speed = (face >= -largest_bound).select(speed, 0.0);
  };
  round_outward(box.lower, box.v_lower);
  box.upper = -box.upper, box.v_upper = -box.v_upper;
  round_outward(box.upper, box.v_upper);
  box.upper = -box.upper, box.v_upper = -box.v_upper;
  return box;
}

template MovingBox<1> moving_window(const Vec<1>&, const Vec<1>&, const Vec<1>&, const Horizon&);
template MovingBox<2> moving_window(const Vec<2>&, const Vec<2>&, const Vec<2>&, const Horizon&);
template MovingBox<3> moving_window(const Vec<3>&, const Vec<3>&, const Vec<3>&, const Horizon&);

}  // namespace foresee
