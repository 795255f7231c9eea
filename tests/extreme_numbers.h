// Seeded scenes of a few objects whose numbers come from the whole range of doubles, the same everywhere.
//
//   RandomScene scene = extreme_scene(7);                // query with scene.now, scene.h, scene.within
//
// Each scene has a scale of length and one of time, from the smallest double to the largest. Most of its
// numbers are of these scales, so that objects meet; the others are 0, the ends of the range, or anything.
// Every second scene has speeds near 1e308 in both directions and times so short that they matter.
#pragma once

#include <algorithm>

#include "scenes.h"

namespace foresee::testing {

class ExtremeNumbers {
 public:
  explicit ExtremeNumbers(std::uint64_t seed) : random_(Random(seed).next()) {
    if (seed % 2 == 0) {
      length_ = power(-320, 308), time_ = power(-322, 308);
      speed_ = in_range(length_ / time_);
    } else {
      time_ = power(-322, -290), speed_ = power(290, 308.2);
      length_ = in_range(speed_ * time_);
    }
    acceleration_ = in_range(speed_ / time_);
  }

  Random& random() { return random_; }
  bool one_in(std::uint64_t times) { return random_.below(times) == 0; }

  double length() { return number(length_); }
  double time() { return number(time_); }
  double speed() { return number(speed_); }
  double acceleration() { return one_in(2) ? 0 : number(acceleration_); }

  static double in_range(double x) { return std::clamp(x, -largest, largest); }

 private:
  static constexpr double largest = std::numeric_limits<double>::max();

  double power(double min, double max) {
    return std::clamp(std::pow(10, random_.in(min, max)), 5e-324, largest);
  }
  double number(double scale) {
    constexpr double anything[] = {5e-324, 1e-310, 1e-160, 1e-20, 1, 1e100, 1e200, 1e300, 1e308, largest};
    const double sign = one_in(2) ? 1 : -1;
    switch (random_.below(8)) {
      case 0:
        return 0;
      case 1:
        return sign * scale;
      case 2:
        return in_range(sign * scale * power(-20, 20));
      case 3:
        return sign * anything[random_.below(std::size(anything))];
      default:
        return in_range(scale * random_.in(-2, 2));
    }
  }

  Random random_;
  double length_, time_, speed_, acceleration_;
};

inline std::vector<double> extreme_record(const Layout& layout, double now, ExtremeNumbers& numbers) {
  const Offsets at = record_offsets(layout);
  std::vector<double> record(static_cast<std::size_t>(at.size));
  const auto place = [&](int offset, int axis = 0) -> double& {
    return record[static_cast<std::size_t>(offset + axis)];
  };
  const double t = at.t == Offsets::absent ? 0 : numbers.one_in(4) ? now : numbers.time();
  if (at.t != Offsets::absent) place(at.t) = t;
  for (int axis = 0; axis < layout.axes; ++axis) {
    place(at.x, axis) = numbers.length();
    if (at.a != Offsets::absent) place(at.a, axis) = numbers.acceleration();
    if (at.half != Offsets::absent) place(at.half, axis) = std::abs(numbers.length());
    if (at.v == Offsets::absent) continue;
    const double v = place(at.v, axis) = numbers.speed();
    // Half of the objects are near the origin at `now`.
    if (numbers.one_in(2)) place(at.x, axis) = ExtremeNumbers::in_range(numbers.length() - v * (now - t));
    if (std::isnan(place(at.x, axis))) place(at.x, axis) = 0;
  }
  if (at.r != Offsets::absent) place(at.r) = std::abs(numbers.length());
  if (at.hz != Offsets::absent) place(at.hz) = std::abs(numbers.length());
  if (at.growth != Offsets::absent) place(at.growth) = std::abs(numbers.speed());
  if (at.growth_z != Offsets::absent) place(at.growth_z) = std::abs(numbers.speed());
  if (at.until != Offsets::absent)
    place(at.until) = numbers.one_in(2) ? std::numeric_limits<double>::infinity()
                                        : ExtremeNumbers::in_range(t + std::abs(numbers.time()));
  return record;
}

/// Of any layout except those with forces, which become accelerated motion when they are read.
inline Layout extreme_layout(ExtremeNumbers& numbers) {
  const std::vector<Layout> all = all_layouts();
  for (;;) {
    const Layout layout = all[numbers.random().below(all.size())];
    if (layout.law != Law::forced && (layout.law != Law::rest || numbers.one_in(3))) return layout;
  }
}

inline RandomScene extreme_scene(std::uint64_t seed) {
  ExtremeNumbers numbers(seed);
  RandomScene scene;
  scene.layout = extreme_layout(numbers);
  scene.now = numbers.one_in(2) ? 0 : numbers.time();
  scene.h = std::abs(numbers.time());
  scene.within = numbers.one_in(2) ? 0 : std::abs(numbers.length());
  const std::uint64_t count = 2 + numbers.random().below(numbers.one_in(4) ? 10 : 4);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::vector<double> record = extreme_record(scene.layout, scene.now, numbers);
    std::vector<double> row(static_cast<std::size_t>(row_offsets(scene.layout).size));
    row_from_record(scene.layout, record.data(), row.data());
    scene.ids.push_back(static_cast<std::int64_t>(i) + 1);
    scene.records.insert(scene.records.end(), record.begin(), record.end());
    scene.rows.insert(scene.rows.end(), row.begin(), row.end());
  }
  return scene;
}

}  // namespace foresee::testing
