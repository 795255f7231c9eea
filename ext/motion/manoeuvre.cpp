#include "motion/manoeuvre.h"

#include <cmath>

#include "numbers/correct_rounding.h"

namespace foresee {
std::string_view name_of(Manoeuvre manoeuvre) {
  constexpr std::string_view names[] = {"turn", "speed", "climb", "accelerate", "delay", "wait"};
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

bool is_finite(const OwnMotion& motion) {
  bool finite = std::isfinite(motion.t) && std::isfinite(motion.mass);
  for (std::size_t j = 0; j < 3; ++j)
    finite = finite && std::isfinite(motion.x[j]) && std::isfinite(motion.v[j]) &&
             std::isfinite(motion.a[j]) && std::isfinite(motion.force[j]);
  return finite;
}

}  // namespace foresee
