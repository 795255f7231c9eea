// Roots of polynomials as exact numbers: their order, and the signs of other polynomials there, exact in the
// end. A polynomial is lazy: enclosed in 128 bits at first, exact once that is asked for.
//
// Each question is first put to numbers of 128 bits with error bounds (Midrad128). Only where those cannot
// tell, in ties and what is nearer than some 2^-100, are the exact coefficients made. If they show that two
// polynomials may have a common root, exact algebra tells whether it is this one; if not, numbers of 512,
// 1024, ... bits (Midrad) tell the sign in the end. Nothing is ever decided by a tolerance. A root is never
// computed: it is an isolating interval, and everything about it follows from signs.
#pragma once

#include <array>
#include <memory>

#include "numbers/midrad.h"
#include "numbers/polynomial.h"

namespace foresee {

/// Makes the exact polynomials of a pair, by number, when one is needed.
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
  const Dyadic* known = nullptr;         ///< the number, if that is known exactly
  LazyPolynomial* polynomial = nullptr;  ///< otherwise: the polynomial that has its root here
  int which = 0;  ///< degree 1 and 2: -1 the lesser root, 1 the greater, 0 the only one
  /// Its isolating interval: [low, high] holds this root. Degree 3 and 4: this one alone, a simple one at
  /// which the sign changes.
  struct Bracket {
    Dyadic low, high;
    int sign_low;
    int bits;  ///< how far it has been narrowed
  };
  std::unique_ptr<Bracket> bracket;

  /// Encloses it in numbers of so many bits, the more the narrower.
  Midrad enclosure(int bits);
  /// Degree 3 and 4: makes the root known if it is a number of far fewer bits than its interval tells.
  /// Roots at moments that people write are, and what is known needs no algebra for its ties.
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

  /// `rough` encloses the coefficients of the source's polynomial, up to a positive factor.
  LazyPolynomial(const RoughCoefficients& rough, const PolynomialSource& source, int number)
      : rough_(rough), source_(&source), number_(number) {}

  int degree();                                                     ///< exactly; -1: zero everywhere
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
  /// A root of degree 3 or 4, a simple one and alone between two numbers.
  AlgebraicRoot& add_root(const Dyadic& low, const Dyadic& high, int sign_low);

 private:
  RoughCoefficients rough_;
  const PolynomialSource* source_ = nullptr;  ///< of a slope: none
  LazyPolynomial* parent_ = nullptr;          ///< of a slope: the polynomial itself
  int number_ = 0;
  int degree_ = max_degree + 1;  ///< beyond `max_degree`: not known yet
  std::array<AlgebraicRoot, max_degree> roots_;
  int root_count_ = 0;
  std::unique_ptr<Polynomial> exact_;
  std::unique_ptr<LazyPolynomial> slope_;
};

}  // namespace foresee
