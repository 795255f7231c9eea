// Separation of two that touch, on bent paths, in long double: the reference for the certificates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace foresee::testing {

/// The relative motion of two from the change on: d + w tau + b tau^2 / 2.
struct PlainPair {
  using Real = long double;
  std::array<Real, 3> d{}, w{}, b{};
  std::array<Real, 3> half{};  ///< of a box, and of a cylinder along z
  Real radius = 0, end = 0;    ///< end: below 0 if not both exist at first
  int axes = 0, round = 0;

  Real place(int axis, Real tau) const {
    const auto j = static_cast<std::size_t>(axis);
    return d[j] + tau * (w[j] + tau * b[j] / 2);
  }
  Real speed(int axis, Real tau) const {
    const auto j = static_cast<std::size_t>(axis);
    return w[j] + tau * b[j];
  }
  Real square(Real tau, int count) const {
    Real sum = 0;
    for (int axis = 0; axis < count; ++axis) sum += place(axis, tau) * place(axis, tau);
    return sum;
  }
  Real slope(Real tau, int count) const {
    Real sum = 0;
    for (int axis = 0; axis < count; ++axis) sum += place(axis, tau) * speed(axis, tau);
    return sum;
  }
  /// The derivative of the slope.
  Real bend(Real tau, int count) const {
    Real sum = 0;
    for (int axis = 0; axis < count; ++axis) {
      const auto j = static_cast<std::size_t>(axis);
      sum += speed(axis, tau) * speed(axis, tau) + place(axis, tau) * b[j];
    }
    return sum;
  }
  /// With sizes larger by so much.
  PlainPair grown(Real by) const {
    PlainPair pair = *this;
    pair.radius += by;
    for (Real& one : pair.half) one += by;
    return pair;
  }
  /// The largest length that a computation of the pair meets.
  Real length() const {
    Real longest = radius;
    const Real last = std::max(end, Real{0});
    for (std::size_t j = 0; j < 3; ++j)
      longest =
          std::max({longest, half[j], std::abs(d[j]) + last * (std::abs(w[j]) + last * std::abs(b[j]) / 2)});
    return longest;
  }
  bool touches(Real tau) const {
    if (square(tau, round) > radius * radius) return false;
    for (int axis = round; axis < axes; ++axis)
      if (std::abs(place(axis, tau)) > half[static_cast<std::size_t>(axis)]) return false;
    return true;
  }

  /// Of two that touch at first: the distance increases while they touch, and then they remain apart.
  bool separates() const {
    const std::vector<Real> events = instants();
    bool left = false;
    if (end <= 0) return true;
    if (slope(0, axes) < 0) return false;
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
      const Real from = events[i], to = events[i + 1], middle = (from + to) / 2;
      if (to - from < 1e-18L) continue;
      const bool touch = touches(middle);
      if (touch && (left || slope(middle, axes) < 0)) return false;
      left = left || !touch;
    }
    return true;
  }

 private:
  /// When touching starts or ends, and when the distance starts to increase or decrease.
  std::vector<Real> instants() const {
    std::vector<Real> all{0, end};
    const auto add_roots = [&](const auto& f, std::vector<Real> between) {
      std::sort(between.begin(), between.end());
      for (std::size_t i = 0; i + 1 < between.size(); ++i) {
        Real low = between[i], high = between[i + 1];
        if ((f(low) > 0) == (f(high) > 0)) continue;
        const bool rises = f(high) > 0;
        for (int cut = 0; cut < 70; ++cut) {
          const Real middle = (low + high) / 2;
          ((f(middle) > 0) == rises ? high : low) = middle;
        }
        all.push_back((low + high) / 2);
      }
    };
    std::vector<Real> grid{0, end};
    for (int i = 1; i < 512; ++i) grid.push_back(end * i / 512);
    for (int i = 1; i < 240; ++i) grid.push_back(end * std::exp2(-static_cast<Real>(i) / 2));
    for (const int count : {axes, round}) {
      if (count == 0) continue;
      std::vector<Real> turns = grid;
      std::swap(turns, all), add_roots([&](Real tau) { return bend(tau, count); }, grid),
          std::swap(turns, all);
      add_roots([&](Real tau) { return slope(tau, count); }, turns);
    }
    for (int axis = 0; axis < axes; ++axis) add_roots([&](Real tau) { return speed(axis, tau); }, grid);
    const std::vector<Real> monotone = all;
    if (round > 0) add_roots([&](Real tau) { return square(tau, round) - radius * radius; }, monotone);
    for (int axis = round; axis < axes; ++axis)
      for (const int side : {-1, 1})
        add_roots([&](Real tau) { return side * place(axis, tau) - half[static_cast<std::size_t>(axis)]; },
                  monotone);
    std::sort(all.begin(), all.end());
    return all;
  }
};

}  // namespace foresee::testing
