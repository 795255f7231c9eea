// Turns a number of axes known at run time into a template argument: the only place that does so.
//
//   with_axes(3, [&]<int D>(Axes<D>) { return std::array<double, D>{}.size(); }) == 3
#pragma once

#include <type_traits>
#include <utility>

namespace foresee {

template <int D>
using Axes = std::integral_constant<int, D>;

/// Calls use(Axes<axes>{}). Requires: axes is 1, 2 or 3.
template <class Use>
decltype(auto) with_axes(int axes, Use&& use) {
  switch (axes) {
    case 1:
      return std::forward<Use>(use)(Axes<1>{});
    case 2:
      return std::forward<Use>(use)(Axes<2>{});
    default:
      return std::forward<Use>(use)(Axes<3>{});
  }
}

}  // namespace foresee
