// Is a pair certainly apart, or certainly in contact, and for how long? Its contact set seen from a moment,
// in double arithmetic with error bounds.
//
// Each primitive's polynomial says for how long it is surely positive (outside) or negative (inside). A piece
// is missed while one of its primitives is, the set while all pieces are; a piece holds while all of its
// primitives do, the set while one piece does. What several pieces share is asked once, and what cannot
// change the answer not at all.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "contact/certain/certain_motion.h"
#include "contact/certain/positive_duration.h"
#include "contact/set/contact_set.h"

namespace foresee {

/// Space for doubles with error bounds, used for one pair after another.
struct CertainScratch {
  AllLengths<Bounded> lengths;
  std::vector<double> known;  ///< the answer of each primitive to the question at hand; NaN: not asked

  explicit CertainScratch(const ContactSet& set) : lengths(set), known(set.primitives().size()) {}
};

template <int D, int Degree>
class CertainSet {
 public:
  CertainSet(const ContactSet& set, const Setup& setup, const double* row_a, const double* row_b,
             CertainScratch& scratch)
      : set_(set), relative_(certain_motion_of<D, Degree>(setup, row_a, row_b)), scratch_(scratch) {
    scratch.lengths.take(set, row_a, row_b);
  }

  /// From tau on the set is certainly not met for so long, or not_certain. Beyond `room` only as for_ever.
  double apart(double tau, double room) {
    expand_at(tau);
    forget();
    double least = for_ever;
    for (const ContactSet::Piece& piece : set_.pieces()) {
      // Enough to know that it is longer than for another piece; bounds around a ball tell that at less cost.
      if (least < for_ever && longest_apart(piece.around, least, room) >= least) continue;
      least = std::min(least, longest_apart(piece.all, least, room));
      if (least < 0) break;
    }
    return least;
  }

  /// The same for certain contact.
  double within(double tau, double room) {
    expand_at(tau);
    forget();
    double greatest = not_certain;
    for (const ContactSet::Piece& piece : set_.pieces())
      greatest = std::max(greatest, shortest_within(piece.all, greatest, room));
    return greatest;
  }

  /// The set is certainly met at tau.
  bool now_within(double tau) {
    expand_at(tau);
    forget();
    return std::any_of(set_.pieces().begin(), set_.pieces().end(), [this](const ContactSet::Piece& piece) {
      const auto all = set_.members(piece.all);
      return std::all_of(all.begin(), all.end(), [this](int i) { return value_now(i) < 0; });
    });
  }

  /// The set is certainly not met at tau.
  bool now_apart(double tau) {
    expand_at(tau);
    forget();
    return std::all_of(set_.pieces().begin(), set_.pieces().end(), [this](const ContactSet::Piece& piece) {
      const auto all = set_.members(piece.all);
      return std::any_of(all.begin(), all.end(), [this](int i) { return value_now(i) > 0; });
    });
  }

  /// From now on, what is asked about single primitives is as seen from tau.
  [[gnu::always_inline]] void expand_at(double tau) {
    tau_ = tau;
    for (int j = 0; j < D; ++j) {
      const AxisView<> view = view_from<Degree>(relative_.axis[j], tau, relative_.underflow);
      x_[j][0] = {view.p, view.ep};
      x_[j][1] = {view.q, view.eq};
      if constexpr (Degree > 1) x_[j][2] = {view.a, view.ea};
    }
  }

  /// Gives `take` the polynomial of a primitive.
  template <class Take>
  auto with_polynomial(const Primitive& primitive, Take&& take) const {
    const auto wanted = [](const Bounded&) { return true; };
    return foresee::with_polynomial<Degree>(primitive, x_, scratch_.lengths, tau_, wanted, take);
  }

  /// What underflow takes from a coefficient: nothing where there are no products.
  double lost(const Primitive& primitive) const {
    const bool sums = primitive.kind == Primitive::Kind::bound && !primitive.size.moves();
    return sums ? 0 : relative_.underflow + 0x1p-1060;
  }

  const ContactSet& set() const { return set_; }
  const CertainMotion<D>& relative() const { return relative_; }

 private:
  void forget() {
    std::fill(scratch_.known.begin(), scratch_.known.end(), std::numeric_limits<double>::quiet_NaN());
  }

  /// For how long one of these primitives certainly is not met, or not_certain; exact only below `enough`.
  double longest_apart(const ContactSet::Part& part, double enough, double room) {
    double longest = not_certain;
    for (const int i : set_.members(part)) {
      longest = std::max(longest, lasts(i, 1, room));
      if (longest >= enough) break;
    }
    return longest;
  }

  /// For how long all of these primitives certainly are met, or not_certain; exact only above `enough`.
  double shortest_within(const ContactSet::Part& part, double enough, double room) {
    double shortest = for_ever;
    for (const int i : set_.members(part)) {
      shortest = std::min(shortest, lasts(i, -1, room));
      if (shortest <= enough) break;
    }
    return shortest;
  }

  /// For how long primitive i is certainly not met (side 1) or met (-1), or not_certain.
  [[gnu::flatten]] double lasts(int i, double side, double room) {
    const auto place = static_cast<std::size_t>(i);
    double& known = scratch_.known[place];
    if (known == known) return known;
    const Primitive& primitive = set_.primitives()[place];
    const double lost = this->lost(primitive);
    const auto wanted = [side, lost](const Bounded& now) { return side * now.value > now.error_bound(lost); };
    const auto take = [side, lost, room](const auto& p) { return positive_during(p, side, lost, room); };
    return known = foresee::with_polynomial<Degree>(primitive, x_, scratch_.lengths, tau_, wanted, take);
  }

  /// Primitive i at tau: 1: certainly outside, -1: certainly inside, 0: in doubt.
  [[gnu::flatten]] double value_now(int i) {
    const auto place = static_cast<std::size_t>(i);
    double& known = scratch_.known[place];
    if (known == known) return known;
    const Primitive& primitive = set_.primitives()[place];
    Coefficients<Bounded, 0> x[D];
    for (int j = 0; j < D; ++j) x[j] = {x_[j][0]};
    const Bounded value = polynomial_of<0>(primitive, x, scratch_.lengths, tau_)[0];
    const double error = value.error_bound(lost(primitive));
    return known = value.value - error > 0 ? 1 : -value.value - error > 0 ? -1 : 0;
  }

  const ContactSet& set_;
  const CertainMotion<D> relative_;
  CertainScratch& scratch_;
  Coefficients<Bounded, Degree> x_[D];
  double tau_ = 0;
};

}  // namespace foresee
