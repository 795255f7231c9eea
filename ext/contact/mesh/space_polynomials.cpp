#include "contact/mesh/space_polynomials.h"

#include <algorithm>

#include "contact/mesh/round_parts.h"

namespace foresee {
SpacePolynomials::SpacePolynomials(const Setup& setup, const double* row_a, const double* row_b,
                                   const SpacePieces& a, const SpacePieces& b,
                                   std::span<const PiecePair> pairs, bool grown)
    : setup_(setup),
      row_a_(row_a),
      row_b_(row_b),
      rough_motion_(motion_powers<Midrad128>(setup, row_a, row_b)) {
  for (const PiecePair& pair : pairs) {
    add(a.piece(pair.a), b.piece(pair.b), grown);
    ends_.push_back(static_cast<std::uint32_t>(set_.pieces().size()));
  }
  number_of_.assign(conditions_.size(), -1);
}

int SpacePolynomials::add(const SpaceCondition& condition) {
  conditions_.push_back(condition);
  return static_cast<int>(conditions_.size()) - 1;
}

void SpacePolynomials::add(const SpacePiece& a, const SpacePiece& b, bool grown) {
  Conditions core;
  SpaceHull(a, b).for_each([&](const SpacePlanes& planes) {
    core.all.push_back(add(planes.before)), core.all.push_back(add(planes.beyond));
    return true;
  });
  set_.add_piece(core);
  if (!grown) return;
  RoundParts(a, b).for_each([this](const RoundPart& part) {
    Conditions conditions;
    for (int i = 0; i < part.count; ++i)
      conditions.all.push_back(add(part.beside[static_cast<std::size_t>(i)]));
    conditions.ball = add(part.round);
    conditions.all.push_back(conditions.ball);
    set_.add_piece(conditions);
    return true;
  });
}

template <class T>
Powers<T, 4> SpacePolynomials::polynomial_of(int primitive, const std::array<Powers<T, 2>, 3>& x) const {
  Powers<T, 4> all{};
  const SpaceSizes<T> sizes{.radius = radius_of<T>(setup_, row_a_, row_b_)};
  with_polynomial<2>(conditions_[static_cast<std::size_t>(primitive)], x, sizes,
                     [&all](const auto& p) { std::copy(p.begin(), p.end(), all.begin()); });
  return all;
}

std::size_t SpacePolynomials::number_of(int primitive) {
  int& number = number_of_[static_cast<std::size_t>(primitive)];
  if (number < 0) {
    number = static_cast<int>(polynomials_.size());
    polynomials_.emplace_back(polynomial_of(primitive, rough_motion_), *this, primitive);
  }
  return static_cast<std::size_t>(number);
}

Polynomial SpacePolynomials::exact_polynomial(int primitive) const {
  if (!exact_motion_) exact_motion_ = motion_powers<Dyadic>(setup_, row_a_, row_b_);
  return Polynomial(polynomial_of(primitive, *exact_motion_));
}

}  // namespace foresee
