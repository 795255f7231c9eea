// What the doors hand out: a contact that answers by a set or by the lanes of boxes. Axes and degree, known
// at run time, become numbers that its type knows.
//
//   return make_typed<BoxContact>(setup.a.layout.axes, degree, setup);        // a BoxContact<2, 1>, perhaps
#pragma once

#include <memory>
#include <utility>

#include "base/axes.h"
#include "contact/contact.h"
#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"

namespace foresee {

/// Answers by a set. `degree`: of the relative motion, at most 2.
std::unique_ptr<Contact> make_set_contact(const Setup& setup, ContactSet set, int degree);
/// Answers by box_box_set(), sixteen pairs at once.
std::unique_ptr<Contact> make_box_contact(const Setup& setup, int degree);

/// A Made<D, Degree> of these arguments. Requires: axes is 1, 2 or 3; degree at most 2, and 0 counts as 1.
template <template <int D, int Degree> class Made, class... Arguments>
std::unique_ptr<Contact> make_typed(int axes, int degree, Arguments&&... arguments) {
  return with_axes(axes, [&]<int D>(Axes<D>) -> std::unique_ptr<Contact> {
    if (degree < 2) return std::make_unique<Made<D, 1>>(std::forward<Arguments>(arguments)...);
    return std::make_unique<Made<D, 2>>(std::forward<Arguments>(arguments)...);
  });
}

}  // namespace foresee
