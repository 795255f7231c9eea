// The polynomials of one pair, made lazily: those of the primitives of a contact set (PairPolynomials), or
// those that the pieces of another kind of set name by number (PiecePolynomials).
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "base/interrupt_steps.h"
#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"
#include "numbers/algebraic_root.h"

namespace foresee {

/// The relative motion, from `now` on; 0 on axes that do not exist.
template <class T>
std::array<Coefficients<T, 2>, 3> motion_coefficients(const Setup& setup, const double* row_a,
                                                      const double* row_b) {
  std::array<Coefficients<T, 2>, 3> x;
  for (int axis = 0; axis < setup.a.layout.axes; ++axis) {
    const RelativeAxisMotion<T> one = relative_axis_motion_of<T>(setup, row_a, row_b, axis);
    x[static_cast<std::size_t>(axis)] = {one.x, one.v, one.a};
  }
  return x;
}

class PiecePolynomials : public PolynomialSource {
 public:
  /// The set whose pieces name the primitives.
  virtual const ContactSet& set() const = 0;
  /// The number of a primitive's polynomial.
  virtual std::size_t number_of(int primitive) = 0;
  LazyPolynomial& polynomial(std::size_t number) { return polynomials_[number]; }

  /// Counts the work of each piece, some microseconds, as steps, which are polled for an interrupt. `steps`
  /// must outlive this.
  void set_interrupt(Steps& steps) { steps_ = &steps; }
  void step() {
    if (steps_) steps_->costly(256);  // microseconds; a usual step is some nanoseconds
  }

 protected:
  std::deque<LazyPolynomial> polynomials_;

 private:
  Steps* steps_ = nullptr;
};

class PairPolynomials final : public PiecePolynomials {
 public:
  PairPolynomials(const ContactSet& set, const Setup& setup, const double* row_a, const double* row_b);
  PairPolynomials(const PairPolynomials&) = delete;
  PairPolynomials& operator=(const PairPolynomials&) = delete;

  const ContactSet& set() const override { return set_; }
  /// Equal bounds share one polynomial, so that their ties need no algebra.
  std::size_t number_of(int primitive) override;

  /// The exact polynomial of a primitive.
  Polynomial exact_polynomial(int primitive) const override;

 private:
  template <class T>
  using Motion = std::array<Coefficients<T, 2>, 3>;

  bool same_bound(const Primitive& a, const Primitive& b) const;
  bool same_length(int a, int b) const;

  const ContactSet& set_;
  const Setup& setup_;
  const double *row_a_, *row_b_;
  Motion<Midrad128> rough_motion_;
  mutable std::optional<Motion<Dyadic>> exact_motion_;  ///< computed at its first use
  std::vector<int> number_of_;                          ///< of each primitive's polynomial; -1: not made
  std::vector<int> bounds_;                             ///< the primitives with a polynomial that are bounds
};

}  // namespace foresee
