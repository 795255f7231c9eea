// Contact decided and timed exactly: the last word where certified doubles cannot tell.
//
// Every polynomial is at most 0 during some stays of time, whose ends are exact events; a piece of the
// contact set holds where all of its polynomials' stays meet, and the set is the union of its pieces.
// Ends are compared exactly and only the answer's are rounded, once. Cost: microseconds where 128 bits tell,
// some microseconds more for each tie.
#pragma once

#include <optional>
#include <vector>

#include "contact/formula.h"

namespace foresee {

/// The exact ends of the moments asked about, measured from now.
struct ExactMoments {
  Dyadic begin, end;
  Dyadic now;
  Moments rounded;
};
ExactMoments exact_moments_of(const Setup& setup, const double* row_a, const double* row_b);

/// The contact set of one pair, and its curves.
struct Formula {
  std::vector<Curve> curves;
  Pieces pieces;
};

/// Does the pair touch at some moment asked about?
bool exact_touches(Formula& formula, const ExactMoments& moments);

/// Begin and end of the first contact, if there is one.
std::optional<ContactTimes> exact_times(Formula& formula, const ExactMoments& moments);

/// Makes the exact polynomials of a pair of the given kind.
template <class Kind>
class PairPolynomials final : public PolynomialSource {
 public:
  PairPolynomials(const Setup& setup, const double* row_a, const double* row_b)
      : setup_(setup), row_a_(row_a), row_b_(row_b) {}

  Polynomial polynomial(int number) const override {
    if (!course_) course_ = course_of<Dyadic, Kind::axes>(setup_, row_a_, row_b_);
    Polynomial polynomial;
    Kind::visit(sizes<Dyadic>(), PolynomialVisitor<Kind::axes>(*course_, number, polynomial));
    return polynomial;
  }

  /// This must outlive the formula.
  void formula(Formula& formula) const {
    // Of a rounded cuboid: three slabs and those grown, 12 edges, 8 corners.
    constexpr std::size_t most_curves = 2 * 3 * 2 + 12 + 8;
    formula.curves.reserve(most_curves);
    const auto course = course_of<Wide, Kind::axes>(setup_, row_a_, row_b_);
    formula.pieces = Kind::visit(sizes<Wide>(), PiecesVisitor<Kind::axes>(course, *this, formula.curves));
  }

 private:
  template <class T>
  auto sizes() const {
    return Kind::template sizes<T>(raw_sizes_of<T, Kind::axes>(setup_, row_a_, row_b_), setup_);
  }

  const Setup& setup_;
  const double *row_a_, *row_b_;
  mutable std::optional<Course<Dyadic, Kind::axes>> course_;  ///< once it is needed
};

}  // namespace foresee
