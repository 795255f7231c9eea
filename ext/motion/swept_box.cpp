// How the bounds are made safe
// ----------------------------
// On one axis the centre is f(s) = x + s (v + a s / 2) for the time s since the object's own t, and s runs
// over [s0, s1] with 0 <= s0, s1 <= S = |now - t| + h. The extremes of f are at s0, at s1, or at the turning
// point -v/a if it lies between; clamping the turning point into [s0, s1] makes it right to look at all three
// always.
//
// What plain double arithmetic can lose, with u = 2^-53 (doubled, so that it holds in every rounding mode)
// and M = |x| + |v| S + |a| S^2:
//  - s0 and s1 come from at most two roundings: each is off by at most 2u S, which moves f by at most
//    (|v| + |a| S) 2u S <= 2u M. This covers a minimum taken with until, and a turning point clamped to an
//    end that is itself off.
//  - Evaluating f: x goes through one rounding, v s through three, a s^2 / 2 through four: at most 3u M.
//  - The turning point is off by u|v/a|; as f is flat there, that moves f by u^2 |a| S^2 only.
//  - Underflow: each of a s, a s / 2 and the product with s loses at most 2^-1074: together (S + 4) 2^-1073.
// 16u M + (S + 4) 2^-1020 is more than twice the sum, which leaves room for the roundings of the pad itself.
// The power of two is a normal number on purpose: smaller ones cost processors a hundred cycles each.
#include "motion/swept_box.h"

#include <algorithm>
#include <cmath>

#include "motion/float_environment.h"
#include "motion/life.h"

namespace foresee {
namespace {

constexpr double u = 0x1p-53;
constexpr std::size_t objects_per_check = 4096;

/// What the centre covers on one axis; `size` is half extent and margin together.
Ends swept_axis(double x, double v, double a, const Life& life, double size) {
  if (v == 0 && a == 0) return grown(x, x, size);
  auto place = [=](double s) { return x + s * (v + a * s * 0.5); };
  const double first = place(life.begin), last = place(life.end);
  double lower = std::min(first, last), upper = std::max(first, last);
  if (a != 0) {
    const double turn = place(std::clamp(-v / a, life.begin, std::max(life.begin, life.end)));
    lower = std::min(lower, turn);
    upper = std::max(upper, turn);
  }
  const double reach = life.reach;
  const double magnitude = std::abs(x) + reach * (std::abs(v) + std::abs(a) * reach);
  const double pad = 16 * u * magnitude + (reach + 4) * 0x1p-1020;
  // A sum with infinity or NaN anywhere in it is not finite, and then neither bound is.
  return grown(lower, upper, pad + size + (first - first) + (last - last));
}

/// Half extents of a box within an object's shape.
template <int D>
Vec<D> inner_half_extents_of(const Bodies& bodies, std::size_t i) {
  constexpr double below_root[] = {1, 1, 0.7071, 0.5773};  // of 1/axes
  const Vec<D> half = half_extents_of<D>(bodies, i);
  if (bodies.layout.shape == Shape::ball) return half * below_root[D];
  if (bodies.layout.shape != Shape::cylinder) return half;
  Vec<D> inner = half * below_root[2];
  inner[D - 1] = half[D - 1];
  return inner;
}

}  // namespace

template <int D>
Box<D> core_box(const Bodies& bodies, std::size_t i, double now) {
  const Motion<D> motion = motion_of<D>(bodies, i);
  const Life life = life_of(motion.t, motion.until, {now, 0});
  if (life.none) return Box<D>::empty();
  const Vec<D> half = inner_half_extents_of<D>(bodies, i);
  Box<D> box;
  for (int axis = 0; axis < D; ++axis) {
    const Ends centre = swept_axis(motion.x[axis], motion.v[axis], motion.a[axis], life, 0);
    const double lower = centre.upper - half[axis], upper = centre.lower + half[axis];
    box.lower[axis] = lower + 4 * u * std::abs(lower);
    box.upper[axis] = upper - 4 * u * std::abs(upper);
    if (!std::isfinite(box.upper[axis] - box.lower[axis])) return Box<D>::empty();
  }
  return box.is_empty() ? Box<D>::empty() : box;
}

template <int D>
Box<D> swept_box(const Bodies& bodies, std::size_t i, const Horizon& horizon, const Vec<D>& margin) {
  const Motion<D> motion = motion_of<D>(bodies, i);
  const Life life = life_of(motion.t, motion.until, horizon);
  if (life.none) return Box<D>::empty();
  const Vec<D> half = half_extents_of<D>(bodies, i);
  Box<D> box;
  for (int axis = 0; axis < D; ++axis) {
    const Ends bounds =
        swept_axis(motion.x[axis], motion.v[axis], motion.a[axis], life, half[axis] + margin[axis]);
    box.lower[axis] = bounds.lower;
    box.upper[axis] = bounds.upper;
  }
  return box;
}

template <int D>
std::vector<Box<D>> swept_boxes(const Bodies& bodies, const Horizon& horizon, const Vec<D>& margin,
                                Interrupt& interrupt) {
  const FloatEnvironment environment;
  std::vector<Box<D>> boxes;
  boxes.reserve(bodies.count);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    if (i % objects_per_check == 0) interrupt.check();
    boxes.push_back(swept_box<D>(bodies, i, horizon, margin));
  }
  return boxes;
}

template Box<1> core_box<1>(const Bodies&, std::size_t, double);
template Box<1> swept_box<1>(const Bodies&, std::size_t, const Horizon&, const Vec<1>&);
template Box<2> core_box<2>(const Bodies&, std::size_t, double);
template Box<2> swept_box<2>(const Bodies&, std::size_t, const Horizon&, const Vec<2>&);
template Box<3> core_box<3>(const Bodies&, std::size_t, double);
template Box<3> swept_box<3>(const Bodies&, std::size_t, const Horizon&, const Vec<3>&);
template std::vector<Box<1>> swept_boxes<1>(const Bodies&, const Horizon&, const Vec<1>&, Interrupt&);
template std::vector<Box<2>> swept_boxes<2>(const Bodies&, const Horizon&, const Vec<2>&, Interrupt&);
template std::vector<Box<3>> swept_boxes<3>(const Bodies&, const Horizon&, const Vec<3>&, Interrupt&);

}  // namespace foresee
