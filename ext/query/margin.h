// Margin by which swept boxes are inflated, from the distance at which a pair counts as touching.
#pragma once

#include <cmath>
#include <limits>

#include "contact/pair_rule.h"
#include "motion/motion.h"

namespace foresee {

/// Half the reach, rounded up, for the swept boxes of each side: two inflated boxes intersect wherever the
/// pair can touch.
template <int D>
Vec<D> margin_of(const PairRule::Reach& reach) {
  auto half = [](double whole) {
    return whole > 0 ? std::nextafter(whole / 2, std::numeric_limits<double>::infinity()) : 0.0;
  };
  Vec<D> margin = Vec<D>::constant(half(reach.within));
  if constexpr (D == 3) margin[2] = half(reach.within_z);
  return margin;
}

}  // namespace foresee
