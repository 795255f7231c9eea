#include "accuracy/pair_drafts.h"

#include <cmath>

namespace foresee::bench {
namespace {

double total(const Draft& d, int j) {
  return d.half[0][j] + d.half[1][j];
}

/// One random number per statement: the order in which arguments are evaluated is the compiler's choice.
void drift(Maker& m, Draft& d, double t0, double places, double speeds) {
  for (int j = 0; j < 3; ++j) {
    const double place = m.lattice(places), speed = m.lattice(speeds);
    m.pass(d, j, place, t0, speed, 0);
  }
}

}  // namespace

Draft sparse(Maker& m) {
  return m.anything(16, 3, 0.5);
}
Draft dense(Maker& m) {
  return m.anything(3, 3, 0.5);
}
Draft accelerated(Maker& m) {
  return m.anything(4, 3, 1e9);
}

Draft graze(Maker& m) {
  Draft d = m.plain();
  const double t0 = m.time();
  const int axis = static_cast<int>(m.random.below(3));
  drift(m, d, t0, 0.5, 0.5);
  const double side = m.chance(2) ? 1 : -1, bend = 0.25 + std::abs(m.lattice(2));
  m.pass(d, axis, side * total(d, axis), t0, 0, side * bend);
  return d;
}

Draft simultaneous(Maker& m) {
  Draft d = m.plain();
  const double t0 = m.time();
  drift(m, d, t0, 0.5, 0.25);
  const int leaves = static_cast<int>(m.random.below(3)), enters = (leaves + 1) % 3;
  const double out = 0.5 + std::abs(m.lattice(2)), in = 0.5 + std::abs(m.lattice(2));
  const double bend_out = m.lattice(0.25), bend_in = m.lattice(0.25);
  m.pass(d, leaves, total(d, leaves), t0, out, bend_out);
  m.pass(d, enters, total(d, enters), t0, -in, bend_in);
  return d;
}

/// Radii 5 k in all, b passing 3 k, 4 k to the side: the distance is smallest, and exactly 5 k, at t0.
Draft tangent(Maker& m) {
  Draft d = m.plain();
  const double t0 = m.time(), k = 0.125 * static_cast<double>(1 + m.random.below(4));
  d.r[0] = k, d.r[1] = 4 * k;
  const double speed = 0.25 + std::abs(m.lattice(1)), bend = std::abs(m.lattice(0.5));
  const double climb = m.lattice(1), turn = m.lattice(0.5);
  m.pass(d, 0, 3 * k, t0, -4 * speed, 3 * bend);
  m.pass(d, 1, 4 * k, t0, 3 * speed, 4 * bend);
  m.pass(d, 2, 0, t0, climb, turn);
  return d;
}

Draft in_out_in(Maker& m) {
  Draft d = m.anything(8, 1, 0.25);
  const double size = d.r[0] + d.r[1], t0 = m.random.in(0.3, 0.7) * m.h;
  const double depth = m.random.in(1.01, 1.5), bend = m.random.in(4, 8);
  m.pass(d, 0, -size * depth, t0, 0, bend);
  for (int j = 1; j < 3; ++j) {
    const double aside = m.random.in(-0.4, 0.4), speed = m.random.in(-0.1, 0.1);
    m.pass(d, j, size * aside, t0, speed, 0);
  }
  return d;
}

Draft meeting_points(Maker& m) {
  Draft d = m.plain();
  const double t0 = m.time();
  d.r[0] = m.chance(16) ? 0.0625 : 0;
  for (int j = 0; j < 3; ++j) {
    d.half[0][j] = d.half[1][j] = 0;
    const double place = m.chance(16) ? 0.0625 : 0, speed = m.lattice(2), bend = m.lattice(1);
    m.pass(d, j, place, t0, speed, bend);
  }
  return d;
}

Draft still(Maker& m) {
  Draft d = m.plain();
  const bool touching = m.chance(2);
  for (int j = 0; j < 3; ++j) d.to_x[j] = m.lattice(1.5);
  const double size = d.half[0][0] + d.half[1][0];
  if (touching) d.to_x[0] = size;
  d.r[0] = d.half[0][0], d.r[1] = d.half[1][0];
  return d;
}

Draft near_parallel(Maker& m) {
  Draft d = m.anything(8, 3, 0);
  for (int j = 0; j < 3; ++j) {
    d.to_v[j] = m.random.in(-1e-7, 1e-7);
    d.to_a[j] = m.random.in(-1e-15, 1e-15);
  }
  return d;
}

Draft far_away(Maker& m) {
  Draft d = m.plain(16);
  for (int j = 0; j < 3; ++j) {
    d.x[j] = 1e15 + std::floor(d.x[j] * 2), d.to_x[j] = std::floor(m.lattice(8));
    d.to_v[j] = m.lattice(6), d.to_a[j] = m.lattice(2);
  }
  d.r[0] = d.half[0][0], d.r[1] = d.half[1][0];
  return d;
}

Draft cancelling(Maker& m) {
  Draft d = m.plain();
  for (int j = 0; j < 3; ++j) m.pass(d, j, 0, 0, 0, 0);
  d.to_x[0] = total(d, 0) * (1 + 0x1p-30);
  d.to_v[0] = -1e7 * m.random.in(1, 2);
  d.to_a[0] = m.random.in(0.5, 1);
  return d;
}

Draft mixed(Maker& m) {
  Draft d = m.anything(8, 3, 1);
  auto shift = [&](double& value) { value = std::ldexp(value, static_cast<int>(m.random.below(61)) - 30); };
  for (int j = 0; j < 3; ++j) {
    shift(d.to_x[j]), shift(d.to_v[j]), shift(d.to_a[j]);
    shift(d.half[0][j]), shift(d.half[1][j]);
  }
  shift(d.r[0]), shift(d.r[1]);
  return d;
}

/// Millimetres at ten kilometres a second: an encounter lasts less than a microsecond.
Draft unix_times(Maker& m) {
  Draft d = m.anything(1e-2, 1e4, 10);
  const double meet = m.random.in(0, m.h);
  for (int j = 0; j < 3; ++j) {
    d.to_x[j] = m.random.in(-3e-3, 3e-3) - d.to_v[j] * meet - d.to_a[j] * meet * meet / 2;
    d.half[0][j] = d.half[1][j] = 1e-3;
  }
  d.r[0] = d.r[1] = 1e-3;
  return d;
}

}  // namespace foresee::bench
