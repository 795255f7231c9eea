#include "contact/boxes/box_contact.h"

namespace foresee::contact {
namespace {

template <int D>
std::unique_ptr<Contact> make_for_degree(const Setup& setup, int degree) {
  if (degree < 2) return std::make_unique<BoxContact<D, 1>>(setup);
  return std::make_unique<BoxContact<D, 2>>(setup);
}

}  // namespace

std::unique_ptr<Contact> make_box_contact(const Setup& setup, int degree) {
  if (setup.a.layout.axes == 1) return make_for_degree<1>(setup, degree);
  return setup.a.layout.axes == 2 ? make_for_degree<2>(setup, degree) : make_for_degree<3>(setup, degree);
}

}  // namespace foresee::contact
