// Real algebraic numbers: roots of polynomials, with exact order and exact signs of other polynomials there.
//
// A root is an isolating interval, never a computed value; everything follows from signs. Polynomials are
// lazy: enclosed in 128 bits at first, exact once that is needed. Each sign is first computed with error
// bounds in 128 bits (Midrad128). The exact coefficients are made only where that is inconclusive: in ties,
// and for numbers nearer than some 2^-100. If two polynomials may have a common root, exact algebra decides
// whether it is this one. If not, numbers of 512, 1024, ... bits (Midrad) find the sign in the end. No
// tolerance ever decides.
#pragma once

#include <array>
#include <memory>

#include "numbers/midrad.h"
#include "numbers/polynomial.h"

namespace foresee {

/// Computes the exact polynomials of a pair, by number, on demand.
class PolynomialSource {
 public:
  virtual ~PolynomialSource() = default;
  virtual Polynomial exact_polynomial(int number) const = 0;
};

class LazyPolynomial;

/// A known number, or a root of a polynomial.
struct AlgebraicRoot {
  AlgebraicRoot() = default;
  explicit AlgebraicRoot(const Dyadic& time) : at(time), known(&time) {}

  Midrad128 at;                          ///< encloses it
  const Dyadic* known = nullptr;         ///< the number, if it is known exactly
  LazyPolynomial* polynomial = nullptr;  ///< otherwise: the polynomial that has its root here
  int which = 0;  ///< degree 1 and 2: -1 the lesser root, 1 the greater, 0 the only one
  /// The isolating interval: [low, high] contains this root. Degree 3 and 4: no other root, and this one is
  /// simple, so that the sign changes.
  struct Bracket {
    Dyadic low, high;
    int sign_low;
    int bits;  ///< how far it has been narrowed
  };
  std::unique_ptr<Bracket> bracket;

  /// An enclosure in numbers of `bits` bits; more bits make it narrower.
  Midrad enclosure(int bits);
  /// Degree 3 and 4: makes the root known if it is a number of far fewer bits than its interval has.
  /// Roots at times that people write are such numbers, and known numbers need no algebra for their ties.
  void recognize();

 private:
  /// Degree 3 and 4: narrows the interval.
  void narrow(int bits);
  /// Degree 1 and 2.
  Midrad by_formula(int bits) const;
};

/// The sign of x - y.
int compare(AlgebraicRoot& x, AlgebraicRoot& y);
int compare(AlgebraicRoot& x, const Dyadic& y);

/// root + offset to the nearest double, ties to even.
double rounded(AlgebraicRoot& root, const Dyadic& offset);

class LazyPolynomial {
 public:
  static constexpr int max_degree = Polynomial::max_degree;
  using RoughCoefficients = std::array<Midrad128, max_degree + 1>;

  /// `rough` encloses the coefficients of the source's polynomial `number`, up to a positive factor.
  LazyPolynomial(const RoughCoefficients& rough, const PolynomialSource& source, int number)
      : rough_(rough), source_(&source), number_(number) {}

  int degree();                                                     ///< exact; -1: zero everywhere
  int lead() { return degree() < 0 ? 0 : rough_[degree_].side(); }  ///< sign of the leading coefficient
  const RoughCoefficients& rough() const { return rough_; }
  const Polynomial& exact();
  std::array<Midrad, max_degree + 1> enclosure(int bits);  ///< encloses the coefficients of exact()
  LazyPolynomial& slope();

  Midrad128 value_at(const Midrad128& tau) const;
  int sign_at(AlgebraicRoot& root);
  int sign_at(const Dyadic& tau);

  /// Replaces the enclosures by those of the exact coefficients.
  void sharpen();

  /// A root of degree 1 or 2. The polynomial must not move afterwards.
  AlgebraicRoot& add_root(int which, const Midrad128& at);
  /// A simple root of degree 3 or 4, the only one between two numbers.
  AlgebraicRoot& add_root(const Dyadic& low, const Dyadic& high, int sign_low);

 private:
  RoughCoefficients rough_;
  const PolynomialSource* source_ = nullptr;  ///< null for a slope
  LazyPolynomial* parent_ = nullptr;          ///< for a slope: the polynomial itself
  int number_ = 0;
  int degree_ = max_degree + 1;  ///< beyond `max_degree`: not known yet
  std::array<AlgebraicRoot, max_degree> roots_;
  int root_count_ = 0;
  std::unique_ptr<Polynomial> exact_;
  std::unique_ptr<LazyPolynomial> slope_;
};

}  // namespace foresee
