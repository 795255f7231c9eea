// Signs that hold for certain, over a stretch of time, from double arithmetic.
//
// Every primitive of contact is a polynomial p with p <= 0 meaning "inside": a slab |x| <= H (two of them), a
// window's face x >= B or x <= B, a disc or ball |x|^2 <= R^2. Seen from a moment, apart(...) answers for how
// long the primitive is certainly not met, within(...) for how long it certainly is; -1 where the sign at the
// moment itself is in doubt. Where only that sign is asked for, now_apart(...) and now_within(...) save the
// square roots. Only values at one moment and their error bounds are used: roots are never trusted, only
// stayed short of.
//
// Sizes (H, R, B, offsets) are sums of at most four numbers of one sign: within 4u of the exact sum.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "contact/relative.h"

namespace foresee {

constexpr double not_certain = -1;
constexpr double for_ever = std::numeric_limits<double>::infinity();

/// s such that p0 + p1 t + p2 t^2 > 0 for all t in [0, s). Requires p0 > 0. NaN and overflow give 0.
inline double positive_for(double p0, double p1, double p2) {
  if (p1 >= 0 && p2 >= 0) return for_ever;
  const double square = p1 * p1, product = 4 * p2 * p0;
  // The discriminant is raised by more than it can be off, so that a root is never missed and never overshot.
  const double raised = square - product + 8 * unit_roundoff * (square + std::abs(product)) + 0x1p-1000;
  if (raised < 0) return for_ever;
  if (!(raised < for_ever)) return 0;
  constexpr double less = 1 - 32 * unit_roundoff;
  // With p1 > 0 (and p2 < 0) nothing cancels in either sum; what underflow may have added is taken off.
  if (p1 > 0) return less * ((p1 + std::sqrt(std::max(0.0, square - product - 0x1p-1070))) / (-2 * p2));
  return less * (2 * p0 / (std::sqrt(raised) - p1));
}

inline double slab_error(const AxisView& w, double half) {
  return w.ep + 8 * unit_roundoff * (std::abs(w.p) + half);
}

inline bool slab_now_apart(const AxisView& w, double half) {
  return std::abs(w.p) - half - slab_error(w, half) > 0;
}

inline bool slab_now_within(const AxisView& w, double half) {
  return half - std::abs(w.p) - slab_error(w, half) > 0;
}

/// |x| > H
inline double slab_apart(const AxisView& w, double half) {
  const double side = w.p >= 0 ? 1 : -1;
  const double p0 = std::abs(w.p) - half - slab_error(w, half);
  if (!(p0 > 0)) return not_certain;
  return positive_for(p0, side * w.q - w.eq, side * w.a - w.ea);
}

/// |x| <= H
inline double slab_within(const AxisView& w, double half) {
  const double error = slab_error(w, half);
  const double below = (half - w.p) - error, above = (half + w.p) - error;
  if (!(below > 0 && above > 0)) return not_certain;
  const double until_high = positive_for(below, -w.q - w.eq, -w.a - w.ea);
  const double until_low = positive_for(above, w.q - w.eq, w.a - w.ea);
  return until_high < until_low ? until_high : until_low;
}

/// One face of a window: inside is x >= bound (lower) or x <= bound (upper).
enum class Face : std::uint8_t { lower, upper };

/// How far outside the face, and how much that can be off.
inline double face_gap(const AxisView& w, Face which, double bound) {
  return which == Face::upper ? w.p - bound : bound - w.p;
}

inline bool face_now_apart(const AxisView& w, Face which, double bound) {
  return face_gap(w, which, bound) - slab_error(w, std::abs(bound)) > 0;
}

inline bool face_now_within(const AxisView& w, Face which, double bound) {
  return -face_gap(w, which, bound) - slab_error(w, std::abs(bound)) > 0;
}

inline double face_apart(const AxisView& w, Face which, double bound) {
  const double side = which == Face::upper ? 1 : -1;
  const double p0 = face_gap(w, which, bound) - slab_error(w, std::abs(bound));
  if (!(p0 > 0)) return not_certain;
  return positive_for(p0, side * w.q - w.eq, side * w.a - w.ea);
}

inline double face_within(const AxisView& w, Face which, double bound) {
  const double side = which == Face::upper ? -1 : 1;
  const double p0 = -face_gap(w, which, bound) - slab_error(w, std::abs(bound));
  if (!(p0 > 0)) return not_certain;
  return positive_for(p0, side * w.q - w.eq, side * w.a - w.ea);
}

/// f(s) = |x + q s + a s^2|^2 - R^2 seen from a moment: f + f1 s + c2 s^2 + c3 s^3 + c4 s^4, with error
/// bounds.
struct BallView {
  double f, f1, c2, c3, c4;
  double ef, e1, e2, e3, e4;
};

/// One axis of a disc or ball: the axis and the coordinate of the ball's centre on it. Around an edge or
/// corner `side` tells where a box ends there: at its upper face (1) or at its lower (-1).
template <class T>
struct Centre {
  int axis;
  T at;
  int side = 0;
};

template <int Degree, int D, std::size_t N>
BallView ball_view(const AxisView (&view)[D], const std::array<Centre<double>, N>& centre, double radius,
                   double underflow) {
  constexpr double u = unit_roundoff;
  BallView b{};
  double square = 0, slope = 0, mass = 0;
  for (const Centre<double>& c : centre) {
    const AxisView& w = view[c.axis];
    const double p = w.p - c.at, ep = w.ep + 8 * u * (std::abs(w.p) + std::abs(c.at));
    square += p * p;
    b.ef += ep * (2 * std::abs(p) + ep);
    slope += p * w.q;
    b.e1 += 2 * (std::abs(p) * w.eq + ep * (std::abs(w.q) + w.eq)) + 12 * u * std::abs(p * w.q);
    mass += w.q * w.q;
    b.e2 += w.eq * (2 * std::abs(w.q) + w.eq);
    if constexpr (Degree == 2) {
      b.c2 += 2 * p * w.a;
      b.e2 += 2 * (std::abs(p) * w.ea + ep * (std::abs(w.a) + w.ea)) + 16 * u * std::abs(p * w.a);
      b.c3 += 2 * w.q * w.a;
      b.e3 += 2 * (std::abs(w.q) * w.ea + w.eq * (std::abs(w.a) + w.ea)) + 12 * u * std::abs(w.q * w.a);
      b.c4 += w.a * w.a;
      b.e4 += w.ea * (2 * std::abs(w.a) + w.ea);
    }
  }
  b.f = square - radius * radius;
  b.ef += 16 * u * (square + radius * radius) + 0x1p-1070 + underflow;
  b.f1 = 2 * slope;
  b.e1 += 0x1p-1070;
  b.c2 += mass;
  b.e2 += 12 * u * mass + 0x1p-1070;
  b.e3 += 0x1p-1070;
  b.e4 += 12 * u * b.c4 + 0x1p-1070;
  return b;
}

/// Least value that c2 + c3 s + c4 s^2 (c4 >= 0) certainly keeps on [0, length].
inline double least_bend(double c2, double c3, double c4, double length) {
  const double slack = 16 * unit_roundoff * (std::abs(c2) + length * (std::abs(c3) + length * std::abs(c4)));
  const double at_end = c2 + length * (c3 + length * c4);
  double least = std::min(c2, at_end);
  // Its lowest point. A square of c3 could vanish where this does not.
  if (c3 < 0 && -c3 < 2 * c4 * length) least = std::min(least, c2 - c3 * (0.25 * (c3 / c4)));
  return least - slack;
}

/// s up to which f0 + f1 s + (bend on [0, length]) s^2 stays positive, looked for with ever shorter lengths.
template <class Bend>
double bent_positive_for(double f0, double f1, double room, Bend bend) {
  double best = 0;
  double length = room;
  for (int attempt = 0; attempt < 6; ++attempt) {
    const double step = std::min(positive_for(f0, f1, bend(length)), length);
    best = std::max(best, step);
    if (!(step < 0.125 * length) || step <= 0) break;
    length = 4 * step;
  }
  return best;
}

inline bool ball_now_apart(const BallView& b) {
  return b.f - b.ef > 0;
}

inline bool ball_now_within(const BallView& b) {
  return -b.f - b.ef > 0;
}

/// |x| > R during the next `room`; the answer may exceed `room` only by being for ever.
template <int Degree>
double ball_apart(const BallView& b, double room) {
  const double f0 = b.f - b.ef;
  if (!(f0 > 0)) return not_certain;
  if constexpr (Degree < 2) return positive_for(f0, b.f1 - b.e1, b.c2 - b.e2);
  const double step = bent_positive_for(f0, b.f1 - b.e1, room, [&b](double length) {
    return least_bend(b.c2 - b.e2, b.c3 - b.e3, std::max(0.0, b.c4 - b.e4), length);
  });
  return step < room ? step : for_ever;
}

/// |x| <= R
template <int Degree>
double ball_within(const BallView& b, double room) {
  const double f0 = -b.f - b.ef;
  if (!(f0 > 0)) return not_certain;
  if constexpr (Degree < 2) return positive_for(f0, -b.f1 - b.e1, -b.c2 - b.e2);
  const double step = bent_positive_for(f0, -b.f1 - b.e1, room, [&b](double length) {
    // Convex in s, so the greatest bend is at one of the ends.
    const double c2 = b.c2 + b.e2;
    const double slack = 16 * unit_roundoff * (std::abs(c2) + length * (std::abs(b.c3) + length * b.c4));
    return -(std::max(c2, c2 + length * (b.c3 + b.e3 + length * (b.c4 + b.e4))) + slack);
  });
  return step < room ? step : for_ever;
}

}  // namespace foresee
