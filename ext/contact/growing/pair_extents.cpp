#include "contact/growing/pair_extents.h"

namespace foresee::contact {
namespace {

/// What sums of three lengths may be short of.
constexpr double rounded_up = 1 + 0x1p-50;

}  // namespace

ExtentsRule::ExtentsRule(const Layout& a, const Layout& b, double within, std::optional<double> within_z)
    : a_(row_offsets(a)), b_(row_offsets(b)), within_(within), within_z_(within_z.value_or(0)) {
  const bool boxes = a.shape == Shape::box && b.shape == Shape::box;
  upright_ = a.shape == Shape::cylinder || b.shape == Shape::cylinder || within_z.has_value();
  round_ = !upright_ && !boxes && a.axes > 1;
}

template <int D>
PairExtents<D> ExtentsRule::pair(const double* row_a, const double* row_b) const {
  const auto both = [&](int Offsets::*place, int axis) {
    const auto at = [axis](const Offsets& offsets, int Offsets::*where) {
      return offsets.*where == Offsets::absent ? Offsets::absent : offsets.*where + axis;
    };
    return value_or(row_a, at(a_, place), 0) + value_or(row_b, at(b_, place), 0);
  };
  PairExtents<D> pair;
  for (int axis = 0; axis < D; ++axis) pair.half[axis] = both(&Offsets::half, axis);
  const double r = both(&Offsets::r, 0);
  pair.round_axes = D;
  pair.radius = 0;
  if (upright_) {
    pair.round_axes = 2;
    pair.radius = r + within_;
    if constexpr (D == 3) pair.half[2] += both(&Offsets::hz, 0) + within_z_;
  } else if (round_) {
    pair.radius = r + within_;
  } else {
    pair.half += r + within_;  // between boxes, and on one axis: per axis
  }
  pair.radius *= rounded_up, pair.half *= rounded_up;
  return pair;
}

template PairExtents<1> ExtentsRule::pair<1>(const double*, const double*) const;
template PairExtents<2> ExtentsRule::pair<2>(const double*, const double*) const;
template PairExtents<3> ExtentsRule::pair<3>(const double*, const double*) const;

}  // namespace foresee::contact
