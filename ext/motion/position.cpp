#include "motion/position.h"

#include <cmath>

namespace foresee {
namespace {

/// moment - t as head + tail, exactly (Knuth's two-sum); where head overflows there is no tail.
struct Elapsed {
  double head, tail;
};

Elapsed elapsed(double moment, double t) {
  const double head = moment - t;
  const double t_part = moment - head;
  const double moment_part = head + t_part;
  const double tail = (moment - moment_part) + (t_part - t);
  return {head, std::isfinite(tail) ? tail : 0.0};
}

}  // namespace

template <int D>
State<D> state_at(const Motion<D>& motion, double moment) {
  const Elapsed s = elapsed(moment, motion.t);
  State<D> state;
  for (int axis = 0; axis < D; ++axis) {
    const double x = motion.x[axis], v = motion.v[axis], a = motion.a[axis];
    if (v == 0 && a == 0) {
      state.x[axis] = x;
      state.v[axis] = 0;
      continue;
    }
    const double tail = s.tail * (v + a * s.head);
    state.x[axis] = (x + s.head * (v + a * s.head * 0.5)) + tail;
    state.v[axis] = v + (a * s.head + a * s.tail);
  }
  return state;
}

template State<1> state_at<1>(const Motion<1>&, double);
template State<2> state_at<2>(const Motion<2>&, double);
template State<3> state_at<3>(const Motion<3>&, double);

}  // namespace foresee
