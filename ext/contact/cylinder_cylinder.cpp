#include "contact/cylinder_cylinder.h"

#include "contact/kinds.h"
#include "contact/typed_contact.h"

namespace foresee {

std::unique_ptr<Contact> make_cylinder_cylinder(const Setup& setup, int degree) {
  return make_typed<CylinderCylinder>(setup, degree);
}

}  // namespace foresee
