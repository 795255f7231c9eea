#include "contact/set_contact.h"

#include "contact/typed_contact.h"

namespace foresee {

std::unique_ptr<Contact> make_set_contact(const Setup& setup, ContactSet set, int degree) {
  const int highest = std::max(degree, set.degree());
  return make_typed<SetContact>(setup.a.layout.axes, highest, setup, std::move(set));
}

}  // namespace foresee
