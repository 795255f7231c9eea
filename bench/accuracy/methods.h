// Methods for the first contact of a pair that the report on accuracy compares, one file each.
//
// Every method reads the same stored rows and gives a decision and the start of the first contact, in seconds
// from now.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "accuracy/families.h"

namespace foresee::bench {

struct Answer {
  bool hit = false;
  double dt = 0;
};

struct Method {
  std::string name;
  std::string parameter;
  /// Results for `count` pairs from `first` on.
  std::function<void(std::size_t first, std::size_t count, Answer* out)> answer;
};

/// Tests steps + 1 times, evenly spaced.
Method stepping(const Family& family, int steps);

/// The formulas of textbooks in float; in double; in double with the discriminant and the polynomials by
/// fused multiply-add and the root that does not cancel. Boxes: a quadratic per side; balls: the expanded
/// quartic, its roots between the roots of its derivatives.
Method textbook_float(const Family& family);
Method textbook_double(const Family& family);
Method textbook_fma(const Family& family);

/// Bisects the horizon and discards intervals in which interval arithmetic (outward) proves the pair apart.
/// An interval that is left at a `tolerance` of the horizon counts as a contact. Misses nothing.
Method bisection(const Family& family, double tolerance);

/// The expanded quartic by Boost's quartic_roots (Ferrari, then Halley). Balls only; empty name without
/// Boost 1.80.
Method boost_quartic(const Family& family);

/// One pair as a method reads it: at `now`, b minus a, in the arithmetic of T.
template <class T>
struct Seen {
  T x[3], v[3], a[3];
  T half[3], r;

  Seen(const Family& family, std::size_t i) {
    const Bodies bodies[] = {family.a(), family.b()};
    const Offsets& at = bodies[0].at;
    const double* row[] = {bodies[0].row(i), bodies[1].row(i)};
    const T s[] = {static_cast<T>(family.horizon.now - row[0][at.t]),
                   static_cast<T>(family.horizon.now - row[1][at.t])};
    for (int j = 0; j < 3; ++j) {
      T place[2], speed[2];
      for (int k = 0; k < 2; ++k) {
        const T start = static_cast<T>(row[k][at.x + j]), v0 = static_cast<T>(row[k][at.v + j]);
        const T bend = static_cast<T>(row[k][at.a + j]);
        place[k] = start + s[k] * (v0 + T(0.5) * bend * s[k]);
        speed[k] = v0 + bend * s[k];
      }
      x[j] = place[1] - place[0], v[j] = speed[1] - speed[0];
      a[j] = static_cast<T>(row[1][at.a + j]) - static_cast<T>(row[0][at.a + j]);
      half[j] =
          family.balls() ? T(0) : static_cast<T>(row[0][at.half + j]) + static_cast<T>(row[1][at.half + j]);
    }
    r = family.balls() ? static_cast<T>(row[0][at.r]) + static_cast<T>(row[1][at.r]) : T(0);
  }
};

/// |x + v t + a t^2 / 2|^2 - r^2, expanded: c[k] belongs to the k-th power.
template <class T>
struct Quartic {
  T c[5] = {};

  explicit Quartic(const Seen<T>& pair) {
    c[0] = -pair.r * pair.r;
    for (int j = 0; j < 3; ++j) {
      c[0] += pair.x[j] * pair.x[j];
      c[1] += 2 * pair.x[j] * pair.v[j];
      c[2] += pair.v[j] * pair.v[j] + pair.x[j] * pair.a[j];
      c[3] += pair.v[j] * pair.a[j];
      c[4] += T(0.25) * pair.a[j] * pair.a[j];
    }
  }
};

/// A method that processes one pair at a time.
template <class One>
Method one_by_one(std::string name, std::string parameter, One one) {
  return {std::move(name), std::move(parameter), [one](std::size_t first, std::size_t count, Answer* out) {
            for (std::size_t i = 0; i < count; ++i) out[i] = one(first + i);
          }};
}

}  // namespace foresee::bench
