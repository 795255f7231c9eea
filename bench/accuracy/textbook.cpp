#include <algorithm>
#include <cmath>

#include "accuracy/methods.h"

namespace foresee::bench {
namespace {

/// Plain arithmetic of T, and the careful one with fused multiply-add.
template <class T>
struct Plain {
  using Number = T;
  static T multiply_add(T a, T b, T c) { return a * b + c; }
  static T discriminant(T a, T b, T c) { return b * b - 4 * a * c; }
  static void roots(T a, T b, T, T root, T& one, T& other) {
    one = (-b - root) / (2 * a), other = (-b + root) / (2 * a);
  }
};
struct Fused {
  using Number = double;
  static double multiply_add(double a, double b, double c) { return std::fma(a, b, c); }
  /// Kahan: b^2 - 4 a c within two units in the last place.
  static double discriminant(double a, double b, double c) {
    const double product = 4 * a * c, error = std::fma(-4 * a, c, product);
    return std::fma(b, b, -product) + error;
  }
  static void roots(double a, double b, double c, double root, double& one, double& other) {
    const double q = -0.5 * (b + std::copysign(root, b));
    one = q / a, other = c / q;
  }
};

/// Times as disjoint spans in order.
template <class T>
struct Spans {
  struct Span {
    T begin, end;
  };
  Span span[8];
  int count = 0;

  void add(T begin, T end) {
    if (begin <= end && count < 8) span[count++] = {begin, end};
  }
  Spans met_with(const Spans& other) const {
    Spans met;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < other.count; ++j)
        met.add(std::max(span[i].begin, other.span[j].begin), std::min(span[i].end, other.span[j].end));
    return met;
  }
};

/// The times in [0, h] at which a t^2 + b t + c <= 0.
template <class Arithmetic, class T = typename Arithmetic::Number>
Spans<T> not_positive(T a, T b, T c, T h) {
  Spans<T> spans;
  auto add = [&](T begin, T end) { spans.add(std::max(begin, T(0)), std::min(end, h)); };
  if (a == 0) {
    if (b == 0) {
      if (c <= 0) add(0, h);
    } else {
      b > 0 ? add(0, -c / b) : add(-c / b, h);
    }
    return spans;
  }
  const T d = Arithmetic::discriminant(a, b, c);
  if (d < 0) {
    if (a < 0) add(0, h);
    return spans;
  }
  T one, other;
  Arithmetic::roots(a, b, c, std::sqrt(d), one, other);
  const T low = std::min(one, other), high = std::max(one, other);
  if (a > 0) {
    add(low, high);
  } else {
    add(0, low);
    add(high, h);
  }
  return spans;
}

template <class Arithmetic>
Answer boxes(const Seen<typename Arithmetic::Number>& pair, double horizon) {
  using T = typename Arithmetic::Number;
  const T h = static_cast<T>(horizon);
  Spans<T> spans;
  spans.add(0, h);
  for (int j = 0; j < 3; ++j) {
    const T a = T(0.5) * pair.a[j], v = pair.v[j], x = pair.x[j], half = pair.half[j];
    spans = spans.met_with(not_positive<Arithmetic>(a, v, x - half, h));
    spans = spans.met_with(not_positive<Arithmetic>(-a, -v, -x - half, h));
  }
  if (spans.count == 0) return {};
  T first = h;
  for (int i = 0; i < spans.count; ++i) first = std::min(first, spans.span[i].begin);
  return {true, static_cast<double>(first)};
}

template <class Arithmetic, class T = typename Arithmetic::Number>
T value(const T* c, int degree, T t) {
  T sum = c[degree];
  for (int k = degree - 1; k >= 0; --k) sum = Arithmetic::multiply_add(sum, t, c[k]);
  return sum;
}

/// A change of sign between low and high, to the last bit.
template <class Arithmetic, class T = typename Arithmetic::Number>
T crossing(const T* c, int degree, T low, T high) {
  const bool below = value<Arithmetic>(c, degree, low) <= 0;
  for (int step = 0; step < 200; ++step) {
    const T middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) break;
    ((value<Arithmetic>(c, degree, middle) <= 0) == below ? low : high) = middle;
  }
  return high;
}

/// The sign changes in (0, h), each between sign changes of the derivative.
template <class Arithmetic, class T = typename Arithmetic::Number>
int sign_changes(const T* c, int degree, T h, T* places) {
  if (degree < 1) return 0;
  T slope[4], turns[6];
  for (int k = 0; k < degree; ++k) slope[k] = c[k + 1] * static_cast<T>(k + 1);
  turns[0] = 0;
  int pieces = 1 + sign_changes<Arithmetic>(slope, degree - 1, h, turns + 1), found = 0;
  turns[pieces] = h;
  for (int i = 0; i < pieces; ++i) {
    const bool left = value<Arithmetic>(c, degree, turns[i]) <= 0;
    const bool right = value<Arithmetic>(c, degree, turns[i + 1]) <= 0;
    if (left != right) places[found++] = crossing<Arithmetic>(c, degree, turns[i], turns[i + 1]);
  }
  return found;
}

template <class Arithmetic>
Answer balls(const Seen<typename Arithmetic::Number>& pair, double horizon) {
  using T = typename Arithmetic::Number;
  const T h = static_cast<T>(horizon);
  const Quartic<T> f(pair);
  if (f.c[0] <= 0) return {true, 0};
  T slope[4], turns[6];
  for (int k = 0; k < 4; ++k) slope[k] = f.c[k + 1] * static_cast<T>(k + 1);
  turns[0] = 0;
  const int pieces = 1 + sign_changes<Arithmetic>(slope, 3, h, turns + 1);
  turns[pieces] = h;
  for (int i = 0; i < pieces; ++i)
    if (value<Arithmetic>(f.c, 4, turns[i + 1]) <= 0)
      return {true, static_cast<double>(crossing<Arithmetic>(f.c, 4, turns[i], turns[i + 1]))};
  return {};
}

template <class Arithmetic>
Method textbook(const Family& family, const char* name) {
  return one_by_one(name, "", [&family](std::size_t i) {
    const Seen<typename Arithmetic::Number> pair(family, i);
    return family.balls() ? balls<Arithmetic>(pair, family.horizon.h)
                          : boxes<Arithmetic>(pair, family.horizon.h);
  });
}

}  // namespace

Method textbook_float(const Family& family) {
  return textbook<Plain<float>>(family, "float");
}
Method textbook_double(const Family& family) {
  return textbook<Plain<double>>(family, "double");
}
Method textbook_fma(const Family& family) {
  return textbook<Fused>(family, "double-fma");
}

}  // namespace foresee::bench
