// Position and velocity of an intruder at the first time of the object, in dyadic numbers.
#include "base/axes.h"
#include "contact/set/relative_motion.h"
#include "numbers/dyadic.h"
#include "query/avoid/exact_avoidance.h"

namespace foresee {

ExactAvoidance::InitialState ExactAvoidance::initial_state(const std::vector<double>& record,
                                                           const Intruder& intruder) {
  take(record);
  const Bodies own = own_.bodies(), others = near_[static_cast<std::size_t>(intruder.table)]->bodies();
  const double *own_row = own.row(0), *row = others.row(intruder.row);
  const auto is = [&](Shape shape) { return own.layout.shape == shape || others.layout.shape == shape; };
  const bool upright = is(Shape::cylinder) || question_.within_z.has_value();
  const bool round = own.layout.axes > 1 && !is(Shape::box) && !is(Shape::outline) && !is(Shape::mesh) &&
                     !grows(own.layout) && !grows(others.layout);
  const Dyadic reach = Dyadic(value_or(own_row, own.at.r, 0)) + Dyadic(value_or(row, others.at.r, 0)) +
                       Dyadic(question_.within);
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
