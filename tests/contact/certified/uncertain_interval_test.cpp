// Uncertain intervals against the signs of polynomials at single times: what is certain holds, and what is
// not possible does not.
#include "contact/certified/uncertain_interval.h"

#include <gtest/gtest.h>

#include <random>

#include "numbers/dyadic.h"

namespace foresee {
namespace {

constexpr double length = 8, lost = 0x1p-988;

template <std::size_t N>
int sign_at(const std::array<double, N>& p, double s) {
  Dyadic value;
  for (std::size_t k = N; k-- > 0;) value = value * Dyadic(s) + Dyadic(p[k]);
  return value.sign();
}

template <std::size_t N>
void expect_right(const std::array<double, N>& p, const SublevelIntervals& inside) {
  for (int i = 0; i <= 64; ++i) {
    const double s = length * i / 64;
    bool possible = false, certain = false;
    for (int j = 0; j < inside.count; ++j) {
      const UncertainInterval& interval = inside.list[static_cast<std::size_t>(j)];
      possible |= interval.begin.low <= s && s <= interval.end.high;
      certain |= interval.begin.high <= s && s <= interval.end.low;
    }
    const bool holds = sign_at(p, s) <= 0;
    ASSERT_TRUE(possible || !holds) << "at " << s;
    ASSERT_TRUE(holds || !certain) << "at " << s;
  }
}

/// Coefficients that are half integers, so that roots are double, at the times tested, or do not exist; or
/// any.
template <std::size_t N, class Check>
void for_each_polynomial(Check&& check) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 3000; ++i) {
    std::array<double, N> p;
    std::array<Bounded, N> bounded;
    for (std::size_t k = 0; k < N; ++k) {
      const double any = std::uniform_real_distribution<double>(-4, 4)(random);
      p[k] = i % 2 ? any : std::round(any) / 2;
      bounded[k] = {p[k], i % 3 ? 0x1p-50 * std::abs(p[k]) : 0};
    }
    ASSERT_NO_FATAL_FAILURE(check(p, bounded)) << i;
  }
}

TEST(IntervalUnion, OfALineHoldWhereItsSignSays) {
  for_each_polynomial<2>(
      [](const auto& p, const auto& bounded) { expect_right(p, sublevel_intervals(bounded, lost, length)); });
}

TEST(IntervalUnion, OfAParabolaHoldWhereItsSignSays) {
  for_each_polynomial<3>(
      [](const auto& p, const auto& bounded) { expect_right(p, sublevel_intervals(bounded, lost, length)); });
}

TEST(IntervalUnion, OfAParabolaInDoubtReachAsFarAsItBends) {
  // 2^-301 - 2^900 s^2 is below 0 at 2^-600, whose square is no double.
  const SublevelIntervals inside =
      sublevel_intervals(Coefficients<Bounded, 2>{{{0x1p-301, 0}, {}, {0, 0x1p900}}}, lost, 0x1p-600);
  ASSERT_EQ(inside.count, 1);
  EXPECT_TRUE(inside.list[0].is_possible());
  EXPECT_FALSE(inside.list[0].is_certain());
}

TEST(IntervalUnion, FoundInLeapsHoldWhereTheSignSays) {
  for_each_polynomial<5>([](auto p, const auto& /*bounded*/) {
    p[4] = std::abs(p[4]);  // as squares have it
    const auto seen_from = [&p](double tau) {
      Coefficients<Bounded, 4> seen;
      for (std::size_t k = 0; k < 5; ++k) seen[k] = {p[k], 0};
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t i = 4; i-- > k;) seen[i] = seen[i] + Bounded{tau, 0} * seen[i + 1];
      return seen;
    };
    expect_right(p, sublevel_by_steps(seen_from, lost, {{0, 0}, {length, length}}));
  });
}

TEST(IntervalUnion, WhatIsKeptIsInBoth) {
  IntervalUnion intervals;
  intervals.start({{0, 0}, {8, 8}});
  intervals.keep({{UncertainInterval{{-unbounded, -unbounded}, {3, 4}},
                   UncertainInterval{{5, 6}, {unbounded, unbounded}}},
                  2});
  ASSERT_EQ(intervals.end() - intervals.begin(), 2);
  intervals.keep(SublevelIntervals::one({{3.5, 3.75}, {unbounded, unbounded}}));
  EXPECT_FALSE(intervals.begin()->is_certain());  // it may end before it starts
  EXPECT_TRUE((intervals.begin() + 1)->is_certain());
  intervals.keep(SublevelIntervals::one({{4.5, 4.5}, {5.5, 5.5}}));
  ASSERT_EQ(intervals.end() - intervals.begin(), 1);
  EXPECT_EQ(intervals.begin()->begin.low, 5);
  intervals.keep(SublevelIntervals::never());
  EXPECT_TRUE(intervals.empty());
}

}  // namespace
}  // namespace foresee
