// Traits of contact by one contact set for all pairs (certified/pair_context.h): the pieces are those of the
// set (contact_set.h), and all pairs of objects have the same.
//
//   auto contact = std::make_unique<SetContact<2, 1>>(setup, contact_set(setup));
//
// First the lanes (set_filter.h) discard most pairs, several at a time, and bound when the others can touch.
// Doubles with error bounds and DoubleDouble decide these one by one (set_pair.h), and exact numbers the rest.
#pragma once

#include "contact/certified/union_contact.h"
#include "contact/exact/exact_contact.h"
#include "contact/set/set_filter.h"
#include "contact/set/set_pair.h"

namespace foresee {

/// The exact stage. It takes all pieces at once.
class ExactSet {
 public:
  template <int D, int Degree>
  explicit ExactSet(const SetPair<D, Degree>& pair) : ExactSet(pair.context()) {}

  // Each function answers alone: the polynomials can be used for one answer only.

  bool touches() { return exact_touches(polynomials_, lifetime_); }
  FirstContact first_contact() {
    const auto times = exact_times(polynomials_, lifetime_);
    if (!times) return {};
    return {Verdict::yes, {times->dt, times->t}, {times->dt_end, times->t_end}};
  }
  Instant end_of_contact() { return first_contact().end; }
  std::vector<ContactTimes> contacts() { return exact_contacts(polynomials_, lifetime_); }

 private:
  explicit ExactSet(const PairInput<SetPieces>& pair)
      : polynomials_(pair.setup, pair.row_a, pair.row_b, {pair.a.set(), pair.row_a, pair.row_b}),
        lifetime_(exact_lifetime_of(pair.setup, pair.row_a, pair.row_b)) {}

  PairPolynomials polynomials_;
  const ExactLifetime lifetime_;
};

/// D: the number of axes. Degree: 1 or 2, the highest power of time in the relative motion and in the sizes
/// of the set.
template <int D, int Degree>
struct SetTraits {
  static constexpr int axes = D;
  static constexpr bool counts_work = false;
  using Tables = ContactSet;
  using Filter = SetFilter<D, Degree>;
  using Pieces = SetPieces;
  using Space = SetSpace;
  using Context = SetPairContext<D, Degree>;
  using Staged = SetPair<D, Degree>;
  using Exact = ExactSet;

  /// The first pieces are those of the pair.
  static void load(Pieces& pieces, Pieces&, const Setup& setup, const Tables& set, const Pair& pair) {
    pieces.load(set, setup.a.row(pair.a), setup.b.row(pair.b));
  }
  /// Whether the relative motion has no acceleration. Sizes grow linearly.
  static bool is_straight(const Setup& setup, const double* row_a, const double* row_b) {
    if (Degree < 2) return true;
    for (int j = 0; j < D; ++j)
      if (axis_motion(setup.a, row_a, j).a != axis_motion(setup.b, row_b, j).a) return false;
    return true;
  }
};

/// Contact of one contact set for all pairs.
template <int D, int Degree>
using SetContact = UnionContact<SetTraits<D, Degree>>;

// They take long to compile: set_contact.cpp does it for all.
extern template class UnionContact<SetTraits<1, 1>>;
extern template class UnionContact<SetTraits<1, 2>>;
extern template class UnionContact<SetTraits<2, 1>>;
extern template class UnionContact<SetTraits<2, 2>>;
extern template class UnionContact<SetTraits<3, 1>>;
extern template class UnionContact<SetTraits<3, 2>>;

}  // namespace foresee
