// Double-double arithmetic: numbers of twice a double's precision, the unevaluated sum high + low.
//
//   DoubleDouble gap = difference(1e15, 1e-3);         // exact: both numbers are still there
//   gap = gap * gap;                                   // within a few 2^-106 of the exact square
//
// Products are Dekker's instead of a fused multiply-add, so that every processor gives the same bits. Each
// operation has a relative error below 2^-102 unless it under- or overflows; overflow gives NaN.
#pragma once

namespace foresee {

constexpr double unit_roundoff = 0x1p-53;

struct DoubleDouble {
  double high = 0;
  double low = 0;
};

/// a + b exactly (Knuth).
[[gnu::always_inline]] inline DoubleDouble sum(double a, double b) {
  const double s = a + b;
  const double b_part = s - a;
  return {s, (a - (s - b_part)) + (b - b_part)};
}

/// a - b exactly.
[[gnu::always_inline]] inline DoubleDouble difference(double a, double b) {
  return sum(a, -b);
}

/// a + b exactly. Requires: |a| >= |b| or a == 0.
[[gnu::always_inline]] inline DoubleDouble ordered_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// a * b exactly, unless it under- or overflows (Dekker).
[[gnu::always_inline]] inline DoubleDouble product(double a, double b) {
  constexpr double splitter = 134217729;  // 2^27 + 1
  const double p = a * b;
  const double ca = splitter * a, cb = splitter * b;
  const double a_high = ca - (ca - a), b_high = cb - (cb - b);
  const double a_low = a - a_high, b_low = b - b_high;
  return {p, ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

[[gnu::always_inline]] inline DoubleDouble operator-(DoubleDouble a) {
  return {-a.high, -a.low};
}

[[gnu::always_inline]] inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = sum(a.high, b.high), low = sum(a.low, b.low);
  const DoubleDouble middle = ordered_sum(high.high, high.low + low.high);
  return ordered_sum(middle.high, low.low + middle.low);
}

[[gnu::always_inline]] inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
  return a + -b;
}

[[gnu::always_inline]] inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble p = product(a.high, b.high);
  return ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// Exact unless it underflows.
[[gnu::always_inline]] inline DoubleDouble half_of(DoubleDouble a) {
  return {a.high * 0.5, a.low * 0.5};
}

[[gnu::always_inline]] inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - DoubleDouble{first, 0} * b;
  const double second = rest.high / b.high;
  const DoubleDouble more = rest - DoubleDouble{second, 0} * b;
  return ordered_sum(first, second) + DoubleDouble{more.high / b.high, 0};
}

}  // namespace foresee
