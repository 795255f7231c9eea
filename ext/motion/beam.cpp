// How the bounds are made safe
// ----------------------------
// As in swept_box.cpp: with S = reach and M = |x| + |v| S + |a| S^2, the computed ends of the chord are off
// by at most 5u M, and so is every place of the path that they stand for. The bow |a| T^2 / 8 is computed
// with four roundings from a T that is itself off by at most 4u S: another 2u M at most. 16u M + (S + 4)
// 2^-1020 is more than twice the sum, underflow included. Where an object lives for a part of the horizon,
// its travel is off by the roundings of a quotient of at most 64: the moving box is wrong by a relative 2^-40
// of the travel at most, which is added.
#include "motion/beam.h"

#include "motion/life.h"

namespace foresee {
namespace {

constexpr double u = 0x1p-53;
constexpr std::size_t objects_per_check = 8192;
constexpr double shortest_part = 1.0 / 64;  // of the horizon; shorter lives stand still

struct Line {
  Ends bounds;
  double travel;
};

/// One axis; `parts` is how often the life fits into the horizon, 0 if it is too short to say.
Line line_of(double x, double v, double a, const Life& life, double parts, double size) {
  if (v == 0 && a == 0) return {grown(x, x, size), 0};
  auto place = [=](double s) { return x + s * (v + a * s * 0.5); };
  const double first = place(life.begin), last = place(life.end), time = life.end - life.begin;
  const double bow = a * time * time * 0.125, travel = (last - first) * parts;
  const double magnitude = std::abs(x) + life.reach * (std::abs(v) + std::abs(a) * life.reach);
  const double pad = 16 * u * magnitude + (life.reach + 4) * 0x1p-1020;
  const double lost = parts == 1 ? 0 : 0x1p-40 * std::abs(travel);
  return {grown(std::min(first, last) + std::min(0.0, -bow), std::max(first, last) + std::max(0.0, -bow),
                pad + size + lost),
          travel};
}

}  // namespace

template <int D>
void beams(const Bodies& bodies, std::size_t first, const Horizon& horizon, const Vec<D>& margin,
           std::span<Beam<D>> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    Beam<D>& beam = out[i];
    const Motion<D> motion = motion_of<D>(bodies, first + i);
    const Life life = life_of(motion.t, motion.until, horizon);
    if (life.none) {
      beam = {Box<D>::empty(), Vec<D>::Zero(), 0, 1};
      continue;
    }
    beam.begin = 0, beam.end = 1;
    double parts = 1;
    if (motion.t > horizon.now || motion.until - horizon.now < horizon.h) {
      const double begins = std::max(motion.t - horizon.now, 0.0);
      const double ends = std::min(motion.until - horizon.now, horizon.h);
      beam.begin = horizon.h > 0 ? std::min(begins / horizon.h, 1.0) : 0;
      beam.end = horizon.h > 0 ? std::max(ends / horizon.h, 0.0) : 1;
      parts = beam.end - beam.begin >= shortest_part ? 1 / (beam.end - beam.begin) : 0;
    }
    const Vec<D> size = half_extents_of<D>(bodies, first + i) + margin;
    for (int axis = 0; axis < D; ++axis) {
      const Line line = line_of(motion.x[axis], motion.v[axis], motion.a[axis], life, parts, size[axis]);
      beam.box.lower[axis] = line.bounds.lower;
      beam.box.upper[axis] = line.bounds.upper;
      beam.travel[axis] = line.travel;
    }
  }
}

bool all_exist_throughout(const Bodies& bodies, const Horizon& horizon, Interrupt& interrupt) {
  const Offsets& at = bodies.at;
  if (at.t == Offsets::absent && at.until == Offsets::absent && horizon.now >= 0) return true;
  bool partly = false;
  for (std::size_t i = 0; i < bodies.count && !partly; ++i) {
    if (i % objects_per_check == 0) interrupt.check();
    const double* row = bodies.row(i);
    const double t = at.t == Offsets::absent ? 0 : row[at.t];
    const bool late = t > horizon.now;
    const bool early = at.until != Offsets::absent && row[at.until] - horizon.now < horizon.h;
    partly =
        (late || early) &&
        !life_of(t, at.until == Offsets::absent ? std::numeric_limits<double>::infinity() : row[at.until],
                 horizon)
             .none;
  }
  return !partly;
}

template void beams<1>(const Bodies&, std::size_t, const Horizon&, const Vec<1>&, std::span<Beam<1>>);
template void beams<2>(const Bodies&, std::size_t, const Horizon&, const Vec<2>&, std::span<Beam<2>>);
template void beams<3>(const Bodies&, std::size_t, const Horizon&, const Vec<3>&, std::span<Beam<3>>);

}  // namespace foresee
