// The time of a crossing that an Advancement has bracketed, rounded once: one Newton step in DoubleDouble and
// Ziv's rounding test.
//
// Within the bracket a primitive either keeps its sign, or its polynomial is monotone and has at most one
// root. One Newton step from the start of the bracket finds that root, with the value of the polynomial in
// DoubleDouble and a bound on the error. The root is accepted if all numbers within that error round to the
// same double (Ziv's test). Roots of different primitives are rounded separately and then compared, because
// rounding is monotone. NaN stands for a time that this does not decide.
#pragma once

#include "contact/certain/advancement.h"
#include "numbers/crossed_root.h"

namespace foresee {

inline Instant unknown_instant() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan};
}

inline Instant later(const Instant& a, const Instant& b) {
  if (!a.known() || !b.known()) return unknown_instant();
  return {std::max(a.dt, b.dt), std::max(a.t, b.t)};
}

inline Instant earlier(const Instant& a, const Instant& b) {
  if (!a.known() || !b.known()) return unknown_instant();
  return {std::min(a.dt, b.dt), std::min(a.t, b.t)};
}

/// Scratch space for crossings, reused for one after another.
struct CrossingScratch {
  std::vector<Instant> known;  ///< the crossing of each primitive that was computed
  std::vector<char> tested;

  explicit CrossingScratch(const ContactSet& set)
      : known(set.primitives().size()), tested(set.primitives().size()) {}
};

template <CrossingDirection direction, int D, int Degree>
class Crossing {
 public:
  /// Requires: an Advancement has found the bracket, for this pair and this direction.
  Crossing(CertainSet<D, Degree>& certain, const RelativeMotion<DoubleDouble, D>& relative,
           const PairLengths<DoubleDouble>& lengths, const Bracket& bracket, double now,
           CrossingScratch& scratch)
      : certain_(certain), lengths_(lengths), scratch_(scratch), base_(bracket.before), now_(now) {
    width_ = (bracket.after - bracket.before) * (1 + 4 * unit_roundoff);
    certain.expand_at(base_);
    const DoubleDouble tau{base_, 0};
    for (int j = 0; j < D; ++j)
      place_[j][0] = Degree < 2 ? relative.x[j] + tau * relative.v[j]
                                : relative.x[j] + tau * (relative.v[j] + tau * relative.a[j]);
    std::fill(scratch.tested.begin(), scratch.tested.end(), false);
  }

  /// When the pair enters or leaves the set, or unknown.
  Instant instant() {
    Instant whole = outside;
    for (const ContactSet::Piece& piece : certain_.set().pieces()) whole = any(whole, of(piece));
    return whole;
  }

 private:
  static constexpr double inf = std::numeric_limits<double>::infinity();
  static constexpr Instant inside =
      direction == CrossingDirection::entering ? Instant{-inf, -inf} : Instant{inf, inf};
  static constexpr Instant outside =
      direction == CrossingDirection::entering ? Instant{inf, inf} : Instant{-inf, -inf};

  static Instant all(const Instant& a, const Instant& b) {
    return direction == CrossingDirection::entering ? later(a, b) : earlier(a, b);
  }
  static Instant any(const Instant& a, const Instant& b) {
    return direction == CrossingDirection::entering ? earlier(a, b) : later(a, b);
  }
  static bool is_outside(const Instant& instant) { return instant.dt == outside.dt; }

  /// When it enters or leaves a piece. Outside one primitive is outside, even if others are undecided.
  Instant of(const ContactSet::Piece& piece) {
    Instant crossing = inside;
    for (const int i : certain_.set().members(piece.all)) {
      const Instant one = of(i);
      if (is_outside(one)) return outside;
      crossing = all(crossing, one);
    }
    return crossing;
  }

  /// When primitive number i is crossed; computed once.
  Instant of(int i) {
    const auto place = static_cast<std::size_t>(i);
    if (!scratch_.tested[place]) {
      scratch_.tested[place] = true;
      scratch_.known[place] = of(certain_.set().primitives()[place]);
    }
    return scratch_.known[place];
  }

  Instant of(const Primitive& primitive) const {
    return certain_.with_polynomial(primitive,
                                    [this, &primitive](const auto& p) { return this->of(primitive, p); });
  }

  /// When its polynomial changes sign: `inside` or `outside` if it certainly keeps that sign in the whole
  /// bracket, else its root, rounded once, or unknown.
  template <std::size_t N>
  Instant of(const Primitive& primitive, const std::array<Bounded, N>& p) const {
    const double lost = certain_.lost(primitive), error = p[0].error_bound(lost);
    double moved = 0;
    for (std::size_t k = N - 1; k > 0; --k) moved = width_ * (upper_bound(p[k]) + moved);
    const double certain = error + 2 * moved;
    if (p[0].value < -certain || positive_during(p, -1, lost, width_) > width_) return inside;
    if (p[0].value > certain || positive_during(p, 1, lost, width_) > width_) return outside;
    const DoubleDouble value = polynomial_of<0>(primitive, place_, lengths_, base_)[0];
    // The error of DoubleDouble is at most 2^-97 of the magnitudes that the bound for doubles counts in
    // 2^-53.
    const double underflow = certain_.relative().underflow;
    const double slope = p[1].value;
    return root_of<direction>(
        {value, error * 0x1p-44 + underflow, slope, p[1].error_bound(underflow), bend(p, value.high / slope)},
        now_, base_, width_);
  }

  /// Bound on |p''| / 2 up to the root.
  template <std::size_t N>
  double bend(const std::array<Bounded, N>& p, double step) const {
    if constexpr (N == 2) return 0;
    if constexpr (N == 3) return 2 * upper_bound(p[2]);
    if constexpr (N == 5) {
      const double span = std::max(width_, 2 * std::abs(step));
      return 2 * (upper_bound(p[2]) + span * (3 * upper_bound(p[3]) + 6 * span * upper_bound(p[4])));
    }
  }

  static double upper_bound(const Bounded& c) { return std::abs(c.value) + c.error_bound(0x1p-1060); }

  CertainSet<D, Degree>& certain_;
  const PairLengths<DoubleDouble> lengths_;
  CrossingScratch& scratch_;
  Coefficients<DoubleDouble, 0> place_[D];
  double base_, width_, now_;
};

}  // namespace foresee
