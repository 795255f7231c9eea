#include "contact/window_ball.h"

#include "contact/kinds.h"
#include "contact/typed_contact.h"

namespace foresee {

std::unique_ptr<Contact> make_window_ball(const Setup& setup, int degree) {
  return make_typed_for_axes<WindowBall>(setup, degree);
}

}  // namespace foresee
