// make_set_contact(): contact by one contact set for all pairs (set_traits.h). Only this file compiles the engine for
// sets, which takes long; box_contact.cpp uses it too.
#include <algorithm>

#include "contact/contact_factories.h"
#include "contact/set/set_traits.h"

namespace foresee {

std::unique_ptr<Contact> make_set_contact(const Setup& setup, ContactSet set, int degree) {
  const int highest = std::max(degree, set.degree());
  return make_typed<SetContact>(setup.a.layout.axes, highest, setup, std::move(set));
}

template class UnionContact<SetTraits<1, 1>>;
template class UnionContact<SetTraits<1, 2>>;
template class UnionContact<SetTraits<2, 1>>;
template class UnionContact<SetTraits<2, 2>>;
template class UnionContact<SetTraits<3, 1>>;
template class UnionContact<SetTraits<3, 2>>;

}  // namespace foresee
