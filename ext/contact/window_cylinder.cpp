#include "contact/window_cylinder.h"

#include "contact/kinds.h"
#include "contact/typed_contact.h"

namespace foresee {

std::unique_ptr<Contact> make_window_cylinder(const Setup& setup, int degree) {
  return make_typed<WindowCylinder>(setup, degree);
}

}  // namespace foresee
