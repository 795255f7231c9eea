// Axes and degree, known at run time, become numbers that the types of contact know.
//
//   return make_typed<BoxContact>(setup.a.layout.axes, degree, setup);        // a BoxContact<2, 1>, perhaps
#pragma once

#include <memory>
#include <utility>

#include "base/axes.h"
#include "contact/contact.h"

namespace foresee::contact {

/// A Made<D, Degree> of these arguments. Requires: axes is 1, 2 or 3; degree at most 2, and 0 counts as 1.
template <template <int D, int Degree> class Made, class... Arguments>
std::unique_ptr<Contact> make_typed(int axes, int degree, Arguments&&... arguments) {
  return with_axes(axes, [&]<int D>(Axes<D>) -> std::unique_ptr<Contact> {
    if (degree < 2) return std::make_unique<Made<D, 1>>(std::forward<Arguments>(arguments)...);
    return std::make_unique<Made<D, 2>>(std::forward<Arguments>(arguments)...);
  });
}

}  // namespace foresee::contact
