#include "contact/boxes/box_contact.h"

#include "contact/typed_contact.h"

namespace foresee {

std::unique_ptr<Contact> make_box_contact(const Setup& setup, int degree) {
  return make_typed<BoxContact>(setup.a.layout.axes, degree, setup);
}

}  // namespace foresee
