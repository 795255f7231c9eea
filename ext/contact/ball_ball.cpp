#include "contact/ball_ball.h"

#include "contact/kinds.h"
#include "contact/typed_contact.h"

namespace foresee {

std::unique_ptr<Contact> make_ball_ball(const Setup& setup, int degree) {
  return make_typed_for_axes<BallBall>(setup, degree);
}

}  // namespace foresee
