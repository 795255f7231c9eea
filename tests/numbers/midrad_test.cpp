// Ball arithmetic of any length: balls contain the exact number and are narrow.
#include "numbers/midrad.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "numbers/polynomial.h"

namespace foresee {
namespace {

class Numbers {
 public:
  /// A few dozen to some hundred bits, now and then 0.
  Dyadic number() {
    Dyadic sum;
    if (random_() % 20 == 0) return sum;
    for (int i = static_cast<int>(random_() % 8); i >= 0; --i)
      sum = sum + Dyadic(std::ldexp(static_cast<double>(static_cast<std::int64_t>(random_())),
                                    static_cast<int>(random_() % 400) - 200));
    return sum;
  }
  int length() { return 64 + static_cast<int>(random_() % 300); }

 private:
  std::mt19937_64 random_{20260101};
};

bool encloses(const Midrad& enclosure, const Dyadic& exact) {
  return enclosure.low() <= exact && exact <= enclosure.high();
}

TEST(Midrad, EnclosesWhatIsExact) {
  Numbers numbers;
  for (int i = 0; i < 2000; ++i) {
    const Dyadic a = numbers.number(), b = numbers.number();
    const int bits = numbers.length();
    const Midrad x(a, bits), y(b, bits);
    EXPECT_TRUE(encloses(x, a));
    EXPECT_TRUE(encloses(x + y, a + b));
    EXPECT_TRUE(encloses(x * y, a * b));
    EXPECT_TRUE(encloses(x * x - y * y + (x + y) * (x * y), a * a - b * b + (a + b) * (a * b)));
    EXPECT_TRUE(encloses(Midrad::hull(std::min(a, b), std::max(a, b), bits), a));
    if (b.sign() != 0) {
      const Midrad quotient = x / y;
      const Dyadic one = quotient.low() * b, other = quotient.high() * b;
      EXPECT_TRUE(std::min(one, other) <= a && a <= std::max(one, other));
    }
    if (a.sign() > 0) {
      const Midrad root = sqrt(x);
      EXPECT_TRUE(root.low() * root.low() <= a && a <= root.high() * root.high());
    }
  }
}

TEST(Midrad, IsAsNarrowAsItIsLong) {
  const int bits = 1000, lost = 10;
  const Midrad third = Midrad(Dyadic(1.0), bits) / Midrad(Dyadic(3.0), bits);
  EXPECT_LT((third.high() - third.low()).magnitude(), lost - bits);
  const Midrad root = sqrt(Midrad(Dyadic(2.0), bits));
  EXPECT_LT((root.high() - root.low()).magnitude(), lost - bits);
  EXPECT_EQ((root * root - Midrad(Dyadic(2.0), bits)).sign(), unknown_sign);
  EXPECT_EQ((Midrad(Dyadic(1e300), 2000) + Midrad(Dyadic(1e-300), 2000) - Midrad(Dyadic(1e300), 2000)).sign(),
            1);
}

/// Of wide intervals: Newton's method has to see a slope's sign early.
TEST(Midrad128, ProductsOfWideIntervalsAreNarrow) {
  const auto is_within = [](const Midrad128& w, double lowest, double highest) {
    return Dyadic(lowest) <= w.low().dyadic() && w.high().dyadic() <= Dyadic(highest);
  };
  const Midrad128 around_zero = Midrad128::hull(Midrad128(), Midrad128(20.0)) - Midrad128(10.0);
  const Midrad128 far = Midrad128::hull(Midrad128(2.0), Midrad128(4.0));
  EXPECT_TRUE(is_within(around_zero * around_zero, -101, 101));
  EXPECT_TRUE(is_within(far * far, 1, 17));
  Numbers numbers;
  for (int i = 0; i < 2000; ++i) {
    const auto size = [&] { return Midrad128(numbers.number() * numbers.number()); };
    const Midrad128 a = size(), b = size(), c = size(), d = size();
    const Midrad128 x = Midrad128::hull(Midrad128(), a * a) - b * b,
                    y = Midrad128::hull(Midrad128(), c * c) - d * d, product = x * y;
    for (const Midrad128& one : {x.low(), x.high()})
      for (const Midrad128& other : {y.low(), y.high()}) {
        const Dyadic corner = one.dyadic() * other.dyadic();
        EXPECT_TRUE(product.low().dyadic() <= corner && corner <= product.high().dyadic());
      }
  }
}

}  // namespace
}  // namespace foresee
