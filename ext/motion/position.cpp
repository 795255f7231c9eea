#include "motion/position.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace foresee {
namespace {

/// time - t as head + tail, exactly (Knuth's two-sum); the tail is 0 if the head overflows.
struct Elapsed {
  double head, tail;
};

Elapsed elapsed(double time, double t) {
  const double head = time - t;
  const double t_part = time - head;
  const double time_part = head + t_part;
  const double tail = (time - time_part) + (t_part - t);
  return {head, std::isfinite(tail) ? tail : 0.0};
}

/// fraction * 2^exponent: a product that may exceed a double's range.
struct Scaled {
  double fraction = 1;
  int exponent = 0;

  Scaled operator*(double factor) const {
    int more, carry;
    const double part = std::frexp(factor, &more);
    const double product = std::frexp(fraction * part, &carry);
    return {product, exponent + more + carry};
  }
};

/// The sum; infinite only if no double holds it.
double sum_of(std::initializer_list<Scaled> terms) {
  int greatest = std::numeric_limits<int>::min();
  for (const Scaled& term : terms)
    if (term.fraction != 0) greatest = std::max(greatest, term.exponent);
  double sum = 0;
  for (const Scaled& term : terms)
    if (term.fraction != 0) sum += std::ldexp(term.fraction, term.exponent - greatest);
  return std::ldexp(sum, sum == 0 ? 0 : greatest);
}

/// Position and velocity on one axis where a term or the elapsed time overflows.
void place_far(double x, double v, double a, double time, double t, double& place, double& velocity) {
  const double half = 0.5 * time - 0.5 * t;  // of the elapsed time
  const Scaled one;
  place = sum_of({one * x, one * v * half * 2.0, one * a * half * half * 2.0});
  velocity = sum_of({one * v, one * a * half * 2.0});
}

}  // namespace

template <int D>
State<D> state_at(const Motion<D>& motion, double time) {
  const Elapsed s = elapsed(time, motion.t);
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
    if (!std::isfinite(state.x[axis]) || !std::isfinite(state.v[axis]))
      place_far(x, v, a, time, motion.t, state.x[axis], state.v[axis]);
  }
  return state;
}

template State<1> state_at<1>(const Motion<1>&, double);
template State<2> state_at<2>(const Motion<2>&, double);
template State<3> state_at<3>(const Motion<3>&, double);

}  // namespace foresee
