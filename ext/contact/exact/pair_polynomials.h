// The polynomials of one pair's contact set, each made when it is first asked for.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"
#include "numbers/algebraic_root.h"

namespace foresee::contact {

class PairPolynomials final : public PolynomialSource {
 public:
  PairPolynomials(const ContactSet& set, const Setup& setup, const double* row_a, const double* row_b);
  PairPolynomials(const PairPolynomials&) = delete;
  PairPolynomials& operator=(const PairPolynomials&) = delete;

  const ContactSet& set() const { return set_; }
  /// The number of a primitive's polynomial. Bounds that turn out to be equal have one polynomial, whose ties
  /// need no algebra.
  std::size_t number_of(int primitive);
  LazyPolynomial& polynomial(std::size_t number) { return polynomials_[number]; }

  /// The exact polynomial of a primitive.
  Polynomial exact_polynomial(int primitive) const override;

 private:
  template <class T>
  using Motion = std::array<Powers<T, 2>, 3>;

  template <class T>
  Motion<T> motion() const;
  bool same_bound(const Primitive& a, const Primitive& b) const;
  bool same_length(int a, int b) const;

  const ContactSet& set_;
  const Setup& setup_;
  const double *row_a_, *row_b_;
  Motion<Midrad128> rough_motion_;
  mutable std::optional<Motion<Dyadic>> exact_motion_;  ///< once it is needed
  std::deque<LazyPolynomial> polynomials_;
  std::vector<int> number_of_;  ///< of each primitive's polynomial; -1: not made
  std::vector<int> bounds_;     ///< the primitives among them that are bounds
};

}  // namespace foresee::contact
