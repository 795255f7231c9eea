// The exact polynomials of some pairs of pieces in space: what doubles leave open hangs on these alone.
//
// Their pieces are the parts of each pair (space_hull.h, round_parts.h), and their primitives the conditions
// of these, one after the other.
#pragma once

#include "contact/exact/pair_polynomials.h"
#include "contact/mesh/space_condition.h"
#include "contact/pieces/tested_pairs.h"

namespace foresee {

class SpacePolynomials final : public PiecePolynomials {
 public:
  /// `grown`: how near counts as touching is more than 0, for these objects.
  SpacePolynomials(const Setup& setup, const double* row_a, const double* row_b, const SpacePieces& a,
                   const SpacePieces& b, std::span<const PiecePair> pairs, bool grown);

  PiecePolynomials& all() { return *this; }
  /// Of each pair: how many pieces it and those before it have in the set.
  std::span<const std::uint32_t> ends() const { return ends_; }
  const ContactSet& set() const override { return set_; }
  std::size_t number_of(int primitive) override;
  Polynomial exact_polynomial(int primitive) const override;

 private:
  void add(const SpacePiece& a, const SpacePiece& b, bool grown);
  int add(const SpaceCondition& condition);
  template <class T>
  Powers<T, 4> polynomial_of(int primitive, const std::array<Powers<T, 2>, 3>& x) const;

  const Setup& setup_;
  const double *row_a_, *row_b_;
  std::vector<SpaceCondition> conditions_;
  ContactSet set_;
  std::vector<std::uint32_t> ends_;
  std::vector<int> number_of_;  ///< of each condition's polynomial; -1: not made
  const std::array<Powers<Midrad128, 2>, 3> rough_motion_;
  mutable std::optional<std::array<Powers<Dyadic, 2>, 3>> exact_motion_;  ///< once it is needed
};

}  // namespace foresee
