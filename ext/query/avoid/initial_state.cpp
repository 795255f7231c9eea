// Position and velocity of an intruder at the first time of the object, in dyadic numbers.
#include "base/axes.h"
#include "contact/minkowski/relative_motion.h"
#include "numbers/dyadic.h"
#include "query/avoid/exact_avoidance.h"

namespace foresee {

ExactAvoidance::InitialState ExactAvoidance::initial_state(const std::vector<double>& record,
                                                           const Intruder& intruder) {
  take(record);
  const Bodies own = own_.bodies(), others = near_[static_cast<std::size_t>(intruder.table)]->bodies();
  const double *own_row = own.row(0), *row = others.row(intruder.row);
  const PairRule rule(own.layout, others.layout, question_.within, question_.within_z);
  const bool upright = rule.distance == Distance::upright;
  const bool round = rule.distance != Distance::per_axis && rule.pieces == PieceKind::none &&
                     !rule.has_extent(0) && !rule.grows;
  const auto reach = size_as_of_t<Dyadic>(rule.radius, own_row, row);
  Dyadic gap = -(reach * reach);
  InitialState state;
  const auto take_nearest = [](const Dyadic& exact, double& nearest, double& error) {
    nearest = rounded(exact);
    const Dyadic left = exact - Dyadic(nearest);
    error = left.sign() == 0 ? 0 : std::abs(rounded(left)) * (1 + 0x1p-50);
  };
  with_axes(own.layout.axes, [&]<int D>(Axes<D>) {
    const auto relative = relative_motion_of<Dyadic, D>({own, others, {start_, 0}}, own_row, row);
    for (std::size_t axis = 0; axis < D; ++axis) {
      take_nearest(relative.x[axis], state.x[axis], state.ex[axis]);
      const AxisMotion<double> mine = axis_motion(own, own_row, static_cast<int>(axis));
      take_nearest(relative.v[axis] + Dyadic(mine.v), state.v[axis], state.ev[axis]);
      if (!upright || axis < 2) gap = gap + relative.x[axis] * relative.x[axis];
    }
  });
  if (round && gap.sign() > 0) state.square_gap = rounded(gap) * (1 - 0x1p-50);
  return state;
}

}  // namespace foresee
