#include "motion/manoeuvre.h"

#include <cmath>

#include "numbers/correct_rounding.h"

namespace foresee {
namespace {

/// Turns the vector in x and y.
void turn(std::array<double, 3>& vector, double degrees) {
  const Turned turned = turned_clockwise(vector[0], vector[1], degrees);
  vector[0] = turned.x, vector[1] = turned.y;
}

/// The sum, with a whole turn subtracted or added if it is beyond 360 or below -360.
double turned_heading(double heading, double degrees) {
  Dyadic sum = Dyadic(heading) + Dyadic(degrees);
  const Dyadic whole(360.0);
  if (sum > whole) sum = sum - whole;
  if (sum < -whole) sum = sum + whole;
  return rounded(sum) + 0.0;
}

/// a + k b / m, where b is one component of the velocity.
double added_along(double a, double k, double b, double m) {
  return rounded_quotient(Dyadic(a) * Dyadic(m) + Dyadic(k) * Dyadic(b), Dyadic(m));
}

void change_speed(OwnMotion& motion, const Change& change, double k) {
  const Dyadic m(change.speed), speed = m + Dyadic(k);
  for (double& v : motion.v) v = rounded_quotient(Dyadic(v) * speed, m);
  if (!change.scales_bend) return;
  for (double& a : motion.a) a = rounded_quotient(Dyadic(a) * speed * speed, m * m);
}

void take_acceleration_of_force(OwnMotion& motion) {
  if (motion.mass == 0) return;
  for (std::size_t j = 0; j < 3; ++j) motion.a[j] = motion.force[j] / motion.mass;
}

void accelerate(OwnMotion& motion, double m, double k) {
  for (std::size_t j = 0; j < 3; ++j) {
    if (motion.mass == 0) {
      motion.a[j] = added_along(motion.a[j], k, motion.v[j], m);
      continue;
    }
    const Dyadic along = Dyadic(k) * Dyadic(motion.mass) * Dyadic(motion.v[j]);
    motion.force[j] = rounded_quotient(Dyadic(motion.force[j]) * Dyadic(m) + along, Dyadic(m));
  }
  take_acceleration_of_force(motion);
}

}  // namespace

std::string_view name_of(Manoeuvre manoeuvre) {
  constexpr std::string_view names[] = {"turn", "speed", "climb", "accelerate", "delay"};
  return names[static_cast<std::size_t>(manoeuvre)];
}

OwnMotion motion_from(const OwnMotion& motion, double s) {
  if (s == motion.t) return motion;
  OwnMotion from = motion;
  from.t = s;
  const Dyadic time = Dyadic(s) - Dyadic(motion.t);
  for (std::size_t j = 0; j < 3; ++j) {
    const Dyadic v(motion.v[j]), gained = time * Dyadic(motion.a[j]);
    from.v[j] = rounded(v + gained) + 0.0;
    from.x[j] = rounded(Dyadic(motion.x[j]) + time * (v + half_of(gained))) + 0.0;
  }
  return from;
}

double speed_of(const OwnMotion& motion) {
  Dyadic square;
  for (const double v : motion.v) {
    if (!std::isfinite(v)) return std::numeric_limits<double>::infinity();
    square = square + Dyadic(v) * Dyadic(v);
  }
  return rounded_root(square);
}

OwnMotion changed(const OwnMotion& base, const Change& change, double k) {
  OwnMotion motion = base;
  if (k == 0 || !is_finite(base)) return motion;
  switch (change.manoeuvre) {
    case Manoeuvre::turn:
      turn(motion.v, k), turn(motion.force, k), turn(motion.a, k);
      take_acceleration_of_force(motion);
      motion.heading = turned_heading(motion.heading, k);
      break;
    case Manoeuvre::speed:
      change_speed(motion, change, k);
      break;
    case Manoeuvre::climb:
      motion.v[2] += k;
      break;
    case Manoeuvre::accelerate:
      accelerate(motion, change.speed, k);
      break;
    case Manoeuvre::delay:
      motion.t += k, motion.until += k;
      break;
  }
  return motion;
}

bool is_finite(const OwnMotion& motion) {
  bool finite = std::isfinite(motion.t) && std::isfinite(motion.mass);
  for (std::size_t j = 0; j < 3; ++j)
    finite = finite && std::isfinite(motion.x[j]) && std::isfinite(motion.v[j]) &&
             std::isfinite(motion.a[j]) && std::isfinite(motion.force[j]);
  return finite;
}

}  // namespace foresee
