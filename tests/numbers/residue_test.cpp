// Numbers modulo 2^61 - 1: sums and products agree with the exact ones, whatever the exponent and the sign.
#include "numbers/residue.h"

#include <gtest/gtest.h>

#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

const Whole prime = (Whole(1) << 61) - 1;

/// m 2^e modulo the prime, where 2^61 is 1.
std::int64_t residue_by_division(const Dyadic& number) {
  Whole rest = Whole(number.mantissa()) * (Whole(1) << ((number.exponent() % 61 + 61) % 61)) % prime;
  if (rest < 0) rest += prime;
  return static_cast<std::int64_t>(rest);
}

bool congruent(const Residue& a, const Residue& b) {
  return (a - b).is_zero() && (b - a).is_zero();
}

TEST(Residue, IsWhatDivisionLeaves) {
  Inputs inputs(1);
  for (int i = 0; i < cases(2000); ++i) {
    const Dyadic number = inputs.dyadic(-1000, 1000);
    const std::int64_t rest = residue_by_division(number);
    EXPECT_TRUE(congruent(Residue(number), Residue(Dyadic(Integer(rest), 0))));
    EXPECT_EQ(Residue(number).is_zero(), rest == 0);
    EXPECT_FALSE(congruent(Residue(number), Residue(Dyadic(Integer(rest), 0) + Dyadic(1.0))));
  }
}

TEST(Residue, AgreesWithExactArithmetic) {
  Inputs inputs(2);
  for (int i = 0; i < cases(2000); ++i) {
    const Dyadic a = inputs.dyadic(-500, 500), b = inputs.dyadic(-500, 500);
    EXPECT_TRUE(congruent(Residue(a) - Residue(b), Residue(a - b)));
    EXPECT_TRUE(congruent(Residue(a) * Residue(b), Residue(a * b)));
    EXPECT_TRUE(congruent(Residue() - Residue(a), Residue(-a)));
    EXPECT_TRUE(congruent(Residue(a.reduced()), Residue(a)));
  }
}

/// At the ends of the range, where a carry may be lost.
TEST(Residue, MultiplesOfThePrimeAreZero) {
  const Integer p = (Integer(1) << 61) - 1;
  for (const int exponent : {-1000, -61, -60, -1, 0, 1, 60, 61, 122, 1000})
    for (const Integer& factor : {Integer(0), Integer(1), Integer(-1), Integer(2), p, Integer(p * p - 1)}) {
      EXPECT_TRUE(Residue(Dyadic(Integer(factor * p), exponent)).is_zero());
      EXPECT_FALSE(Residue(Dyadic(Integer(factor * p + 1), exponent)).is_zero());
      EXPECT_FALSE(Residue(Dyadic(Integer(factor * p - 1), exponent)).is_zero());
    }
  const Residue largest(Dyadic(Integer(p - 1), 0)), one(Dyadic(1.0));
  EXPECT_TRUE(congruent(largest * largest, one));
  EXPECT_TRUE(congruent(Residue() - one, largest));
}

}  // namespace
}  // namespace foresee
