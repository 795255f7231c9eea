#include "contact/clearance/pair_extents.h"

namespace foresee {
namespace {

/// Upper bound of the relative error of sums of lengths.
constexpr double rounded_up = 0x1p-50;

/// The extents whose sizes are size(each size of the rule).
template <int D, class SizeOf>
PairExtents<D> composed(const PairRule& rule, const SizeOf& size) {
  PairExtents<D> pair{Vec<D>::Zero(), size(rule.radius), rule.distance == Distance::upright ? 2 : D};
  for (int axis = 0; axis < D; ++axis) pair.half[axis] = size(rule.extent[axis]);
  return pair;
}

}  // namespace

template <int D>
GrowingExtents<D> extents_of_both(const PairRule& rule, const double* row_a, const double* row_b,
                                  double time) {
  const auto size = [&](const PairSize& both) { return size_as_of_t<double>(both, row_a, row_b); };
  GrowingExtents<D> pair{composed<D>(rule, size)};
  if (rule.grows) {
    // The size that growth adds in these times.
    const auto grown = [&](double age_a, double age_b) {
      return [&, age_a, age_b](const PairSize& both) {
        return age_a * value_or(row_a, both.growth_a, 0) + age_b * value_or(row_b, both.growth_b, 0);
      };
    };
    const double age_a = time - value_or(row_a, rule.t_a, 0), age_b = time - value_or(row_b, rule.t_b, 0);
    pair.growth = composed<D>(rule, grown(1 + rounded_up, 1 + rounded_up));
    pair.grows = pair.growth.radius > 0 || (pair.growth.half > 0).any();
    pair.add(composed<D>(rule, grown(std::abs(age_a), std::abs(age_b))), rounded_up);
    pair.add(composed<D>(rule, grown(age_a, age_b)));
  }
  pair.half += rounded_up * pair.half.abs(), pair.radius += rounded_up * std::abs(pair.radius);
  return pair;
}

template GrowingExtents<1> extents_of_both<1>(const PairRule&, const double*, const double*, double);
template GrowingExtents<2> extents_of_both<2>(const PairRule&, const double*, const double*, double);
template GrowingExtents<3> extents_of_both<3>(const PairRule&, const double*, const double*, double);

}  // namespace foresee
