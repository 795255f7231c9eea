// The check of a law of contact (contact/contact.h): each case of the families of hard_pairs.h, for every
// pair of shapes, is compared with a changed case.
//
//   check_law([](Case& c) { return std::swap(c.a, c.b), true; }, unchanged);         // Law 1
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "contact/case_count.h"
#include "contact/hard_pairs.h"

namespace foresee::testing_by_hand {

/// All answers of contact about a pair.
struct Said {
  std::optional<ContactTimes> times;
  std::optional<ClosestApproach> approach;  ///< if both exist at some time
};

inline Said said_of(const Case& c) {
  const oracle::QueriedInterval queried = oracle::queried_interval(c.a, c.b, c.question.horizon);
  Said said{contact(c.a, c.b, c.question), {}};
  if (queried.begin <= queried.end) said.approach = closest(c.a, c.b, c.question);
  return said;
}

/// What scaling makes subnormal, or 0, lacks bits that the other number has.
inline void expect_scaled(double other, double factor, double right, const Case& c) {
  constexpr double smallest = 0x1p-1022;
  const auto is_full = [](double number) { return std::abs(number) >= smallest; };
  if (factor == 1 || (is_full(other) && is_full(right) && is_full(factor * right))) {
    EXPECT_EQ(other, factor * right) << c;
  } else {
    EXPECT_LE(std::abs(other - factor * right), std::max(1.0, factor) * smallest) << c;
  }
}

inline void expect_same(const Said& right, const Said& other, double time, double length, const Case& c) {
  ASSERT_EQ(right.times.has_value(), other.times.has_value()) << c;
  if (right.times) {
    expect_scaled(other.times->t, time, right.times->t, c);
    expect_scaled(other.times->dt, time, right.times->dt, c);
    expect_scaled(other.times->t_end, time, right.times->t_end, c);
    expect_scaled(other.times->dt_end, time, right.times->dt_end, c);
  }
  ASSERT_EQ(right.approach.has_value(), other.approach.has_value()) << c;
  if (right.approach) {
    expect_scaled(other.approach->t, time, right.approach->t, c);
    expect_scaled(other.approach->dt, time, right.approach->dt, c);
    expect_scaled(other.approach->d, length, right.approach->d, c);
  }
}

/// Every pair of shapes, on every number of axes that it supports.
using Scenery = std::pair<Shapes, int>;

inline std::vector<Scenery> all_sceneries() {
  std::vector<Scenery> all;
  for (const Shapes shapes : {Shapes::boxes, Shapes::balls, Shapes::box_and_ball})
    for (const int axes : {1, 2, 3}) all.push_back({shapes, axes});
  for (const Shapes shapes : {Shapes::points_within, Shapes::box_and_point_within})
    for (const int axes : {2, 3}) all.push_back({shapes, axes});
  all.insert(all.end(), {{Shapes::cylinders, 3}, {Shapes::cylinder_and_box, 3}});
  return all;
}

/// `change` makes another case with the same answers, except that times are scaled by `time` and lengths by
/// `length`. It returns false if the numbers of that case would not be exact.
using Change = std::function<bool(Case&)>;
using Compare = std::function<void(const Case& c, const Case& changed)>;

inline void check_law(const Change& change, const Compare& compare) {
  std::uint64_t seed = 70000;
  int applied = 0;
  const auto check_scene = [&](const Family& family, const Scenery& scenery, int cases) {
    Generator generate(family, seed++);
    for (int i = 0; i < scaled_count(cases); ++i) {
      const Case c = make_case(generate, family, scenery.first, scenery.second);
      Case changed = c;
      if (!change(changed)) continue;
      ++applied;
      compare(c, changed);
      if (::testing::Test::HasFailure()) return;
    }
  };
  for (const Scenery& scenery : all_sceneries()) {
    for (const Family& family : ordinary_families()) check_scene(family, scenery, 10);
    for (const Family& family : growing_families()) check_scene(family, scenery, 3);
  }
  EXPECT_GT(applied, sanitized ? 5 : 100);
}

inline Compare scaled_by(double time, double length) {
  return [time, length](const Case& c, const Case& changed) {
    expect_same(said_of(c), said_of(changed), time, length, c);
  };
}
inline const Compare unchanged = scaled_by(1, 1);

/// number * scale, if that is exact.
inline bool multiply(double& number, double scale) {
  const double before = number;
  number *= scale;
  return number / scale == before;
}

template <std::size_t N>
bool multiply(double (&numbers)[N], double scale) {
  bool exact = true;
  for (double& number : numbers) exact = multiply(number, scale) && exact;
  return exact;
}

inline double speed_of(const Object& o, int axis) {
  return o.layout.law == Law::rest ? 0 : o.v[axis];
}
inline double turn_of(const Object& o, int axis) {
  return o.layout.law < Law::accelerated ? 0 : o.a[axis];
}

/// Describes the same motion with a reference time that is later by `s`; false if its numbers are not exact.
inline bool move_reference_time(Object& o, double s) {
  using oracle::Exact;
  bool exact = true;
  for (int j = 0; j < o.layout.axes; ++j) {
    const double x = o.x[j], v = speed_of(o, j), a = turn_of(o, j);
    o.v[j] = v + s * a, o.x[j] = x + s * v + s * s * a / 2;
    exact = exact && Exact(o.v[j]) == Exact(v) + Exact(s) * Exact(a) &&
            Exact(o.x[j]) == Exact(x) + Exact(s) * Exact(v) + oracle::half(Exact(s) * Exact(s) * Exact(a));
  }
  return exact;
}

}  // namespace foresee::testing_by_hand
