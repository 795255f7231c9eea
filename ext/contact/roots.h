// Real roots held exactly: a polynomial without repeated roots and an interval with exactly one of them.
//
// No root is ever computed; it is compared, and its interval narrowed, by exact signs. That is enough to
// round it correctly and to tell the sign of any other polynomial at it.
#pragma once

#include <vector>

#include "contact/polynomial.h"

namespace foresee {

class Root {
 public:
  /// Exactly one root in (low, high), at which the sign changes, or low == high and the root is that.
  Root(const Polynomial& square_free, const Dyadic& low, const Dyadic& high, int sign_after_low)
      : p_(&square_free), low_(low), high_(high), sign_low_(sign_after_low) {}

  /// The sign of q here; exact also where q has the same root.
  int sign_of(const Polynomial& q);

  /// The sign of root - x.
  int compare(const Dyadic& x);

  /// root + offset to the nearest double, ties to even.
  double rounded_with(const Dyadic& offset);

  /// The root is strictly between, or it is both.
  const Dyadic& low() const { return low_; }
  const Dyadic& high() const { return high_; }
  bool exact() const { return low_ == high_; }

  /// Narrows the interval, quickly after many rounds; early ones look at the simplest number inside, which
  /// may well be the root.
  void narrow(int round);

 private:
  /// Narrows the interval by looking at x: low < x < high.
  void look_at(const Dyadic& x);
  /// Narrows the interval, at least to a half and quadratically in the end (Abbott's quadratic interval
  /// refinement).
  void refine();

  const Polynomial* p_;  ///< owned by whoever made the roots
  Dyadic low_, high_;
  int sign_low_;    ///< sign just after low
  int digits_ = 4;  ///< the next grid has 2^digits cells
  int looks_ = 0;   ///< how often the interval was split without a grid
};

/// All roots in the open interval (low, high); `square_free` receives the polynomial that they refer to.
/// Requires: 0 <= low; p.degree >= 0.
std::vector<Root> roots_between(const Polynomial& p, const Dyadic& low, const Dyadic& high,
                                Polynomial& square_free_part);

}  // namespace foresee
