// Constraints against their definition in exact arithmetic, for each kind and sign; and every number type of
// the stages against the exact one.
#include "contact/constraint/constraint.h"

#include <gtest/gtest.h>

#include <random>

#include "contact/enclosed_coefficients.h"
#include "numbers/exact_conversion.h"
#include "numbers/polynomial.h"

namespace foresee {
namespace {

/// A direction and an origin of doubles.
template <int N>
struct PlainFeature {
  static constexpr int axes = N;
  std::array<double, N> towards, from;

  template <class T>
  static std::array<T, N> as(const std::array<double, N>& numbers) {
    std::array<T, N> list;
    for (std::size_t j = 0; j < N; ++j) list[j] = Exactly<T>::number(numbers[j]);
    return list;
  }
  template <class T>
  std::array<T, N> direction() const {
    return as<T>(towards);
  }
  template <class T>
  std::array<T, N> origin(int) const {
    return as<T>(from);
  }
  template <class T>
  static T product(const T& a, const T& b) {
    return a * b;
  }
};

template <class T>
struct Sizes {
  MovingSize<T> radius;
};

/// A constraint, a motion and a size of random numbers: halves of whole numbers, or any doubles.
template <int N>
class Sample {
 public:
  Sample(ConstraintKind kind, bool moving, std::uint64_t seed) : moving_(moving), random_(seed) {
    constraint.kind = kind, constraint.sign = random_() % 2 ? 1 : -1;
    for (double& c : constraint.feature.towards) c = number();
    for (double& c : constraint.feature.from) c = number();
    for (auto& axis : motion_)
      for (double& c : axis) c = number();
    radius_ = std::abs(number()), rate_ = std::abs(number());
  }

  double number() {
    const double any = std::uniform_real_distribution<double>(-8, 8)(random_);
    return random_() % 2 ? any : std::round(2 * any) / 2;
  }

  template <class T>
  Coefficients<T, 4> polynomial() const {
    std::array<Coefficients<T, 2>, N> x;
    for (std::size_t j = 0; j < N; ++j)
      for (std::size_t k = 0; k < 3; ++k) x[j][k] = Exactly<T>::number(motion_[j][k]);
    const Sizes<T> sizes{{Exactly<T>::number(radius_), Exactly<T>::number(rate_), moving_}};
    Coefficients<T, 4> all{};
    with_polynomial<2>(constraint, x, sizes,
                       [&all](const auto& p) { std::copy(p.begin(), p.end(), all.begin()); });
    return all;
  }

  /// Its value at tau by the definitions of ConstraintKind.
  Dyadic excess(double tau) const {
    const Dyadic t(tau), radius = Dyadic(radius_) + (moving_ ? t * Dyadic(rate_) : Dyadic());
    Dyadic along, apart, length;
    for (std::size_t j = 0; j < N; ++j) {
      const auto& m = motion_[j];
      const Dyadic gap =
          Dyadic(m[0]) + t * (Dyadic(m[1]) + t * Dyadic(m[2])) - Dyadic(constraint.feature.from[j]);
      const Dyadic towards(constraint.feature.towards[j]);
      along = along + towards * gap, apart = apart + gap * gap, length = length + towards * towards;
    }
    switch (constraint.kind) {
      case ConstraintKind::half_space:
        return constraint.sign < 0 ? -along : along;
      case ConstraintKind::slab:
        return along * along - radius * radius * length;
      case ConstraintKind::tube:  // |n x g|^2 = |n|^2 |g|^2 - (n g)^2
        return apart * length - along * along - radius * radius * length;
      case ConstraintKind::ball:
        break;
    }
    return apart - radius * radius;
  }

  Constraint<PlainFeature<N>> constraint;

 private:
  bool moving_;
  std::mt19937_64 random_;
  double motion_[N][3], radius_, rate_;
};

template <int N, class Check>
void for_each_sample(Check&& check) {
  using enum ConstraintKind;
  for (const auto kind : {half_space, slab, tube, ball})
    for (const bool moving : {false, true})
      for (std::uint64_t seed = 0; seed < 200; ++seed)
        if (N == 3 || kind != tube) check(Sample<N>(kind, moving, seed), seed);
}

template <int N>
void expect_definition() {
  for_each_sample<N>([](Sample<N> sample, std::uint64_t seed) {
    const Polynomial p(sample.template polynomial<Dyadic>());
    for (int i = 0; i < 5; ++i) {
      const double tau = sample.number();
      ASSERT_EQ(value_at(p, Dyadic(tau)), sample.excess(tau)) << seed;
    }
  });
}

TEST(Constraint, ItsPolynomialIsItsDefinition) {
  expect_definition<2>();
  expect_definition<3>();
}

TEST(Constraint, EveryNumberTypeEnclosesTheExactCoefficients) {
  for_each_sample<3>([](const Sample<3>& sample, std::uint64_t seed) {
    testing::expect_enclosed([&]<class T>() { return sample.polynomial<T>(); }, seed);
  });
}

}  // namespace
}  // namespace foresee
