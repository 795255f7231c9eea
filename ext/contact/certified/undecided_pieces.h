// The constraints of the pairs of pieces that doubles leave undecided, for the exact stage.
//
//   UndecidedPieces<FlatTraits<2, 1>> undecided(setup, row_a, row_b, a, b, pairs, true);
//   PolynomialsOf polynomials(setup, row_a, row_b, std::move(undecided));          // exact_contact.h
//
// The parts of the Minkowski sum of each pair are pieces of the union, in the order of the pairs.
#pragma once

#include <algorithm>

#include "contact/certified/pair_tests.h"
#include "contact/constraint/constraint.h"
#include "contact/constraint/constraint_union.h"
#include "contact/minkowski/relative_motion.h"

namespace foresee {

/// `Traits`: what the pieces are (pair_context.h). Its function add_pair() adds the parts of one pair, after
/// `shared`, the numbers of the constraints of shared_constraints(), which all of them have.
template <class Traits>
class UndecidedPieces : public ConstraintUnion {
 public:
  using PieceConstraint = typename Traits::PieceConstraint;

  /// `grown`: the contact distance of these objects is more than 0. Rows, pieces and setup must outlive this.
  UndecidedPieces(const Setup& setup, const double* row_a, const double* row_b,
                  const typename Traits::Pieces& a, const typename Traits::Pieces& b,
                  std::span<const PiecePair> pairs, bool grown)
      : setup_(setup), row_a_(row_a), row_b_(row_b), a_(a) {
    std::vector<int> shared;
    for (const PieceConstraint& constraint : Traits::shared_constraints(setup))
      shared.push_back(add(constraint));
    for (const PiecePair& pair : pairs) {
      Traits::add_pair(*this, a.piece(pair.a), b.piece(pair.b), grown, shared);
      ends_.push_back(static_cast<std::uint32_t>(pieces().size()));
    }
  }

  /// Its number.
  int add(const PieceConstraint& constraint) {
    constraints_.push_back(constraint);
    return static_cast<int>(constraints_.size()) - 1;
  }

  const ConstraintUnion& set() const { return *this; }
  /// For each pair, the number of pieces up to and with it.
  std::span<const std::uint32_t> ends() const { return ends_; }
  std::size_t constraint_count() const { return constraints_.size(); }

  /// The polynomial of a constraint, padded with zeros. `x`: the relative motion from now on.
  template <class T>
  Coefficients<T, 4> polynomial(int constraint, const std::array<Coefficients<T, 2>, 3>& x) const {
    Coefficients<T, 4> all{};
    with_polynomial<2>(constraints_[static_cast<std::size_t>(constraint)], x,
                       Traits::template sizes_of<T>(setup_, row_a_, row_b_, a_),
                       [&all](const auto& p) { std::copy(p.begin(), p.end(), all.begin()); });
    return all;
  }

  /// Equal constraints are not searched for.
  static constexpr bool is_compared(int) { return false; }
  static constexpr bool are_equal(int, int) { return false; }

 private:
  const Setup& setup_;
  const double *row_a_, *row_b_;
  const typename Traits::Pieces& a_;
  std::vector<PieceConstraint> constraints_;
  std::vector<std::uint32_t> ends_;
};

}  // namespace foresee
