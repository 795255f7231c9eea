// The arithmetic of the oracles: exact binary fractions, Sturm's count of roots, and times as isolating
// intervals of one root.
//
// It is simple and independent of the engine: no polynomial is expanded around a point or converted to
// another basis. Roots are counted by Sturm's theorem and isolated by bisection.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

namespace foresee::oracle {

using Whole = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked>,
    boost::multiprecision::et_off>;

/// n 2^e, closed under sums, differences, products and halves. A double is one.
struct Exact {
  Whole n = 0;
  int e = 0;

  Exact() = default;
  Exact(double value);  // NOLINT: a double is exactly such a number
  Exact(Whole whole, int exponent) : n(std::move(whole)), e(exponent) {}

  int sign() const { return n.sign(); }
  Exact operator-() const { return {-n, e}; }
  friend Exact operator+(const Exact& a, const Exact& b);
  friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
  friend Exact operator*(const Exact& a, const Exact& b) { return {a.n * b.n, a.e + b.e}; }
  Exact& operator+=(const Exact& b) { return *this = *this + b; }
  Exact& operator-=(const Exact& b) { return *this = *this - b; }
  friend bool operator<(const Exact& a, const Exact& b) { return (a - b).sign() < 0; }
  friend bool operator>(const Exact& a, const Exact& b) { return b < a; }
  friend bool operator<=(const Exact& a, const Exact& b) { return !(b < a); }
  friend bool operator==(const Exact& a, const Exact& b) { return (a - b).sign() == 0; }
};

inline Exact half(const Exact& a) {
  return {a.n, a.e - 1};
}
inline Exact middle(const Exact& a, const Exact& b) {
  return half(a + b);
}

using Coefficients = std::vector<Exact>;  ///< of tau^0, tau^1, …
using Integers = std::vector<Whole>;      ///< the same up to a positive factor, without leading zeros

Integers integers_of(const Coefficients& p);
Integers derivative(const Integers& p);
Exact value_at(const Coefficients& p, const Exact& x);
int sign_at(const Integers& p, const Exact& x);
/// The same polynomial up to a factor.
Integers common_divisor(Integers a, Integers b);

/// A polynomial and its number of distinct roots in an interval.
class Sturm {
 public:
  explicit Sturm(Integers p);
  const Integers& polynomial() const { return polynomial_; }
  /// A polynomial of the same roots, each simple; its signs may differ.
  const Integers& square_free() const { return chain_.front(); }
  /// The number of distinct roots in (low, high].
  int count(const Exact& low, const Exact& high) const { return variations(low) - variations(high); }

 private:
  void build(Integers p);
  int variations(const Exact& x) const;
  Integers polynomial_;
  std::vector<Integers> chain_;
};

/// A time: the only root of a polynomial in (low, high].
class TimePoint {
 public:
  TimePoint(const Sturm& sturm, Exact low, Exact high)
      : low(std::move(low)), high(std::move(high)), sturm_(&sturm), sign_high_(sign_of(this->high)) {}

  void halve();
  /// -1, 0, 1: the time is before, at, after x.
  int compare(const Exact& x) const;
  /// The sign of a polynomial here.
  int sign_of(const Sturm& p);
  /// True if both are the same time; else bisects them until their intervals are disjoint.
  friend bool same_time(TimePoint& a, TimePoint& b);

  Exact low, high;

 private:
  int sign_of(const Exact& x) const { return sign_at(sturm_->square_free(), x); }
  const Sturm* sturm_;  ///< owned by the maker of the time
  int sign_high_;       ///< 0: the root is `high`
};

/// All roots in (low, high], in order.
std::vector<TimePoint> times_between(const Sturm& sturm, const Exact& low, const Exact& high);

/// Whether `value` is the double nearest to the number that `compare(x)` compares with x, ties to even.
template <class Compare>
bool is_nearest(double value, Compare&& compare) {
  if (!(std::abs(value) < std::numeric_limits<double>::max())) return false;
  const double inf = std::numeric_limits<double>::infinity();
  const int low = compare(middle(value, std::nextafter(value, -inf)));
  const int high = compare(middle(value, std::nextafter(value, inf)));
  const bool even = std::bit_cast<std::uint64_t>(value) % 2 == 0;
  return (low > 0 || (low == 0 && even)) && (high < 0 || (high == 0 && even));
}

}  // namespace foresee::oracle
