// Vectors of one to three axes, with element-wise arithmetic: places, velocities and half-widths of boxes.
//
//     const Vec<2> a(0, 0), b(3, 4), half(1, 1);
//     const Vec<2> gap = (a - b).abs() - 2 * half;                     // 1, 2
//     const double apart = (gap > 0).any() ? gap.max(0).length() : 0;  // the root of 5
//
// Guarantee: every operation is the scalar one on each axis, rounded once. min, max and largest keep the first
// operand where the numbers do not compare, as std::min and std::max do. Cost: that of the scalars, or of half as many
// on two axes, whose numbers share a register; nothing is allocated.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>

namespace foresee {

/// How the numbers of D axes are kept. Two are kept as a vector of the compiler: GCC 12 packs two doubles of an array
/// in few functions only.
template <int D>
struct AxisNumbers {
  using Type = double[D];
};
template <>
struct AxisNumbers<2> {
  typedef double Type __attribute__((vector_size(16)));
  typedef std::int64_t Bits __attribute__((vector_size(16)));
};

template <int D>
class Vec;

/// What a comparison of vectors says of each axis.
template <int D>
class VecMask {
 public:
  bool& operator[](std::integral auto axis) { return of_axis_[axis]; }
  bool operator[](std::integral auto axis) const { return of_axis_[axis]; }

  bool all() const {
    bool all = true;
    for (int j = 0; j < D; ++j) all = all && of_axis_[j];
    return all;
  }
  bool any() const { return !(!*this).all(); }

  /// Of each axis the number of `yes` where this is true, of `no` elsewhere.
  Vec<D> select(const Vec<D>& yes, const Vec<D>& no) const {
    Vec<D> chosen;
    for (int j = 0; j < D; ++j) chosen[j] = of_axis_[j] ? yes[j] : no[j];
    return chosen;
  }
  Vec<D> select(const Vec<D>& yes, double no) const { return select(yes, Vec<D>::constant(no)); }

  friend VecMask operator!(VecMask a) {
    for (int j = 0; j < D; ++j) a[j] = !a[j];
    return a;
  }
  friend VecMask operator&&(VecMask a, const VecMask& b) {
    for (int j = 0; j < D; ++j) a[j] = a[j] && b[j];
    return a;
  }
  friend VecMask operator||(VecMask a, const VecMask& b) {
    for (int j = 0; j < D; ++j) a[j] = a[j] || b[j];
    return a;
  }

 private:
  bool of_axis_[D];
};

/// A number of each axis, in the scene's own unit.
template <int D>
class Vec {
 public:
  Vec() = default;  ///< leaves the numbers unset
  template <std::convertible_to<double>... Number>
  explicit(D == 1) Vec(Number... of_axis) : of_axis_{static_cast<double>(of_axis)...} {
    static_assert(sizeof...(Number) == D);
  }

  static Vec constant(double number) {
    Vec vec;
    for (int j = 0; j < D; ++j) vec.of_axis_[j] = number;
    return vec;
  }
  static Vec zero() { return constant(0); }

  /// The D numbers from here on, which need not be aligned.
  static Vec at(const double* numbers) {
    Vec vec;
    for (int j = 0; j < D; ++j) vec.of_axis_[j] = numbers[j];
    return vec;
  }

  double& operator[](std::integral auto axis) { return begin()[axis]; }
  double operator[](std::integral auto axis) const { return of_axis_[axis]; }
  template <int Axes>
  Vec<Axes> first() const {
    static_assert(Axes <= D);
    return Vec<Axes>::at(data());
  }
  static constexpr int size() { return D; }
  const double* data() const { return reinterpret_cast<const double*>(&of_axis_); }
  double* begin() { return reinterpret_cast<double*>(&of_axis_); }
  double* end() { return begin() + D; }
  const double* begin() const { return data(); }
  const double* end() const { return data() + D; }

  friend Vec operator+(const Vec& a, const Vec& b) {
    return each(a, b, [](auto x, auto y) { return x + y; });
  }
  friend Vec operator-(const Vec& a, const Vec& b) {
    return each(a, b, [](auto x, auto y) { return x - y; });
  }
  friend Vec operator*(const Vec& a, const Vec& b) {
    return each(a, b, [](auto x, auto y) { return x * y; });
  }
  friend Vec operator/(const Vec& a, const Vec& b) {
    return each(a, b, [](auto x, auto y) { return x / y; });
  }
  friend Vec operator+(const Vec& a, double b) { return a + constant(b); }
  friend Vec operator-(const Vec& a, double b) { return a - constant(b); }
  friend Vec operator*(const Vec& a, double b) { return a * constant(b); }
  friend Vec operator/(const Vec& a, double b) { return a / constant(b); }
  friend Vec operator+(double a, const Vec& b) { return constant(a) + b; }
  friend Vec operator-(double a, const Vec& b) { return constant(a) - b; }
  friend Vec operator*(double a, const Vec& b) { return constant(a) * b; }
  friend Vec operator/(double a, const Vec& b) { return constant(a) / b; }
  friend Vec operator-(const Vec& a) {
    return each(a, a, [](auto x, auto) { return -x; });
  }

  Vec& operator+=(const Vec& b) { return *this = *this + b; }
  Vec& operator-=(const Vec& b) { return *this = *this - b; }
  Vec& operator*=(const Vec& b) { return *this = *this * b; }
  Vec& operator/=(const Vec& b) { return *this = *this / b; }
  Vec& operator+=(double b) { return *this = *this + b; }
  Vec& operator-=(double b) { return *this = *this - b; }
  Vec& operator*=(double b) { return *this = *this * b; }
  Vec& operator/=(double b) { return *this = *this / b; }

  friend VecMask<D> operator<(const Vec& a, const Vec& b) {
    VecMask<D> mask;
    for (int j = 0; j < D; ++j) mask[j] = a[j] < b[j];
    return mask;
  }
  friend VecMask<D> operator<=(const Vec& a, const Vec& b) {
    VecMask<D> mask;
    for (int j = 0; j < D; ++j) mask[j] = a[j] <= b[j];
    return mask;
  }
  friend VecMask<D> operator==(const Vec& a, const Vec& b) {
    VecMask<D> mask;
    for (int j = 0; j < D; ++j) mask[j] = a[j] == b[j];
    return mask;
  }
  friend VecMask<D> operator>(const Vec& a, const Vec& b) { return b < a; }
  friend VecMask<D> operator>=(const Vec& a, const Vec& b) { return b <= a; }
  friend VecMask<D> operator!=(const Vec& a, const Vec& b) { return !(a == b); }
  friend VecMask<D> operator<(const Vec& a, double b) { return a < constant(b); }
  friend VecMask<D> operator<=(const Vec& a, double b) { return a <= constant(b); }
  friend VecMask<D> operator>(const Vec& a, double b) { return a > constant(b); }
  friend VecMask<D> operator>=(const Vec& a, double b) { return a >= constant(b); }
  friend VecMask<D> operator==(const Vec& a, double b) { return a == constant(b); }
  friend VecMask<D> operator!=(const Vec& a, double b) { return a != constant(b); }

  Vec min(const Vec& b) const {
    return each(*this, b, [](auto x, auto y) { return y < x ? y : x; });
  }
  Vec max(const Vec& b) const {
    return each(*this, b, [](auto x, auto y) { return x < y ? y : x; });
  }
  Vec min(double b) const { return min(constant(b)); }
  Vec max(double b) const { return max(constant(b)); }

  Vec abs() const {
    Vec sizes = *this;
    if constexpr (D == 2) {
      using Bits = typename AxisNumbers<D>::Bits;
      sizes.of_axis_ = reinterpret_cast<decltype(of_axis_)>(reinterpret_cast<Bits>(of_axis_) & INT64_MAX);
    } else {
      for (int j = 0; j < D; ++j) sizes.of_axis_[j] = std::abs(of_axis_[j]);
    }
    return sizes;
  }
  /// -1, 0 or 1 of each axis.
  Vec sign() const {
    Vec signs = *this;
    for (double& number : signs) number = number > 0 ? 1 : number < 0 ? -1 : 0;
    return signs;
  }
  Vec square() const { return *this * *this; }
  VecMask<D> is_finite() const {
    VecMask<D> mask;
    for (int j = 0; j < D; ++j) mask[j] = std::isfinite(of_axis_[j]);
    return mask;
  }

  double sum() const {
    double sum = of_axis_[0];
    for (int j = 1; j < D; ++j) sum += of_axis_[j];
    return sum;
  }
  double product() const {
    double product = of_axis_[0];
    for (int j = 1; j < D; ++j) product *= of_axis_[j];
    return product;
  }
  double length() const { return std::sqrt(square().sum()); }
  double largest() const { return of_axis_[largest_axis()]; }
  int largest_axis() const {
    int axis = 0;
    for (int j = 1; j < D; ++j)
      if (of_axis_[j] > of_axis_[axis]) axis = j;
    return axis;
  }

 private:
  /// f of the numbers of each axis, or of both axes at once.
  template <class Function>
  [[gnu::always_inline]] static Vec each(const Vec& a, const Vec& b, Function f) {
    Vec result;
    if constexpr (D == 2)
      result.of_axis_ = f(a.of_axis_, b.of_axis_);
    else
      for (int j = 0; j < D; ++j) result.of_axis_[j] = f(a.of_axis_[j], b.of_axis_[j]);
    return result;
  }

  typename AxisNumbers<D>::Type of_axis_;
};

/// The first D numbers; the others are those of axes that a scene does not have.
template <int D>
Vec<D> vector_of(const std::array<double, 3>& values) {
  return Vec<D>::at(values.data());
}

}  // namespace foresee
