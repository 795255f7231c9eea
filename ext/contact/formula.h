// The contact set of a pair as polynomials: a union of pieces, in each of which every polynomial is at most
// 0.
//
// A slab |x| <= H is two faces, a window's face one, a disc or ball one polynomial; what always holds is -1
// <= 0. "any" joins unions, "all" crosses them. Two conditions come with a disc or ball that change no union,
// and leave little or nothing of the time in which its roots must be sought: an accelerated pair is within
// the slabs around it, and a rounded edge or corner counts only where it is what is nearest.
#pragma once

#include <array>
#include <vector>

#include "contact/certified.h"
#include "numbers/curve.h"

namespace foresee {

/// Numbers of curves.
struct CurveNumbers {
  std::array<std::uint8_t, 6> list;
  int count = 0;

  void add(int number) { list[count++] = static_cast<std::uint8_t>(number); }
  void add(const CurveNumbers& other) {
    for (int i = 0; i < other.count; ++i) add(other.list[i]);
  }
};

/// Where all `curves` are at most 0, that of a disc or ball being the last, and all `beyond` at least 0;
/// `around` are then at most 0 too.
struct Piece {
  CurveNumbers curves, around, beyond;
};

/// At most the 3 + 12 + 8 pieces of a rounded cuboid.
struct Pieces {
  std::array<Piece, 23> list;
  int count;
};

/// Half of space: x <= bound (side 1) or -x <= bound (side -1) on one axis.
template <class T>
struct Bound {
  int axis, side;
  T bound;
};

template <class T, int D>
std::array<T, 5> bound_polynomial(const Course<T, D>& course, const Bound<T>& b) {
  const T &x = course.x[b.axis], &v = course.v[b.axis], &a = course.a[b.axis];
  if (b.side > 0) return {x - b.bound, v, a, T{}, T{}};
  return {-x - b.bound, -v, -a, T{}, T{}};
}

template <class T>
Bound<T> bound_of_face(int axis, Face which, const T& at) {
  return which == Face::upper ? Bound<T>{axis, 1, at} : Bound<T>{axis, -1, -at};
}

/// On one axis a disc or ball lies within the first; the second is the other side of a whole one, and for
/// what rounds a corner or edge where that begins.
template <class T>
std::array<Bound<T>, 2> bounds_around(const Centre<T>& c, const T& radius) {
  if (c.side == 0) return {Bound<T>{c.axis, 1, c.at + radius}, Bound<T>{c.axis, -1, radius - c.at}};
  const T outward = c.side > 0 ? c.at : -c.at;
  return {Bound<T>{c.axis, c.side, outward + radius}, Bound<T>{c.axis, c.side, outward}};
}

template <class T>
std::array<T, 5> below_zero() {
  return {T{-1.0}, T{}, T{}, T{}, T{}};
}

template <class T, int D, std::size_t N>
std::array<T, 5> ball_polynomial(const Course<T, D>& course, const std::array<Centre<T>, N>& centre,
                                 const T& radius) {
  std::array<T, 5> sum{};
  sum[0] = -(radius * radius);
  for (const Centre<T>& c : centre) {
    const T x = course.x[c.axis] - c.at, &v = course.v[c.axis], &a = course.a[c.axis];
    sum[0] = sum[0] + x * x;
    sum[1] = sum[1] + (x * v).scaled(1);
    sum[2] = sum[2] + v * v + (x * a).scaled(1);
    sum[3] = sum[3] + (v * a).scaled(1);
    sum[4] = sum[4] + a * a;
  }
  return sum;
}

/// Visits a pair kind with enclosures: collects its curves and pieces.
template <int D>
class PiecesVisitor {
 public:
  PiecesVisitor(const Course<Wide, D>& course, const PolynomialSource& source, std::vector<Curve>& curves)
      : course_(course), source_(source), curves_(curves) {}

  Pieces any(Pieces a, const Pieces& b) const {
    std::copy_n(b.list.begin(), b.count, a.list.begin() + a.count);
    a.count += b.count;
    return a;
  }
  Pieces all(const Pieces& a, const Pieces& b) const {
    Pieces joined;
    joined.count = 0;
    for (int i = 0; i < a.count; ++i)
      for (int j = 0; j < b.count; ++j) {
        Piece& piece = joined.list[joined.count++] = a.list[i];
        piece.curves.add(b.list[j].curves), piece.around.add(b.list[j].around);
        piece.beyond.add(b.list[j].beyond);
      }
    return joined;
  }

  Pieces always() { return one_piece(add(below_zero<Wide>())); }
  Pieces face(int axis, Face which, const Wide& at) { return one_piece(add(bound_of_face(axis, which, at))); }
  Pieces slab(int axis, const Wide& half) {
    Pieces pieces = one_piece(add(Bound<Wide>{axis, 1, half}));
    pieces.list[0].curves.add(add(Bound<Wide>{axis, -1, half}));
    return pieces;
  }

  template <std::size_t N>
  Pieces ball(const std::array<Centre<Wide>, N>& centre, const Wide& radius) {
    Pieces pieces = one_piece(add(ball_polynomial(course_, centre, radius)));
    Piece& piece = pieces.list[0];
    const auto& polynomial = curves_.back().rough();
    const bool bent = polynomial[3].sign() != 0 || polynomial[4].sign() != 0;
    for (const Centre<Wide>& c : centre) {
      const auto [end, other] = bounds_around(c, radius);
      bent ? piece.around.add(add(end)) : pass();
      if (c.side != 0)
        piece.beyond.add(add(other));
      else
        bent ? piece.around.add(add(other)) : pass();
    }
    return pieces;
  }

 private:
  struct Known {
    Bound<Wide> bound;
    int curve;
  };

  static Pieces one_piece(int curve) {
    Pieces pieces;
    pieces.list[0] = {};
    pieces.list[0].curves.add(curve);
    pieces.count = 1;
    return pieces;
  }

  /// Pieces share bounds. Two on one side of an axis differ by the radius, if they differ at all, and to add
  /// what is not 0 always shows in a number's bits or in its error.
  int add(const Bound<Wide>& bound) {
    for (const Known& known : known_)
      if (known.bound.axis == bound.axis && known.bound.side == bound.side &&
          identical(known.bound.bound, bound.bound)) {
        pass();
        return known.curve;
      }
    known_.push_back({bound, static_cast<int>(curves_.size())});
    return add(bound_polynomial(course_, bound));
  }

  int add(const std::array<Wide, 5>& polynomial) {
    curves_.emplace_back(polynomial, source_, calls_++);
    return static_cast<int>(curves_.size()) - 1;
  }

  /// A polynomial that needs no curve has its number all the same.
  void pass() { ++calls_; }

  const Course<Wide, D>& course_;
  const PolynomialSource& source_;
  std::vector<Curve>& curves_;
  std::vector<Known> known_;
  int calls_ = 0;  ///< polynomials asked for so far: their numbers
};

/// Visits a pair kind with exact numbers: makes the one polynomial of the given number.
template <int D>
class PolynomialVisitor {
 public:
  PolynomialVisitor(const Course<Dyadic, D>& course, int number, Polynomial& polynomial)
      : course_(course), number_(number), polynomial_(polynomial) {}

  struct Nothing {};
  Nothing all(Nothing, Nothing) const { return {}; }
  Nothing any(Nothing, Nothing) const { return {}; }

  Nothing always() {
    return made_by([] { return below_zero<Dyadic>(); });
  }
  Nothing face(int axis, Face which, const Dyadic& at) { return asked(bound_of_face(axis, which, at)); }
  Nothing slab(int axis, const Dyadic& half) {
    for (int side : {1, -1}) asked(Bound<Dyadic>{axis, side, half});
    return {};
  }
  template <std::size_t N>
  Nothing ball(const std::array<Centre<Dyadic>, N>& centre, const Dyadic& radius) {
    made_by([&] { return ball_polynomial(course_, centre, radius); });
    for (const Centre<Dyadic>& c : centre)
      for (const Bound<Dyadic>& bound : bounds_around(c, radius)) asked(bound);
    return {};
  }

 private:
  template <class Make>
  Nothing made_by(Make&& make) {
    if (calls_++ == number_) polynomial_ = Polynomial(make());
    return {};
  }
  Nothing asked(const Bound<Dyadic>& bound) {
    return made_by([&] { return bound_polynomial(course_, bound); });
  }

  const Course<Dyadic, D>& course_;
  int number_;
  Polynomial& polynomial_;
  int calls_ = 0;
};

}  // namespace foresee
