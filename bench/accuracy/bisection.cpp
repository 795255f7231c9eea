#include <algorithm>
#include <cmath>
#include <cstdio>

#include "accuracy/methods.h"

namespace foresee::bench {
namespace {

/// The pair with bounds on what rounding has already lost.
struct Bounded {
  explicit Bounded(const Family& family, std::size_t i) : pair(family, i) {
    const Bodies bodies[] = {family.a(), family.b()};
    constexpr double u = 0x1p-50;  // far more than the few roundings behind each number lose
    for (int j = 0; j < 3; ++j)
      for (const Bodies& body : bodies) {
        const double* row = body.row(i);
        const double s = std::abs(family.horizon.now - row[body.at.t]), bend = std::abs(row[body.at.a + j]);
        const double speed = std::abs(row[body.at.v + j]) + s * bend;
        lost_x[j] += u * (std::abs(row[body.at.x + j]) + s * speed) + 0x1p-1070 * (1 + s);
        lost_v[j] += u * speed + 0x1p-1070 * (1 + s);
        lost_a[j] += u * bend + 0x1p-1070;
      }
  }

  /// Whether the pair is certainly apart during all of [middle - around, middle + around].
  bool apart(bool balls, double middle, double around) const {
    constexpr double u = 0x1p-48;
    double square = 0, size = 0;
    for (int j = 0; j < 3; ++j) {
      const double speed = std::abs(pair.v[j]) + middle * std::abs(pair.a[j]);
      const double place = pair.x[j] + middle * (pair.v[j] + 0.5 * pair.a[j] * middle);
      const double steep = std::abs(pair.v[j] + pair.a[j] * middle);
      const double lost = lost_x[j] + middle * (lost_v[j] + middle * lost_a[j]) +
                          u * (std::abs(pair.x[j]) + (middle + around) * speed) + 0x1p-1060;
      const double moved =
          around * (steep + lost_v[j] + u * speed + around * (std::abs(pair.a[j]) + lost_a[j]));
      const double distance = std::max(0.0, std::abs(place) - moved * (1 + u) - lost);
      if (!balls && distance > pair.half[j] * (1 + u)) return true;
      square += distance * distance, size = pair.r * pair.r;
    }
    return balls && square > size * (1 + u) + 0x1p-1060;
  }

  Seen<double> pair;
  double lost_x[3] = {}, lost_v[3] = {}, lost_a[3] = {};
};

/// The earliest interval no longer than `narrow` that cannot be proved apart.
Answer search(const Bounded& pair, bool balls, double h, double narrow) {
  struct SlopeSign {
    double begin, length;
  };
  SlopeSign open[128];
  int count = 0;
  open[count++] = {0, h};
  for (int evaluations = 0; count > 0 && evaluations < 1000000; ++evaluations) {
    const SlopeSign s = open[--count];
    const double half = s.length / 2;
    if (pair.apart(balls, s.begin + half, half * (1 + 0x1p-40))) continue;
    if (s.length <= narrow || count > 120) return {true, s.begin};
    open[count++] = {s.begin + half, half};
    open[count++] = {s.begin, half};
  }
  return {count > 0, count > 0 ? open[count - 1].begin : 0};
}

}  // namespace

Method bisection(const Family& family, double tolerance) {
  char name[16];
  std::snprintf(name, sizeof name, "%.0e", tolerance);
  const double h = family.horizon.h, narrow = tolerance * h;
  return one_by_one("bisection", name, [&family, h, narrow](std::size_t i) {
    return search(Bounded(family, i), family.balls(), h, narrow);
  });
}

}  // namespace foresee::bench
