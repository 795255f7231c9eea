// Vectors of one to three axes, in the scene's own unit of length.
#pragma once

#include <Eigen/Core>

namespace foresee {

/// An array, not a vector in Eigen's sense: `*`, `<` and `max` go axis by axis, as boxes need.
template <int D>
using Vec = Eigen::Array<double, D, 1>;

}  // namespace foresee
