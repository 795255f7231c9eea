#include "contact/window_box.h"

#include "contact/kinds.h"
#include "contact/typed_contact.h"

namespace foresee {

std::unique_ptr<Contact> make_window_box(const Setup& setup, int degree) {
  if (setup.a.layout.axes == 1) return make_typed<WindowBox<1>>(setup, degree);
  return make_typed_for_axes<WindowBox>(setup, degree);
}

}  // namespace foresee
