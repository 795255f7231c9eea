// Swept boxes, checked in rational numbers, so that a bound one unit in the last place too small fails.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

#include "sanitized.h"
#include "shape/swept_boxes.h"
#include "stopping_interrupt.h"

namespace foresee {
namespace {

using Rational = boost::multiprecision::cpp_rational;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Object {
  double t, x, v, a, half, until;
  double growth = 0;
};

Bodies bodies_of(const Object& object) {
  static thread_local double row[7];
  const Layout layout{.axes = 1,
                      .law = Law::accelerated,
                      .shape = Shape::box,
                      .has_t = true,
                      .has_until = true,
                      .has_growth = object.growth != 0};
  const Offsets at = row_offsets(layout);
  row[at.t] = object.t, row[at.x] = object.x, row[at.v] = object.v, row[at.a] = object.a;
  row[at.half] = object.half, row[at.until] = object.until;
  if (at.growth != Offsets::absent) row[at.growth] = object.growth;
  return {layout, row, 1};
}

Box<1> sweep(const Object& object, const Horizon& horizon, double margin = 0) {
  return swept_box<1>(bodies_of(object), 0, horizon, Vec<1>::constant(margin));
}

/// Whether the box contains the exact position at time s after the object's t.
bool holds(const Box<1>& box, const Object& object, const Rational& s, double margin) {
  const Rational place = Rational(object.x) + Rational(object.v) * s + Rational(object.a) * s * s / 2;
  const Rational size = Rational(object.half) + Rational(object.growth) * s + Rational(margin);
  const bool low = box.lower[0] == -infinity || Rational(box.lower[0]) <= place - size;
  const bool high = box.upper[0] == infinity || Rational(box.upper[0]) >= place + size;
  return low && high;
}

/// Both ends of the object's life, the turning point, and a few times between.
void expect_outward(const Object& object, const Horizon& horizon, double margin = 0) {
  const Box<1> box = sweep(object, horizon, margin);
  const Rational t(object.t), now(horizon.now);
  Rational begin = std::max(now, t) - t, end = now + Rational(horizon.h) - t;
  if (object.until != infinity) end = std::min(end, Rational(object.until) - t);
  if (begin > end) return;
  std::vector<Rational> instants{begin, end, (begin + end) / 2, (begin * 7 + end) / 8};
  if (object.a != 0)
    for (const double growth : {-object.growth, object.growth})  // where each face turns
      instants.push_back(-(Rational(object.v) + Rational(growth)) / Rational(object.a));
  for (const Rational& s : instants)
    if (begin <= s && s <= end) {
      ASSERT_TRUE(holds(box, object, s, margin))
          << "t " << object.t << " x " << object.x << " v " << object.v << " a " << object.a << " half "
          << object.half << " until " << object.until << " now " << horizon.now << " h " << horizon.h;
    }
}

TEST(SweptBox, HoldsTheTurningPoint) {
  const Box<1> box = sweep({0, 0, 4, -2, 1, infinity}, {0, 4});  // out to 4 and back to 0
  EXPECT_GE(box.upper[0], 5);
  EXPECT_LT(box.upper[0], 5.0000001);
  EXPECT_LE(box.lower[0], -1);
  EXPECT_GT(box.lower[0], -1.0000001);
}

TEST(SweptBox, FollowsEachFaceOfABoxThatGrows) {
  const Box<1> box = sweep({0, 0, 10, 0, 1, infinity, 2}, {1, 9});  // from 10 -+ 3 to 100 -+ 21
  EXPECT_NEAR(box.lower[0], 7, 1e-12);
  EXPECT_NEAR(box.upper[0], 121, 1e-12);
}

TEST(SweptBox, IsTightAtRest) {
  const Box<1> box = sweep({0, 7, 0, 0, 2, infinity}, {100, 50}, 1);
  EXPECT_NEAR(box.lower[0], 4, 1e-14);
  EXPECT_NEAR(box.upper[0], 10, 1e-14);
}

TEST(SweptBox, CoversOnlyTheObjectsLife) {
  const Box<1> late = sweep({5, 0, 1, 0, 0, infinity}, {0, 10});  // exists from 5 on
  EXPECT_NEAR(late.upper[0], 5, 1e-12);
  EXPECT_NEAR(late.lower[0], 0, 1e-12);
  const Box<1> early = sweep({0, 0, 1, 0, 0, 3}, {1, 10});  // ends at 3
  EXPECT_NEAR(early.lower[0], 1, 1e-12);
  EXPECT_NEAR(early.upper[0], 3, 1e-12);
}

TEST(SweptBox, IsEmptyForWhatDoesNotExist) {
  EXPECT_TRUE(sweep({10.5, 0, 1, 0, 0, infinity}, {0, 10}).is_empty());
  EXPECT_TRUE(sweep({-20, 0, 1, 0, 0, -1}, {0, 10}).is_empty());
  EXPECT_FALSE(sweep({10, 0, 1, 0, 0, infinity}, {0, 10}).is_empty());  // exists at the last time
  EXPECT_FALSE(sweep({-20, 0, 1, 0, 0, 0}, {0, 10}).is_empty());        // exists at the first time
  const Box<1> wide{Vec<1>::constant(-1e308), Vec<1>::constant(1e308)};
  EXPECT_FALSE(wide.meets(Box<1>::empty()));
}

TEST(SweptBox, OverflowAndNanAreUnbounded) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Object wild[] = {{0, 0, 1e308, 0, 0, infinity},         {0, 1e308, 1e308, 1e308, 0, infinity},
                         {0, 1.7e308, 0, 0, 1.7e308, infinity}, {-1.7e308, 1, 1, 1, 0, infinity},
                         {0, nan, 1, 0, 0, infinity},           {0, 1, nan, 0, 0, infinity},
                         {0, 1, 1, nan, 0, infinity},           {0, 1, 1, 1, nan, infinity},
                         {nan, 1, 1, 1, 1, infinity},           {0, 1.7e308, 1.7e308, 1.7e308, 0, infinity}};
  for (const Object& object : wild) {
    const Box<1> box = sweep(object, {1e300, 1e9});
    EXPECT_EQ(box.upper[0], infinity);
    EXPECT_TRUE(box.lower[0] == -infinity ||
                Rational(box.lower[0]) <= Rational(object.x) - Rational(object.half));
    EXPECT_FALSE(box.is_empty());
  }
}

/// Doubles of all magnitudes between 2^low and 2^high, both signs, now and then zero.
struct AnyDouble {
  std::mt19937_64& random;
  int low, high;
  double operator()() {
    if (random() % 16 == 0) return 0;
    const double mantissa = 1 + static_cast<double>(random() >> 12) * 0x1p-52;
    const int span = high - low;
    const double value = std::ldexp(mantissa, low + static_cast<int>(random() % (span + 1)));
    return random() % 2 ? value : -value;
  }
};

/// Rational numbers of so many digits are slow, and slower still under sanitizers.
constexpr int share = testing::sanitized ? 10 : 1;

void fuzz(std::uint64_t seed, int low, int high, int rounds) {
  std::mt19937_64 random(seed);
  AnyDouble any{random, low, high};
  for (int i = 0; i < rounds / share; ++i) {
    const double t = any();
    const double until = random() % 3 ? infinity : t + std::abs(any());
    const double growth = random() % 2 ? std::abs(any()) : 0;
    expect_outward({t, any(), any(), any(), std::abs(any()), until, growth}, {any(), std::abs(any())},
                   std::abs(any()));
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(SweptBox, IsOutwardInOrdinaryScenes) {
  fuzz(1, -10, 10, 4000);
}
TEST(SweptBox, IsOutwardOverManyMagnitudes) {
  fuzz(2, -80, 80, 3000);
}
TEST(SweptBox, IsOutwardAmongDenormals) {
  fuzz(3, -1074, -1015, 3000);
}
TEST(SweptBox, IsOutwardNearUnderflowOfProducts) {
  fuzz(4, -560, -500, 3000);
}
TEST(SweptBox, IsOutwardNearOverflow) {
  fuzz(5, 480, 1023, 1500);
}

TEST(SweptBox, IsOutwardFarFromTheOrigin) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 4000 / share; ++i) {
    const double now = 1.7e9 + unit(random);
    expect_outward({now - 60 * std::abs(unit(random)), 1e15 + unit(random) * 100, unit(random) * 1e3,
                    unit(random), std::abs(unit(random)) * 1e-3, infinity},
                   {now, std::abs(unit(random)) * 600}, std::abs(unit(random)));
    if (HasFatalFailure()) return;
  }
}

TEST(SweptBoxes, AnswerInRowOrderAndCanBeInterrupted) {
  const double rows[] = {0, 0, 1, 1, 10, 10, 1, 1, -5, -5, 1, 1};
  const Bodies bodies(Layout{.axes = 2, .law = Law::uniform}, rows, 3);
  NeverInterrupt never;
  const auto boxes = swept_boxes<2>(bodies, {0, 1}, Vec<2>::zero(), never);
  ASSERT_EQ(boxes.size(), 3u);
  EXPECT_NEAR(boxes[1].upper[1], 11, 1e-12);
  EXPECT_NEAR(boxes[2].lower[0], -5, 1e-12);
  testing::StopAt stop(0);
  EXPECT_THROW(swept_boxes<2>(bodies, {0, 1}, Vec<2>::zero(), stop), Interrupted);
}

}  // namespace
}  // namespace foresee
