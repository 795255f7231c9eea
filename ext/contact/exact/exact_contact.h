// The exact stage: contact times and closest approach of one pair in exact arithmetic, for pairs that
// certified doubles leave undecided.
//
// Contact: every polynomial is at most 0 during some intervals of time, whose ends are algebraic roots. A
// piece of the contact set holds in the intersection of the intervals of its polynomials, and the set is the
// union of its pieces. Ends are compared exactly; only the ends of the answer are rounded, once. Cost:
// microseconds if 128 bits decide, and some microseconds more for each tie.
//
// Closest approach: the squared distance is a polynomial of degree at most four. Its minimum is at an end of
// the lifetime or where the slope changes from negative to positive; there are at most two such times. They
// are compared by exact signs, and a tie goes to the earlier one. Time and distance are each rounded once.
// Cost: tens of microseconds.
#pragma once

#include <functional>
#include <optional>

#include "contact/contact.h"
#include "contact/exact/pair_polynomials.h"

namespace foresee {

/// The exact lifetime of a pair within the horizon, measured from now.
struct ExactLifetime {
  Dyadic begin, end;
  Dyadic now;
  PairLifetime rounded;
};
inline ExactLifetime exact_lifetime_of(const Setup& setup, const double* row_a, const double* row_b) {
  ExactLifetime lifetime;
  lifetime.rounded = pair_lifetime_of(setup, row_a, row_b);
  lifetime.now = Dyadic(setup.horizon.now);
  const PairLifetime& m = lifetime.rounded;
  lifetime.begin = Dyadic(m.t_start) - lifetime.now;
  lifetime.end = m.ends_with_horizon ? Dyadic(setup.horizon.h) : Dyadic(m.t_end) - lifetime.now;
  return lifetime;
}

/// Whether the pair touches during the lifetime. The polynomials can be used for one answer only.
bool exact_touches(PiecePolynomials& polynomials, const ExactLifetime& lifetime);

/// Start and end of the first contact; no value if the pair does not touch.
std::optional<ContactTimes> exact_times(PiecePolynomials& polynomials, const ExactLifetime& lifetime);

/// Start and end of every contact, in order of time; contacts that touch each other are one.
std::vector<ContactTimes> exact_contacts(PiecePolynomials& polynomials, const ExactLifetime& lifetime);

/// A subset of the pieces of a set: until a time, one of them holds whenever any piece of the set does.
struct NeededPieces {
  std::vector<std::uint32_t> pieces;  ///< piece numbers
  double until;  ///< measured from now; infinity if the subset is enough for the whole lifetime
};

/// The smallest subset that is enough. At most `limit` pieces: if more are needed and start one by one, then
/// until the next one starts.
NeededPieces needed_pieces(PiecePolynomials& polynomials, const ExactLifetime& lifetime, std::size_t limit);

/// Whether two objects touch at a time at which no piece holds.
using TouchesBetween = std::function<bool(const Dyadic& time)>;

/// exact_times() for solids, which may stay in contact between and after the intervals of the pieces.
/// `between` is called at one time of each such gap.
std::optional<ContactTimes> exact_times_of_solids(PiecePolynomials& polynomials,
                                                  const ExactLifetime& lifetime,
                                                  const TouchesBetween& between);

/// |x + v tau + a tau^2|^2 by powers of tau.
using SquaredDistance = std::array<Dyadic, Polynomial::max_degree + 1>;

template <int D>
SquaredDistance squared_distance(const RelativeMotion<Dyadic, D>& relative) {
  SquaredDistance sum;
  for (int j = 0; j < D; ++j) {
    const Dyadic &x = relative.x[j], &v = relative.v[j], &a = relative.a[j];
    sum[0] = sum[0] + x * x;
    sum[1] = sum[1] + (x * v).scaled(1);
    sum[2] = sum[2] + v * v + (x * a).scaled(1);
    sum[3] = sum[3] + (v * a).scaled(1);
    sum[4] = sum[4] + a * a;
  }
  return sum;
}

/// The closest approach. Requires: lifetime.begin <= lifetime.end.
ClosestApproach exact_approach(const SquaredDistance& square, const ExactLifetime& lifetime);

}  // namespace foresee
