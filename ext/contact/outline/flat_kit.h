// What contact of outlines is made of (pieces/union_pair.h): convex pieces, and prisms over them.
#pragma once

#include "base/steps.h"
#include "contact/exact/pair_polynomials.h"
#include "contact/outline/critical_pieces.h"
#include "contact/outline/piece_tests.h"
#include "contact/outline/plainly_near.h"
#include "contact/outline_contact.h"
#include "contact/pieces/pair_way.h"

namespace foresee {

template <int D, int Degree>
struct FlatKit {
  static constexpr int axes = D, degree = Degree;
  static constexpr bool has_solids = false;
  using Tables = OutlineTables;
  using Pieces = ObjectPieces;
  using Condition = foresee::Condition;
  template <class T>
  using Sizes = PairSizes<T>;
  using Space = FlatSpace;
  using Tests = PieceTests<D, Degree>;
  using NodeTests = BoxTests<D, ObjectPieces>;

  /// Pieces fill their outline.
  struct Within {
    Within(const Setup&, const double*, const double*, const Pieces&, const Pieces&, const CertainMotion<D>&,
           Steps&) {}
    static constexpr bool may_be() { return false; }
    static constexpr bool at_begin() { return false; }
    static constexpr bool at(const Dyadic&) { return false; }
  };

  /// Of some pairs of pieces.
  class Polynomials {
   public:
    Polynomials(const Setup& setup, const double* row_a, const double* row_b, const Pieces& a,
                const Pieces& b, std::span<const PiecePair> pairs, bool grown)
        : critical_(critical_pieces(setup, a, b, pairs, grown)), all_(critical_.set, setup, row_a, row_b) {}

    PiecePolynomials& all() { return all_; }
    std::span<const std::uint32_t> ends() const { return critical_.ends; }

   private:
    const CriticalPieces critical_;
    PairPolynomials all_;
  };

  template <class T>
  static PairSizes<T> sizes_of(const Setup& setup, const double* row_a, const double* row_b) {
    return foresee::sizes_of<T>(setup, row_a, row_b);
  }
  /// Of prisms only that their outlines are apart.
  static PlainAnswer plain_answer(const PairWay<FlatKit>& way, bool times_wanted);
  /// What leaves a piece there is in its neighbour. (Around a corner R ends beside the cut that begins there,
  /// not beyond it.)
  static bool is_cut(const Condition& condition) {
    return condition.kind != Condition::Kind::corner && condition.edge.inner;
  }
  /// What the rows of a pair look like.
  static void take(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables, const Pair& pair);
};

}  // namespace foresee
