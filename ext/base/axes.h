// A number of axes known at run time becomes one that types know: the one place where that happens.
//
//   with_axes(3, [&]<int D>(Axes<D>) { return std::array<double, D>{}.size(); }) == 3
#pragma once

#include <type_traits>
#include <utility>

namespace foresee {

template <int D>
using Axes = std::integral_constant<int, D>;

/// use(Axes<axes>{}). Requires: axes is 1, 2 or 3.
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
