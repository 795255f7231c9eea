// Primitives against their definition, at times computed in exact arithmetic; and every number type of the
// stages against the exact one.
#include "contact/minkowski/primitive.h"

#include <gtest/gtest.h>

#include <random>

#include "contact/enclosed_coefficients.h"
#include "numbers/polynomial.h"

namespace foresee {
namespace {

/// A primitive with random lengths and a random relative motion, all halves of whole numbers or any doubles.
class Sample {
 public:
  Sample(ConstraintKind kind, bool moving, std::uint64_t seed) : random_(seed) {
    primitive.kind = kind;
    primitive.count = kind == ConstraintKind::half_space ? 1 : 1 + static_cast<int>(random_() % 3);
    for (int i = 0; i < primitive.count; ++i) {
      AxisPart& part = primitive.parts[i];
      part = {.axis = primitive.count == 1 ? static_cast<int>(random_() % 3) : i,
              .sign = random_() % 2 ? 1 : -1};
      if (kind == ConstraintKind::ball) part.at = size(moving);
    }
    primitive.size = size(moving);
    for (auto& axis : motion)
      for (double& c : axis) c = number();
  }

  double number() {
    const double any = std::uniform_real_distribution<double>(-8, 8)(random_);
    return random_() % 2 ? any : std::round(2 * any) / 2;
  }

  template <class T>
  std::vector<T> lengths_as() const {
    std::vector<T> list;
    for (const double length : lengths) list.push_back(Exactly<T>::number(length));
    return list;
  }
  /// The motion, expanded at tau.
  template <int K, class T>
  std::array<Coefficients<T, K>, 3> motion_from(double tau) const {
    std::array<Coefficients<T, K>, 3> seen;
    for (std::size_t j = 0; j < 3; ++j) {
      const T t = Exactly<T>::number(tau), x = Exactly<T>::number(motion[j][0]),
              v = Exactly<T>::number(motion[j][1]), a = Exactly<T>::number(motion[j][2]);
      const Coefficients<T, 2> all{x + t * (v + t * a), v + twice(t * a), a};
      std::copy_n(all.begin(), K + 1, seen[j].begin());
    }
    return seen;
  }
  template <int K, class T>
  Coefficients<T, 2 * K> polynomial(double tau) const {
    return polynomial_of<K>(primitive, motion_from<K, T>(tau).data(), lengths_as<T>().data(), tau);
  }

  /// The value of the primitive at tau, by the definitions of primitive.h.
  Dyadic excess(double tau) const {
    const Dyadic t(tau);
    const auto value = [&](const Size& s) {
      const auto of = [&](int i) {
        return i == no_length ? Dyadic() : Dyadic(lengths[static_cast<std::size_t>(i)]);
      };
      return of(s.value) + t * of(s.rate);
    };
    const Dyadic size = value(primitive.size);
    Dyadic sum;
    for (int i = 0; i < primitive.count; ++i) {
      const AxisPart& part = primitive.parts[i];
      const auto& m = motion[static_cast<std::size_t>(part.axis)];
      const Dyadic x = Dyadic(m[0]) + t * Dyadic(m[1]) + t * t * Dyadic(m[2]), sign(part.sign);
      if (primitive.kind == ConstraintKind::half_space) return sign * x - size;
      const Dyadic gap = x - sign * value(part.at);
      sum = sum + gap * gap;
    }
    return sum - size * size;
  }

  Primitive primitive;
  std::vector<double> lengths;
  double motion[3][3];

 private:
  int length() {
    lengths.push_back(number());
    return static_cast<int>(lengths.size()) - 1;
  }
  Size size(bool moving) {
    Size s{.value = length()};
    if (moving) s.rate = length();
    return s;
  }

  std::mt19937_64 random_;
};

template <class Check>
void for_each_sample(Check&& check) {
  for (const auto kind : {ConstraintKind::half_space, ConstraintKind::ball})
    for (const bool moving : {false, true})
      for (std::uint64_t seed = 0; seed < 200; ++seed) check(Sample(kind, moving, seed), seed);
}

TEST(Primitive, ItsPolynomialIsItsDefinition) {
  for_each_sample([](Sample sample, std::uint64_t seed) {
    const Polynomial p(sample.polynomial<2, Dyadic>(0));
    for (int i = 0; i < 5; ++i) {
      const double tau = sample.number();
      ASSERT_EQ(value_at(p, Dyadic(tau)), sample.excess(tau)) << seed;
      // Expanded at a time, the constant coefficient is the value there, also if it is the only one
      // requested.
      ASSERT_EQ((sample.polynomial<2, Dyadic>(tau)[0]), sample.excess(tau)) << seed;
      ASSERT_EQ((sample.polynomial<0, Dyadic>(tau)[0]), sample.excess(tau)) << seed;
    }
  });
}

TEST(Primitive, ExpandedAtAnotherTimeItIsTheSamePolynomial) {
  for_each_sample([](Sample sample, std::uint64_t seed) {
    const double from = sample.number(), s = sample.number();
    const Polynomial p(sample.polynomial<2, Dyadic>(from));
    const Dyadic later = value_at(p, Dyadic(s)), tau = Dyadic(from) + Dyadic(s);
    ASSERT_EQ(later, value_at(Polynomial(sample.polynomial<2, Dyadic>(0)), tau)) << seed;
  });
}

TEST(Primitive, EveryNumberTypeEnclosesTheExactCoefficients) {
  for_each_sample([](Sample sample, std::uint64_t seed) {
    const double tau = sample.number();
    testing::expect_enclosed([&]<class T>() { return sample.polynomial<2, T>(tau); }, seed);
  });
}

TEST(Primitive, OfUniformMotionHasTheSameCoefficients) {
  for_each_sample([](Sample sample, std::uint64_t seed) {
    for (auto& axis : sample.motion) axis[2] = 0;
    const auto two = sample.polynomial<2, Dyadic>(0);
    const auto one = sample.polynomial<1, Dyadic>(0);
    for (std::size_t k = 0; k < two.size(); ++k)
      ASSERT_EQ(two[k], k < one.size() ? one[k] : Dyadic()) << seed << " power " << k;
  });
}

}  // namespace
}  // namespace foresee
