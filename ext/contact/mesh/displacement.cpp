#include "contact/mesh/displacement.h"

#include "contact/exact/pair_polynomials.h"

namespace foresee {

Displacement::Displacement(const Setup& setup, const double* row_a, const double* row_b,
                           const CertainMotion<3>& relative, const Dyadic& moment)
    : setup_(setup), row_a_(row_a), row_b_(row_b), moment_(moment) {
  const double tau = rounded(moment);
  const Bounded time{tau, unit_roundoff * std::abs(tau) + 0x1p-1070};
  for (std::size_t j = 0; j < 3; ++j) {
    const auto& axis = relative.axis[j];
    near_[j] = Bounded{axis.x, axis.ex} + time * (Bounded{axis.v, axis.ev} + time * Bounded{axis.a, axis.ea});
    near_[j].error = near_[j].error_bound(relative.underflow);
  }
}

const Components<Dyadic>& Displacement::exact() {
  if (exact_) return *exact_;
  const auto x = motion_powers<Dyadic>(setup_, row_a_, row_b_);
  exact_.emplace();
  for (std::size_t j = 0; j < 3; ++j) (*exact_)[j] = x[j][0] + moment_ * (x[j][1] + moment_ * x[j][2]);
  return *exact_;
}

SeenCorner::SeenCorner(const SpaceCorner& corner, int sign, Displacement& d)
    : corner_(corner), sign_(sign), d_(d) {
  const Components<Bounded> place{Bounded{corner.x}, Bounded{corner.y}, Bounded{corner.z}};
  for (std::size_t j = 0; j < 3; ++j) {
    near_[j] = sign < 0 ? place[j] - d.near()[j] : place[j] + d.near()[j];
    near_[j].error = near_[j].error_bound(0x1p-1060);
  }
}

const Components<Dyadic>& SeenCorner::exact() {
  if (exact_) return *exact_;
  const Components<Dyadic> place{Dyadic(corner_.x), Dyadic(corner_.y), Dyadic(corner_.z)};
  exact_.emplace();
  for (std::size_t j = 0; j < 3; ++j)
    (*exact_)[j] = sign_ < 0 ? place[j] - d_.exact()[j] : place[j] + d_.exact()[j];
  return *exact_;
}

}  // namespace foresee
