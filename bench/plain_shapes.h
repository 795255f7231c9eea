// First contact of two shapes by a textbook in plain double, one class per pair of shapes.
//
//   const BoxAndBox<2, 2> touch(ships.at, ships.at, 3.0);
//   const double t = touch.first<true>(ships.row(0), ships.row(1));      // -1: never
//
// first<false>() gives some time of contact in place of the first: enough to decide.
#pragma once

#include <algorithm>
#include <limits>

#include "plain_spans.h"
#include "plain_square.h"

namespace foresee::bench {

/// The next axis is tested only if the axes before leave any time.
template <int D, int Degree>
class BoxAndBox {
 public:
  BoxAndBox(const Offsets& at_a, const Offsets& at_b, double h) : at_(at_a), half_b_(at_b.half), h_(h) {}

  template <bool>
  double first(const double* a, const double* b) const {
    const PlainPair<D, Degree> pair{a, b, at_};
    Spans<D> spans = Spans<D>::all(h_);
    for (int j = 0; j < D; ++j) {
      spans = keep_within(spans, pair, j, a[at_.half + j] + b[half_b_ + j]);
      if (spans.count == 0) return -1;
    }
    return spans.first();
  }

 private:
  Offsets at_;
  int half_b_;
  double h_;
};

/// Discs and balls.
template <int D, int Degree>
class BallAndBall {
 public:
  BallAndBall(const Offsets& at_a, const Offsets& at_b, double h) : at_(at_a), r_b_(at_b.r), h_(h) {}

  template <bool Timed>
  double first(const double* a, const double* b) const {
    const PlainPair<D, Degree> pair{a, b, at_};
    const double r = a[at_.r] + b[r_b_];
    PlainSquare<Degree> square(-r * r);
    for (int j = 0; j < D; ++j) square.add(pair.x(j), pair.v(j), pair.turn(j));
    return square.template first_within<Timed>(0, h_);
  }

 private:
  Offsets at_;
  int r_b_;
  double h_;
};

/// Upright: intervals along z and, while those meet, discs in x and y.
template <int Degree>
class CylinderAndCylinder {
 public:
  CylinderAndCylinder(const Offsets& at_a, const Offsets& at_b, double h) : at_(at_a), at_b_(at_b), h_(h) {}

  template <bool Timed>
  double first(const double* a, const double* b) const {
    const PlainPair<3, Degree> pair{a, b, at_};
    const Spans<3> spans = keep_within(Spans<3>::all(h_), pair, 2, a[at_.hz] + b[at_b_.hz]);
    if (spans.count == 0) return -1;
    const double r = a[at_.r] + b[at_b_.r];
    PlainSquare<Degree> square(-r * r);
    for (int j = 0; j < 2; ++j) square.add(pair.x(j), pair.v(j), pair.turn(j));
    for (int i = 0; i < spans.count; ++i) {  // one axis leaves them in order
      const double t = square.template first_within<Timed>(spans.begin[i], spans.end[i]);
      if (t >= 0) return t;
    }
    return -1;
  }

 private:
  Offsets at_, at_b_;
  double h_;
};

/// Two axes, a the box: the disc's centre is in the box inflated by r along x, or along y, or within r of a
/// corner. The corners are tested only while it is in the box inflated along both axes.
template <int Degree>
class BoxAndDisc {
 public:
  BoxAndDisc(const Offsets& at_a, const Offsets& at_b, double h) : at_(at_a), r_b_(at_b.r), h_(h) {}

  template <bool Timed>
  double first(const double* a, const double* b) const {
    const PlainPair<2, Degree> pair{a, b, at_};
    const double r = b[r_b_], *half = a + at_.half;
    const Spans<2> wide = keep_within(Spans<2>::all(h_), pair, 0, half[0] + r);
    if (wide.count == 0) return -1;
    const Spans<2> grown = keep_within(wide, pair, 1, half[1] + r);
    if (grown.count == 0) return -1;
    double first = std::numeric_limits<double>::infinity();
    for (int j = 0; j < 2; ++j) {
      const Spans<2> side = keep_within(grown, pair, j, half[j]);
      if (side.count > 0) first = std::min(first, side.first());
    }
    if (first == grown.first() || (!Timed && first <= h_)) return first;
    for (const double x : {-half[0], half[0]})
      for (const double y : {-half[1], half[1]})
        first = std::min(first, at_corner<Timed>(pair, x, y, r, grown));
    return first <= h_ ? first : -1;
  }

 private:
  /// Infinite for never.
  template <bool Timed>
  static double at_corner(const PlainPair<2, Degree>& pair, double x, double y, double r,
                          const Spans<2>& grown) {
    PlainSquare<Degree> square(-r * r);
    square.add(pair.x(0) - x, pair.v(0), pair.turn(0));
    square.add(pair.x(1) - y, pair.v(1), pair.turn(1));
    double first = std::numeric_limits<double>::infinity();
    for (int i = 0; i < grown.count; ++i) {
      const double t = square.template first_within<Timed>(grown.begin[i], grown.end[i]);
      if (t >= 0) first = std::min(first, t);
    }
    return first;
  }

  Offsets at_;
  int r_b_;
  double h_;
};

}  // namespace foresee::bench
