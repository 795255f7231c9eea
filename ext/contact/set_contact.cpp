#include "contact/set_contact.h"

#include "contact/typed_contact.h"

namespace foresee {

std::unique_ptr<Contact> make_set_contact(const Setup& setup, ContactSet set, int degree) {
  const int highest = std::max(degree, set.degree());
  return make_typed<SetContact>(setup.a.layout.axes, highest, setup, std::move(set));
}

// Contact over one axis: a file of its own, as it takes long to compile.

template class SetContact<1, 1>;
template class SetContact<1, 2>;

// Contact over two axes: a file of its own, as it takes long to compile.

template class SetContact<2, 1>;
template class SetContact<2, 2>;

// Contact over three axes: a file of its own, as it takes long to compile.

template class SetContact<3, 1>;
template class SetContact<3, 2>;

}  // namespace foresee
