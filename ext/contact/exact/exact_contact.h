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

#include <concepts>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "base/interrupt_steps.h"
#include "contact/constraint/constraint.h"
#include "contact/contact.h"
#include "contact/minkowski/contact_set.h"
#include "contact/minkowski/relative_motion.h"
#include "numbers/algebraic_root.h"

namespace foresee {

// The polynomials of one pair of objects, made lazily: those of the constraints that the pieces of any set name by
// number.
//
//   PairPolynomials polynomials(setup, row_a, row_b, {set, row_a, row_b});          // of a contact set
//   polynomials.polynomial(polynomials.number_of(3));               // of its primitive number 3
//
// Each is computed in 128 bits first, and exactly only where those decide nothing.

/// The constraints of one pair, by number, and the pieces that name them.
template <class C>
concept ConstraintsOfPair = requires(const C& constraints, int i, const RelativeMotion<Midrad128, 3>& rough,
                                     const RelativeMotion<Dyadic, 3>& exact) {
  { constraints.set() } -> std::same_as<const ConstraintUnion&>;
  { constraints.constraint_count() } -> std::convertible_to<std::size_t>;
  { constraints.polynomial(i, rough) } -> std::same_as<Coefficients<Midrad128, 4>>;
  { constraints.polynomial(i, exact) } -> std::same_as<Coefficients<Dyadic, 4>>;
  { constraints.is_compared(i) } -> std::same_as<bool>;
  { constraints.are_equal(i, i) } -> std::same_as<bool>;
};

class PiecePolynomials : public PolynomialSource {
 public:
  /// The union whose pieces name the constraints.
  virtual const ConstraintUnion& set() const = 0;
  /// The number of a constraint's polynomial.
  virtual std::size_t number_of(int constraint) = 0;
  LazyPolynomial& polynomial(std::size_t number) { return polynomials_[number]; }

  /// Counts the work of each piece, some microseconds, as steps, which are polled for an interrupt.
  void step() {
    if (steps_) steps_->costly(256);  // microseconds; a usual step is some nanoseconds
  }

 protected:
  explicit PiecePolynomials(Steps* steps) : steps_(steps) {}

  std::deque<LazyPolynomial> polynomials_;

 private:
  Steps* const steps_;
};

template <ConstraintsOfPair Constraints>
class PolynomialsOf : public PiecePolynomials {
 public:
  /// `steps`, unless they are null, must outlive this like the setup and the rows.
  PolynomialsOf(const Setup& setup, const double* row_a, const double* row_b, Constraints constraints,
                Steps* steps = nullptr)
      : PiecePolynomials(steps),
        constraints_(std::move(constraints)),
        setup_(setup),
        row_a_(row_a),
        row_b_(row_b),
        rough_motion_(motion_of<Midrad128>()),
        number_of_(constraints_.constraint_count(), -1) {}
  PolynomialsOf(const PolynomialsOf&) = delete;
  PolynomialsOf& operator=(const PolynomialsOf&) = delete;

  const ConstraintUnion& set() const override { return constraints_.set(); }
  const Constraints& constraints() const { return constraints_; }

  /// Equal constraints share one polynomial, so that their ties need no algebra.
  std::size_t number_of(int constraint) override {
    int& number = number_of_[static_cast<std::size_t>(constraint)];
    if (number >= 0) return static_cast<std::size_t>(number);
    if (constraints_.is_compared(constraint)) {
      for (const int known : compared_)
        if (constraints_.are_equal(constraint, known)) {
          number = number_of_[static_cast<std::size_t>(known)];
          return static_cast<std::size_t>(number);
        }
      compared_.push_back(constraint);
    }
    number = static_cast<int>(polynomials_.size());
    polynomials_.emplace_back(constraints_.polynomial(constraint, rough_motion_), *this, constraint);
    return static_cast<std::size_t>(number);
  }

  Polynomial exact_polynomial(int constraint) const override {
    if (!exact_motion_) exact_motion_ = motion_of<Dyadic>();
    return Polynomial(constraints_.polynomial(constraint, *exact_motion_));
  }

 private:
  template <class T>
  RelativeMotion<T, 3> motion_of() const {
    return relative_motion_of<T, 3>(setup_, row_a_, row_b_, setup_.a.layout.axes);
  }

  const Constraints constraints_;
  const Setup& setup_;
  const double *row_a_, *row_b_;
  const RelativeMotion<Midrad128, 3> rough_motion_;
  mutable std::optional<RelativeMotion<Dyadic, 3>> exact_motion_;  ///< computed at its first use
  std::vector<int> number_of_;  ///< of each constraint's polynomial; -1: not made
  std::vector<int> compared_;   ///< the constraints with a polynomial that others may equal
};

/// The primitives of a contact set, for one pair.
class SetConstraints {
 public:
  /// The set must outlive this.
  SetConstraints(const ContactSet& set, const double* row_a, const double* row_b)
      : set_(set), row_a_(row_a), row_b_(row_b) {}

  const ConstraintUnion& set() const { return set_; }
  std::size_t constraint_count() const { return set_.primitives().size(); }
  template <class T>
  Coefficients<T, 4> polynomial(int i, const RelativeMotion<T, 3>& x) const {
    return polynomial_of<2>(primitive(i), x.data(), PairLengths<T>{set_, row_a_, row_b_}, 0.0);
  }

  bool is_compared(int i) const { return primitive(i).kind == ConstraintKind::half_space; }
  bool are_equal(int i, int k) const {
    const Primitive &a = primitive(i), &b = primitive(k);
    return a.parts[0].axis == b.parts[0].axis && a.parts[0].sign == b.parts[0].sign &&
           same_length(a.size.value, b.size.value) && same_length(a.size.rate, b.size.rate);
  }

 private:
  const Primitive& primitive(int i) const { return set_.primitives()[static_cast<std::size_t>(i)]; }
  /// Lengths of half spaces differ by the radius alone. Adding a number other than 0 always changes the bits
  /// of a Midrad128 or of its error.
  bool same_length(int a, int b) const {
    const PairLengths<Midrad128> lengths{set_, row_a_, row_b_};
    return a == b || identical(length_at<Midrad128>(lengths, a), length_at<Midrad128>(lengths, b));
  }

  const ContactSet& set_;
  const double *row_a_, *row_b_;
};

/// The polynomials of a contact set for one pair.
using PairPolynomials = PolynomialsOf<SetConstraints>;

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

/// Whether two objects touch at a time at which no piece holds.
using TouchesBetween = std::function<bool(const Dyadic& time)>;

/// Start and end of the first contact; no value if the pair does not touch. Solids may stay in contact between and
/// after the intervals of the pieces: `between` is called at one time of each such gap, unless it is empty.
std::optional<ContactTimes> exact_times(PiecePolynomials& polynomials, const ExactLifetime& lifetime,
                                        const TouchesBetween& between);
inline std::optional<ContactTimes> exact_times(PiecePolynomials& polynomials, const ExactLifetime& lifetime) {
  return exact_times(polynomials, lifetime, {});
}

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

/// |x + v tau + a tau^2|^2 by powers of tau.
using SquaredDistance = Coefficients<Dyadic, Polynomial::max_degree>;

/// The closest approach. Requires: lifetime.begin <= lifetime.end.
ClosestApproach exact_approach(const SquaredDistance& square, const ExactLifetime& lifetime);

}  // namespace foresee
