#include "index/paper_grid/trajectory.h"

#include <cmath>

namespace foresee {

template <int D>
Trajectory<D> trajectory_of(const Bodies& bodies, std::size_t i, const Horizon& horizon,
                            const Vec<D>& margin) {
  const Motion<D> motion = motion_of<D>(bodies, i);
  Trajectory<D> out;
  out.swept = swept_box<D>(bodies, i, horizon, margin);
  out.span = span_between(motion.t, motion.until, horizon);
  const double since = horizon.now - motion.t, reach = std::abs(since) + horizon.h;
  out.a = motion.a;
  out.v = motion.v + motion.a * since;
  out.x = motion.x + since * (motion.v + motion.a * (since * 0.5));
  const Vec<D> magnitude = motion.x.abs() + reach * (motion.v.abs() + motion.a.abs() * reach);
  const Vec<D> lost = magnitude * 0x1p-48 + (reach + 4) * 0x1p-1020;
  out.room = (reach_of(largest_extents<D>(bodies, i, horizon)) + margin + lost) * (1 + 0x1p-48);
  return out;
}

template Trajectory<1> trajectory_of<1>(const Bodies&, std::size_t, const Horizon&, const Vec<1>&);
template Trajectory<2> trajectory_of<2>(const Bodies&, std::size_t, const Horizon&, const Vec<2>&);
template Trajectory<3> trajectory_of<3>(const Bodies&, std::size_t, const Horizon&, const Vec<3>&);

}  // namespace foresee
