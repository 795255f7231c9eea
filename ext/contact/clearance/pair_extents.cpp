#include "contact/clearance/pair_extents.h"

#include "shape/shapes.h"

namespace foresee {
namespace {

/// Upper bound of the relative error of sums of lengths.
constexpr double rounded_up = 0x1p-50;

}  // namespace

ExtentsRule::ExtentsRule(const Layout& a, const Layout& b, double within, std::optional<double> within_z)
    : a_{a, row_offsets(a)}, b_{b, row_offsets(b)}, within_(within), within_z_(within_z.value_or(0)) {
  const bool boxes = a.shape == Shape::box && b.shape == Shape::box;
  pieces_ = a.shape == Shape::outline || b.shape == Shape::outline;
  upright_ = a.shape == Shape::cylinder || b.shape == Shape::cylinder || within_z.has_value() ||
             (pieces_ && a.axes == 3);
  round_ = !upright_ && !boxes && a.axes > 1;
}

template <int D, class Size>
PairExtents<D> ExtentsRule::composed(const Size& size, double within, double within_z) const {
  PairExtents<D> pair{Vec<D>::Zero(), 0, upright_ ? 2 : D};
  for (int axis = pieces_ ? 2 : 0; axis < D; ++axis) pair.half[axis] = size(&Offsets::half, axis);
  const double r = size(&Offsets::r, 0) + within;
  if (upright_) {
    pair.radius = r;
    if constexpr (D == 3) pair.half[2] += size(&Offsets::hz, 2) + within_z;
  } else if (round_) {
    pair.radius = r;
  } else {
    pair.half += r;  // between boxes, and on one axis: per axis
  }
  return pair;
}

template <int D>
GrowingExtents<D> ExtentsRule::pair(const double* row_a, const double* row_b, double time) const {
  const auto size = [&](int Offsets::*place, int axis) {
    const auto one = [&](const Side& side, const double* row) {
      const int at = side.at.*place;
      return at == Offsets::absent ? 0 : row[place == &Offsets::half ? at + axis : at];
    };
    return one(a_, row_a) + one(b_, row_b);
  };
  GrowingExtents<D> pair{composed<D>(size, within_, within_z_)};
  if (grows(a_.layout) || grows(b_.layout)) {
    // The size that growth adds in these times.
    const auto grown = [&](double age_a, double age_b) {
      return [&, age_a, age_b](int Offsets::*place, int axis) {
        const auto one = [&](const Side& side, const double* row, double age) {
          const bool is_box = side.layout.shape == Shape::box;
          if (is_box != (place == &Offsets::half)) return 0.0;
          return age * value_or(row, growth_place(side.layout.shape, side.at, axis), 0);
        };
        return one(a_, row_a, age_a) + one(b_, row_b, age_b);
      };
    };
    const double age_a = time - value_or(row_a, a_.at.t, 0), age_b = time - value_or(row_b, b_.at.t, 0);
    pair.growth = composed<D>(grown(1 + rounded_up, 1 + rounded_up), 0, 0);
    pair.grows = pair.growth.radius > 0 || (pair.growth.half > 0).any();
    pair.add(composed<D>(grown(std::abs(age_a), std::abs(age_b)), 0, 0), rounded_up);
    pair.add(composed<D>(grown(age_a, age_b), 0, 0));
  }
  pair.half += rounded_up * pair.half.abs(), pair.radius += rounded_up * std::abs(pair.radius);
  return pair;
}

template GrowingExtents<1> ExtentsRule::pair<1>(const double*, const double*, double) const;
template GrowingExtents<2> ExtentsRule::pair<2>(const double*, const double*, double) const;
template GrowingExtents<3> ExtentsRule::pair<3>(const double*, const double*, double) const;

}  // namespace foresee
