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
  template <class Context, class Staged>
  ExactSet(const Context& context, const Staged& /*staged*/)
      : polynomials_(context.a.set(), context.setup, context.row_a, context.row_b),
        lifetime_(exact_lifetime_of(context.setup, context.row_a, context.row_b)) {}

  bool touches() { return exact_touches(polynomials_, lifetime_); }
  /// The first contact, whatever is known of it.
  std::optional<ContactTimes> contact(double /*from*/, double /*contact_by*/ = 0) {
    return exact_times(polynomials_, lifetime_);
  }
  std::vector<ContactTimes> contacts() { return exact_contacts(polynomials_, lifetime_); }

 private:
  PairPolynomials polynomials_;
  const ExactLifetime lifetime_;
};

/// D: the number of axes. Degree: 1 or 2, the highest power of time in the relative motion and in the sizes
/// of the set. The engine passes some arguments that only pieces under trees need: their parameters have no name here
/// and in set_pair.h.
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

  static void take(Pieces& pieces, Pieces&, const Setup& setup, const Tables& set, const Pair& pair) {
    pieces.take(set, setup.a.row(pair.a), setup.b.row(pair.b));
  }
  /// The lanes have filtered already.
  static FilterAnswer filter_answer(const Context&, bool) { return {}; }
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
