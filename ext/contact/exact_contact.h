// Contact decided and timed in exact arithmetic: the last word where doubles cannot tell.
//
// The contact set is a formula over polynomials, p <= 0 meaning inside. Its first moment is the begin of the
// horizon or a root at which the formula holds; its first component ends at the first such root after which
// it does not hold. Both are found by exact signs at roots. As rounding keeps order, each candidate is
// rounded by itself and the least result taken: two roots are never compared with each other. Cost: tens of
// microseconds.
#pragma once

#include <vector>

#include "contact/certified.h"
#include "contact/polynomial.h"

namespace foresee {

/// A tree in one vector: leaves are polynomials, inner nodes join two others.
struct Formula {
  enum class Op : std::uint8_t { leaf, all, any };
  struct Node {
    Op op;
    int first, second;  ///< nodes; of a leaf, `first` is the polynomial
  };
  std::vector<Polynomial> polynomials;
  std::vector<Node> nodes;
  int top = 0;
};

/// Builds the formula of a pair: what a pair kind visits with exact numbers.
template <int D>
class FormulaVisitor {
 public:
  FormulaVisitor(const Course<Dyadic, D>& course, Formula& formula) : course_(course), formula_(formula) {}

  int all(int a, int b) { return add(Formula::Op::all, a, b); }
  int any(int a, int b) { return add(Formula::Op::any, a, b); }

  int slab(int axis, const Dyadic& half) {
    for (const Slab& known : slabs_)
      if (known.axis == axis && known.half == half) return known.node;
    const Dyadic &x = course_.x[axis], &v = course_.v[axis], &a = course_.a[axis];
    const int node = all(leaf({x - half, v, a, {}, {}}), leaf({-x - half, -v, -a, {}, {}}));
    slabs_.push_back({axis, half, node});
    return node;
  }

  template <std::size_t N>
  int ball(const std::array<Centre<Dyadic>, N>& centre, const Dyadic& radius) {
    std::array<Dyadic, 5> sum;
    sum[0] = -(radius * radius);
    for (const Centre<Dyadic>& c : centre) {
      const Dyadic x = course_.x[c.axis] - c.at, &v = course_.v[c.axis], &a = course_.a[c.axis];
      sum[0] = sum[0] + x * x;
      sum[1] = sum[1] + (x * v).scaled(1);
      sum[2] = sum[2] + v * v + (x * a).scaled(1);
      sum[3] = sum[3] + (v * a).scaled(1);
      sum[4] = sum[4] + a * a;
    }
    return leaf(sum);
  }

 private:
  struct Slab {
    int axis;
    Dyadic half;
    int node;
  };
  int add(Formula::Op op, int first, int second) {
    formula_.nodes.push_back({op, first, second});
    return formula_.top = static_cast<int>(formula_.nodes.size()) - 1;
  }
  int leaf(const std::array<Dyadic, 5>& coefficients) {
    formula_.polynomials.emplace_back(coefficients);
    return add(Formula::Op::leaf, static_cast<int>(formula_.polynomials.size()) - 1, 0);
  }

  const Course<Dyadic, D>& course_;
  Formula& formula_;
  std::vector<Slab> slabs_;
};

/// The exact ends of the moments asked about, measured from now.
struct ExactMoments {
  Dyadic begin, end;
  Dyadic now;
  Moments rounded;
};
ExactMoments exact_moments_of(const Setup& setup, const double* row_a, const double* row_b);

bool exact_touches(const Formula& formula, const ExactMoments& moments);

/// Requires: the pair touches.
ContactTimes exact_times(const Formula& formula, const ExactMoments& moments);

}  // namespace foresee
