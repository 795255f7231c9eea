#include "contact/cylinder_box.h"

#include "contact/kinds.h"
#include "contact/typed_contact.h"

namespace foresee {

std::unique_ptr<Contact> make_cylinder_box(const Setup& setup, int degree) {
  return make_typed<CylinderBox>(setup, degree);
}

}  // namespace foresee
