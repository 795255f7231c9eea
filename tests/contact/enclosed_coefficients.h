// Checks that the number types of all stages enclose the exact coefficients of a polynomial.
//
//   expect_enclosed([&]<class T>() { return sample.polynomial<T>(); }, seed);
#pragma once

#include <gtest/gtest.h>

#include "numbers/bounded.h"
#include "numbers/double_double.h"
#include "numbers/midrad_128.h"

namespace foresee::testing {

/// `polynomial_of<T>()`: an array of coefficients. A DoubleDouble has no bound of its own: it is expected
/// 2^44 times as near as the bound of doubles.
template <class PolynomialOf>
void expect_enclosed(const PolynomialOf& polynomial_of, std::uint64_t seed) {
  const auto exact = polynomial_of.template operator()<Dyadic>();
  const auto doubles = polynomial_of.template operator()<Bounded>();
  const auto in_128_bits = polynomial_of.template operator()<Midrad128>();
  const auto pairs = polynomial_of.template operator()<DoubleDouble>();
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const auto distance = [&](const Dyadic& other) {
      const Dyadic gap = other - exact[k];
      return gap.sign() < 0 ? -gap : gap;
    };
    const double error = doubles[k].error_bound(0x1p-1000);
    ASSERT_LE(distance(Dyadic(doubles[k].value)), Dyadic(error)) << seed << " power " << k;
    ASSERT_LE(distance(Dyadic(pairs[k].high) + Dyadic(pairs[k].low)), Dyadic(error).scaled(-44))
        << seed << " power " << k;
    ASSERT_LE(in_128_bits[k].low().dyadic(), exact[k]) << seed << " power " << k;
    ASSERT_LE(exact[k], in_128_bits[k].high().dyadic()) << seed << " power " << k;
  }
}

}  // namespace foresee::testing
