#include "index/paper_grid/trajectory.h"

#include <cmath>

namespace foresee {
namespace {

constexpr std::size_t objects_per_check = 4096;

template <int D>
Trajectory<D> trajectory(const Bodies& bodies, std::size_t i, const Horizon& horizon, const Vec<D>& margin) {
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
  out.room = (half_extents_of<D>(bodies, i) + margin + lost) * (1 + 0x1p-48);
  return out;
}

}  // namespace

template <int D>
std::vector<Trajectory<D>> trajectories(const Bodies& bodies, const Horizon& horizon, const Vec<D>& margin,
                                        Interrupt& interrupt) {
  std::vector<Trajectory<D>> all;
  all.reserve(bodies.count);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    if (i % objects_per_check == 0) interrupt.check();
    all.push_back(trajectory<D>(bodies, i, horizon, margin));
  }
  return all;
}

template std::vector<Trajectory<1>> trajectories<1>(const Bodies&, const Horizon&, const Vec<1>&, Interrupt&);
template std::vector<Trajectory<2>> trajectories<2>(const Bodies&, const Horizon&, const Vec<2>&, Interrupt&);
template std::vector<Trajectory<3>> trajectories<3>(const Bodies&, const Horizon&, const Vec<3>&, Interrupt&);

}  // namespace foresee
