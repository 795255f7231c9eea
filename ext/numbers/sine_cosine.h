// Rigorous sine and cosine of an angle in degrees, as balls that contain them: the same on every machine.
//
//   const SineCosine<Midrad128> quick = sine_cosine(37.5);            // less than 2^-107 wide, relatively
//   const SineCosine<Midrad> close = sine_cosine(37.5, 512);          // less than 2^-470 wide
//
// Taylor's series, nested from its end: 1 - x^2/6 (1 - x^2/20 (1 - ...)). The innermost parenthesis is known
// to lie in [1/2, 1], and each one around it narrows this, so that the final ball includes the truncation
// error. No constant is taken on trust: pi is computed once by Machin's formula.
#pragma once

#include "numbers/midrad.h"
#include "numbers/midrad_128.h"

namespace foresee {

template <class T>
struct SineCosine {
  T sine, cosine;
};

/// Requires: |degrees| <= 45. Cost: less than a microsecond.
SineCosine<Midrad128> sine_cosine(double degrees);

/// Sine and cosine in `bits` bits. Cost: tens of microseconds for 512.
SineCosine<Midrad> sine_cosine(double degrees, int bits);

}  // namespace foresee
