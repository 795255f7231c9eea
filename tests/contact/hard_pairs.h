// Seeded families of pairs, each hard in one respect: exact touches and near misses, positions far from the
// origin, different reference times, mixed and extreme scales.
#pragma once

#include <cstdint>
#include <ostream>
#include <random>
#include <span>

#include "contact/oracle.h"

namespace foresee::testing_by_hand {

/// The distribution of the numbers of a family.
struct Family {
  const char* name;
  double places = 8, speeds = 3, turns = 2, sizes = 3;  ///< ranges of x, v, a, extents
  bool whole = false;        ///< halves of whole numbers: exact touches, ties, grazes
  int ulps = 0;              ///< then moved by up to this many units in the last place
  double offset = 0;         ///< far from the origin
  double now = 0, ages = 0;  ///< reference times are up to `ages` before now
  double horizon = 8;
  int scale = 0;   ///< lengths times 2^scale
  int spread = 0;  ///< each number times a random power of two within +-spread
  bool same_motion = false;
  bool lives = false;  ///< until, and starts within the horizon
  double growths = 0;  ///< range of the growth of shapes
};

std::span<const Family> ordinary_families();

/// Families of shapes that grow.
std::span<const Family> growing_families();

/// Families in which products leave the range of doubles.
std::span<const Family> extreme_families();

/// Families of exponents so far apart that 128 bits seldom decide.
std::span<const Family> hostile_families();

enum class Shapes {
  boxes,
  balls,
  box_and_ball,
  cylinders,
  cylinder_and_box,
  points_within,
  box_and_point_within
};

class Generator {
 public:
  Generator(const Family& family, std::uint64_t seed) : family_(family), random_(seed) {}

  double number(double range) {
    double value = std::uniform_real_distribution<double>(-range, range)(random_);
    if (family_.whole) value = std::round(2 * value) / 2;
    if (family_.spread > 0)
      value = std::ldexp(value, static_cast<int>(random_() % (2 * family_.spread + 1)) - family_.spread);
    for (int i = family_.ulps > 0 ? static_cast<int>(random_() % (family_.ulps + 1)) : 0; i > 0; --i)
      value = std::nextafter(value, random_() % 2 ? 1e300 : -1e300);
    return value;
  }
  double length(double range) { return std::ldexp(number(range), family_.scale); }
  double size() { return std::abs(length(family_.sizes)); }
  bool chance(int in) { return random_() % in == 0; }

  Object object(int axes, Shape shape) {
    Object o = testing_by_hand::object(axes, shape);
    o.layout.law = static_cast<Law>(std::min<int>(2, static_cast<int>(random_() % 4)));
    for (int j = 0; j < axes; ++j) {
      o.x[j] = length(family_.places) + family_.offset;
      o.v[j] = length(family_.speeds), o.a[j] = length(family_.turns);
      o.half[j] = size();
    }
    o.r = size(), o.hz = size();
    o.t = family_.now;
    if (family_.ages > 0) o.t -= std::abs(number(family_.ages));
    if (family_.lives && chance(2)) o.t = family_.now + number(family_.horizon);
    if (family_.lives && chance(2)) o.until = o.t + std::abs(number(family_.horizon));
    if (family_.growths > 0 && shape != Shape::point && !chance(4)) grow(o);
    return o;
  }

  /// Moves b so that it comes near a at some time of the horizon: else some families have no contacts.
  void aim(const Object& a, Object& b, const Horizon& horizon) {
    const double meet = horizon.now + std::abs(number(horizon.h));
    auto displacement = [meet](const Object& o, int j) {
      const double s = meet - o.t;
      const double v = o.layout.law == Law::rest ? 0 : o.v[j],
                   a = o.layout.law < Law::accelerated ? 0 : o.a[j];
      return s * v + s * s * a / 2;
    };
    for (int j = 0; j < b.layout.axes; ++j) {
      const double place =
          a.x[j] + displacement(a, j) - displacement(b, j) + (chance(3) ? 0 : length(2 * family_.sizes));
      // With extreme scales some displacements overflow.
      if (std::isfinite(place)) b.x[j] = place;
    }
  }

  Horizon horizon() {
    return {family_.now,
            family_.horizon == 0 || chance(3) ? family_.horizon : std::abs(number(family_.horizon))};
  }

 private:
  void grow(Object& o) {
    Layout& layout = o.layout;
    const bool along_z = layout.shape == Shape::cylinder || (layout.shape == Shape::box && layout.axes == 3);
    layout.has_growth_z = along_z && chance(2);
    layout.has_growth = !layout.has_growth_z || chance(2);
    o.growth = std::abs(length(family_.growths)), o.growth_z = std::abs(length(family_.growths));
    layout.starts_as_point = layout.shape != Shape::box && layout.has_growth && chance(4);
    if (layout.starts_as_point) o.r = o.hz = 0;
  }

  Family family_;
  std::mt19937_64 random_;
};

struct Case {
  Object a, b;
  ContactQuestion question;
};

/// The definition of contact for the oracle, by the table of shapes.
oracle::Rule rule_of(const Object& a, const Object& b, const ContactQuestion& question);

Case make_case(Generator& generate, const Family& family, Shapes shapes, int axes);

/// Calls look(case, generate) for `count` cases of every family, ordinary and extreme.
template <class Visit>
void for_each_hard_pair(Shapes shapes, int axes, int count, std::uint64_t seed, Visit&& visit) {
  for (const auto& families : {ordinary_families(), extreme_families()})
    for (const Family& family : families) {
      Generator generate(family, ++seed);
      for (int i = 0; i < count; ++i) visit(make_case(generate, family, shapes, axes), generate);
    }
}

/// Prints both objects and the ContactQuestion, to the last digit.
std::ostream& operator<<(std::ostream& out, const Case& c);

}  // namespace foresee::testing_by_hand
