// The contact set of a pair as polynomials: a union of pieces, in each of which every polynomial is at most
// 0.
//
// A slab |x| <= H is two polynomials, a window's face one, a disc or ball one; what always holds is -1 <= 0.
// "any" joins unions, "all" crosses them. A disc or ball of an accelerated pair is preceded by the slabs
// around it: they change no set, but their roots are quadratic, and mostly they leave little or nothing of
// the time in which those of a quartic must be sought.
#pragma once

#include <array>
#include <vector>

#include "contact/certified.h"
#include "contact/curve.h"

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

/// Where all `curves` are at most 0, that of a disc or ball being the last; `around` are then at most 0 too.
struct Piece {
  CurveNumbers curves, around;
};

/// At most the 3 + 12 + 8 pieces of a rounded cuboid.
struct Pieces {
  std::array<Piece, 23> list;
  int count;
};

/// x - H <= 0 (side 1) or -x - H <= 0 (side -1), where x is measured from `centre`.
template <class T, int D>
std::array<T, 5> slab_polynomial(const Course<T, D>& course, const Centre<T>& centre, const T& half,
                                 int side) {
  const T x = course.x[centre.axis] - centre.at;
  const T &v = course.v[centre.axis], &a = course.a[centre.axis];
  if (side > 0) return {x - half, v, a, T{}, T{}};
  return {-x - half, -v, -a, T{}, T{}};
}

/// x - bound <= 0 (upper) or bound - x <= 0 (lower)
template <class T, int D>
std::array<T, 5> face_polynomial(const Course<T, D>& course, int axis, Face which, const T& bound) {
  const T &x = course.x[axis], &v = course.v[axis], &a = course.a[axis];
  if (which == Face::upper) return {x - bound, v, a, T{}, T{}};
  return {bound - x, -v, -a, T{}, T{}};
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
      }
    return joined;
  }

  Pieces always() { return one_curve(below_zero<Wide>()); }
  Pieces face(int axis, Face which, const Wide& bound) {
    return one_curve(face_polynomial(course_, axis, which, bound));
  }

  Pieces slab(int axis, const Wide& half) {
    Pieces pieces = one_piece();
    add_slab(pieces.list[0].curves, {axis, Wide()}, half);
    return pieces;
  }

  template <std::size_t N>
  Pieces ball(const std::array<Centre<Wide>, N>& centre, const Wide& radius) {
    Pieces pieces = one_piece();
    Piece& piece = pieces.list[0];
    piece.curves.add(add(ball_polynomial(course_, centre, radius)));
    const auto& polynomial = curves_.back().rough();
    const bool bent = polynomial[3].sign() != 0 || polynomial[4].sign() != 0;
    for (const Centre<Wide>& c : centre)
      if (bent)
        add_slab(piece.around, c, radius);
      else
        calls_ += 2;
    return pieces;
  }

 private:
  struct Slab {
    Centre<Wide> centre;
    Wide half;
    int first;
  };

  static Pieces one_piece() {
    Pieces pieces;
    pieces.list[0] = {};
    pieces.count = 1;
    return pieces;
  }

  Pieces one_curve(const std::array<Wide, 5>& polynomial) {
    Pieces pieces = one_piece();
    pieces.list[0].curves.add(add(polynomial));
    return pieces;
  }

  /// Pieces share slabs: of the same place and size, each side is one curve.
  void add_slab(CurveNumbers& numbers, const Centre<Wide>& centre, const Wide& half) {
    int first = static_cast<int>(curves_.size());
    for (const Slab& known : slabs_)
      if (known.centre.axis == centre.axis && same(known.centre.at, centre.at) && same(known.half, half))
        first = known.first;
    if (first == static_cast<int>(curves_.size())) {
      slabs_.push_back({centre, half, first});
      for (int side : {1, -1}) add(slab_polynomial(course_, centre, half, side));
    } else {
      calls_ += 2;
    }
    numbers.add(first), numbers.add(first + 1);
  }

  int add(const std::array<Wide, 5>& polynomial) {
    curves_.emplace_back(polynomial, source_, calls_++);
    return static_cast<int>(curves_.size()) - 1;
  }

  const Course<Wide, D>& course_;
  const PolynomialSource& source_;
  std::vector<Curve>& curves_;
  std::vector<Slab> slabs_;
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

  Nothing always() { return asked(below_zero<Dyadic>()); }
  Nothing face(int axis, Face which, const Dyadic& bound) {
    return asked(face_polynomial(course_, axis, which, bound));
  }
  Nothing slab(int axis, const Dyadic& half) { return slab_around({axis, Dyadic()}, half); }
  template <std::size_t N>
  Nothing ball(const std::array<Centre<Dyadic>, N>& centre, const Dyadic& radius) {
    if (calls_++ == number_) polynomial_ = Polynomial(ball_polynomial(course_, centre, radius));
    for (const Centre<Dyadic>& c : centre) slab_around(c, radius);
    return {};
  }

 private:
  Nothing asked(const std::array<Dyadic, 5>& polynomial) {
    if (calls_++ == number_) polynomial_ = Polynomial(polynomial);
    return {};
  }
  Nothing slab_around(const Centre<Dyadic>& centre, const Dyadic& half) {
    for (int side : {1, -1})
      if (calls_++ == number_) polynomial_ = Polynomial(slab_polynomial(course_, centre, half, side));
    return {};
  }

  const Course<Dyadic, D>& course_;
  int number_;
  Polynomial& polynomial_;
  int calls_ = 0;
};

}  // namespace foresee
