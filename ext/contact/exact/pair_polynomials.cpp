#include "contact/exact/pair_polynomials.h"

#include <algorithm>

namespace foresee {

PairPolynomials::PairPolynomials(const ContactSet& set, const Setup& setup, const double* row_a,
                                 const double* row_b)
    : set_(set),
      setup_(setup),
      row_a_(row_a),
      row_b_(row_b),
      rough_motion_(motion_coefficients<Midrad128>(setup, row_a, row_b)),
      number_of_(set.primitives().size(), -1) {}

Polynomial PairPolynomials::exact_polynomial(int primitive) const {
  if (!exact_motion_) exact_motion_ = motion_coefficients<Dyadic>(setup_, row_a_, row_b_);
  return Polynomial(polynomial_of<2>(set_.primitives()[static_cast<std::size_t>(primitive)],
                                     exact_motion_->data(), PairLengths<Dyadic>{set_, row_a_, row_b_}, 0.0));
}

std::size_t PairPolynomials::number_of(int primitive) {
  int& number = number_of_[static_cast<std::size_t>(primitive)];
  if (number >= 0) return static_cast<std::size_t>(number);
  const Primitive& p = set_.primitives()[static_cast<std::size_t>(primitive)];
  if (p.kind == Primitive::Kind::bound) {
    for (const int known : bounds_)
      if (same_bound(p, set_.primitives()[static_cast<std::size_t>(known)])) {
        number = number_of_[static_cast<std::size_t>(known)];
        return static_cast<std::size_t>(number);
      }
    bounds_.push_back(primitive);
  }
  number = static_cast<int>(polynomials_.size());
  const PairLengths<Midrad128> lengths{set_, row_a_, row_b_};
  polynomials_.emplace_back(polynomial_of<2>(p, rough_motion_.data(), lengths, 0.0), *this, primitive);
  return static_cast<std::size_t>(number);
}

bool PairPolynomials::same_bound(const Primitive& a, const Primitive& b) const {
  return a.parts[0].axis == b.parts[0].axis && a.parts[0].sign == b.parts[0].sign &&
         same_length(a.size.value, b.size.value) && same_length(a.size.rate, b.size.rate);
}

/// Lengths of bounds differ by the radius alone. Adding a number other than 0 always changes the bits of a
/// Midrad128 or of its error.
bool PairPolynomials::same_length(int a, int b) const {
  const PairLengths<Midrad128> lengths{set_, row_a_, row_b_};
  return a == b || identical(length_at<Midrad128>(lengths, a), length_at<Midrad128>(lengths, b));
}

}  // namespace foresee
