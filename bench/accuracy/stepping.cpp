#include <cmath>

#include "accuracy/methods.h"

namespace foresee::bench {
namespace {

bool touches_at(const Seen<double>& pair, bool balls, double t) {
  double square = 0;
  for (int j = 0; j < 3; ++j) {
    const double place = pair.x[j] + t * (pair.v[j] + 0.5 * pair.a[j] * t);
    if (!balls && !(std::abs(place) <= pair.half[j])) return false;
    square += place * place;
  }
  return !balls || square <= pair.r * pair.r;
}

}  // namespace

Method stepping(const Family& family, int steps) {
  const double h = family.horizon.h;
  return one_by_one("stepping", std::to_string(steps), [&family, steps, h](std::size_t i) -> Answer {
    const Seen<double> pair(family, i);
    for (int k = 0; k <= steps; ++k) {
      const double t = h * k / steps;
      if (touches_at(pair, family.balls(), t)) return {true, t};
    }
    return {};
  });
}

}  // namespace foresee::bench
