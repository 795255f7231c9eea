#include "contact/set_contact.h"

#include "contact/set/shape_pairs.h"

namespace foresee::contact {
namespace {

template <int D>
std::unique_ptr<Contact> make_for_degree(const Setup& setup, ContactSet set, int degree) {
  if (std::max(degree, set.degree()) < 2) return std::make_unique<SetContact<D, 1>>(setup, std::move(set));
  return std::make_unique<SetContact<D, 2>>(setup, std::move(set));
}

}  // namespace

std::unique_ptr<Contact> make_set_contact(const Setup& setup, ContactSet set, int degree) {
  switch (setup.a.layout.axes) {
    case 1:
      return make_for_degree<1>(setup, std::move(set), degree);
    case 2:
      return make_for_degree<2>(setup, std::move(set), degree);
    default:
      return make_for_degree<3>(setup, std::move(set), degree);
  }
}

}  // namespace foresee::contact
