// Beams contain the object at every time of its life, checked in rational numbers. All sets of vector
// instructions give the same bits.
#include "shape/beam.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cstring>
#include <random>

#include "every_simd.h"
#include "shape/swept_boxes.h"

namespace foresee {
namespace {

using Rational = boost::multiprecision::cpp_rational;
constexpr double inf = std::numeric_limits<double>::infinity();

struct Course1 {
  double t, x, v, a, half, until;
};

/// The beams of all objects, by every set of vector instructions.
template <int D>
std::unique_ptr<BeamLanes<D>> beams_of(const Bodies& bodies, const Horizon& horizon) {
  const auto lanes_in_use = [&] {
    auto lanes = std::make_unique<BeamLanes<D>>();
    beams<D>(bodies, 0, bodies.count, horizon, Vec<D>::zero(), *lanes);
    return lanes;
  };
  auto first = lanes_in_use();
  testing::for_every_simd([&](Simd) {
    const auto others = lanes_in_use();
    const std::size_t bytes = bodies.count * sizeof(double);
    for (int k = 0; k < D; ++k) {
      EXPECT_EQ(std::memcmp(first->lower[k], others->lower[k], bytes), 0);
      EXPECT_EQ(std::memcmp(first->upper[k], others->upper[k], bytes), 0);
    }
    for (std::size_t l = 0; l < bodies.count; ++l) {
      const Beam<D> one = beam_at(*first, l), other = beam_at(*others, l);
      EXPECT_TRUE(
          ((one.travel == other.travel) || (one.travel != one.travel && other.travel != other.travel)).all());
      EXPECT_EQ(one.begin, other.begin);
      EXPECT_EQ(one.end, other.end);
    }
  });
  return first;
}

Beam<1> beam_of(const Course1& o, const Horizon& horizon) {
  const double row[] = {o.t, o.x, o.v, o.a, o.half, o.until};
  const Layout layout{
      .axes = 1, .law = Law::accelerated, .shape = Shape::box, .has_t = true, .has_until = true};
  return beam_at(*beams_of<1>({layout, row, 1}, horizon), 0);
}

/// Whether the object lies in the beam at the fraction `f` of the horizon. The fractions of its life are
/// rounded, so that their users must add 2^-40 of the travel.
bool holds(const Beam<1>& beam, const Course1& o, const Horizon& horizon, const Rational& f) {
  if (!std::isfinite(beam.box.lower[0]) || !std::isfinite(beam.box.upper[0])) return true;
  const Rational s = Rational(horizon.now) + f * Rational(horizon.h) - Rational(o.t);
  const Rational place = Rational(o.x) + Rational(o.v) * s + Rational(o.a) * s * s / 2;
  const Rational lower(beam.box.lower[0]), upper(beam.box.upper[0]), travel(beam.travel[0]);
  const Rational begin(beam.begin), end(beam.end);
  const Rational centre = (lower + upper) / 2 + travel * (f - (begin + end) / 2);
  const Rational radius = (upper - lower) / 2 - abs(travel) * (end - begin) / 2;
  return abs(place - centre) + Rational(o.half) <= radius + abs(travel) * Rational(0x1p-40);
}

void expect_inside(const Course1& o, const Horizon& horizon) {
  const Rational now(horizon.now), h(horizon.h);
  const Rational starts = std::max(Rational(o.t) - now, Rational(0));
  const Rational ends = o.until == inf ? h : std::min(Rational(o.until) - now, h);
  const Beam<1> beam = beam_of(o, horizon);
  if (starts > ends) return;
  ASSERT_FALSE(beam.box.is_empty());
  for (int k = 0; k <= 8; ++k) {
    const Rational f = h == 0 ? Rational(0) : (starts + (ends - starts) * k / 8) / h;
    ASSERT_TRUE(holds(beam, o, horizon, f))
        << k << ": t " << o.t << " x " << o.x << " v " << o.v << " a " << o.a << " half " << o.half
        << " until " << o.until << " now " << horizon.now << " h " << horizon.h;
  }
}

TEST(Beam, HoldsTheObjectAtEveryTime) {
  std::mt19937_64 random(7);
  auto number = [&](double lowest, double highest) {  // of any size, either sign, sometimes 0
    if (random() % 8 == 0) return 0.0;
    std::uniform_real_distribution<double> exponent(lowest, highest), part(-2, 2);
    return std::ldexp(part(random), static_cast<int>(exponent(random)));
  };
  for (int i = 0; i < 3000; ++i) {
    const double size = i % 3 == 0 ? 6 : i % 3 == 1 ? 50 : 300;
    const double t = number(-size, size);
    const double until = random() % 2 ? inf : t + std::abs(number(-size, size));
    const Course1 o{
        t, number(-size, size), number(-size, size), number(-size, size), std::abs(number(-9, size)), until};
    expect_inside(o, {number(-size, size), std::abs(number(-size, size))});
  }
}

TEST(Beam, HoldsAtUnixTimesAndFarPlaces) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> some(-3, 3);
  for (int i = 0; i < 1000; ++i) {
    const double t = 1.7e9 + some(random);
    expect_inside({t, 1e15 + some(random), some(random), some(random), 0.5, random() % 2 ? inf : t + 4},
                  {1.7e9, 2 + some(random) / 2});
  }
}

TEST(Beam, IsNoThickerThanTheSagittaRequires) {
  const Beam<1> straight = beam_of({0, 5, 2, 0, 1, inf}, {0, 10});
  EXPECT_NEAR(straight.box.lower[0], 4, 1e-12);
  EXPECT_NEAR(straight.box.upper[0], 26, 1e-12);
  EXPECT_EQ(straight.travel[0], 20);
  const Beam<1> bent = beam_of({0, 0, -2, 1, 0, inf}, {0, 4});  // out to -2 and back
  EXPECT_NEAR(bent.box.lower[0], -2, 1e-12);
  EXPECT_NEAR(bent.box.upper[0], 0, 1e-12);
  EXPECT_EQ(bent.travel[0], 0);
}

/// Without columns an object is at rest, from time 0, unbounded; each shape has its extents.
template <int D>
void expect_as_declared_in_full(const Layout& layout, double now) {
  const Layout full{
      .axes = D, .law = Law::accelerated, .shape = Shape::box, .has_t = true, .has_until = true};
  const Offsets at = row_offsets(full);
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> some(0, 3);
  std::vector<double> rows, full_rows;
  constexpr std::size_t count = BeamLanes<D>::width - 3;
  for (std::size_t i = 0; i < count * static_cast<std::size_t>(row_offsets(layout).size); ++i)
    rows.push_back(some(random));
  const Bodies bodies(layout, rows.data(), count);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> row(static_cast<std::size_t>(at.size));
    const Motion<D> motion = motion_of<D>(bodies, i);
    const Vec<D> half = extents_of<D>(bodies, i).upper;
    for (int k = 0; k < D; ++k) {
      const auto put = [&row, k](int place, double x) { row[static_cast<std::size_t>(place + k)] = x; };
      put(at.x, motion.x[k]), put(at.v, motion.v[k]), put(at.a, motion.a[k]), put(at.half, half[k]);
    }
    row[static_cast<std::size_t>(at.t)] = motion.t, row[static_cast<std::size_t>(at.until)] = motion.until;
    full_rows.insert(full_rows.end(), row.begin(), row.end());
  }
  const auto found = beams_of<D>(bodies, {now, 4}),
             wanted = beams_of<D>({full, full_rows.data(), count}, {now, 4});
  for (std::size_t l = 0; l < count; ++l) {
    EXPECT_TRUE((beam_at(*found, l).box.lower == beam_at(*wanted, l).box.lower).all());
    EXPECT_TRUE((beam_at(*found, l).box.upper == beam_at(*wanted, l).box.upper).all());
    EXPECT_TRUE((beam_at(*found, l).travel == beam_at(*wanted, l).travel).all());
    EXPECT_EQ(beam_at(*found, l).begin, beam_at(*wanted, l).begin);
    EXPECT_EQ(beam_at(*found, l).end, beam_at(*wanted, l).end);
  }
}

TEST(Beam, OfEveryLayoutIsThatOfTheFullOne) {
  for (double now : {-5.0, -1.0, 0.0, 2.0})
    for (Law law : {Law::rest, Law::uniform, Law::accelerated})
      for (int lives = 0; lives < 4; ++lives) {
        const bool has_t = lives & 1, has_until = lives & 2;
        for (Shape shape : {Shape::point, Shape::box, Shape::ball}) {
          expect_as_declared_in_full<1>({1, law, shape, has_t, has_until}, now);
          expect_as_declared_in_full<2>({2, law, shape, has_t, has_until}, now);
        }
        expect_as_declared_in_full<3>({3, law, Shape::cylinder, has_t, has_until}, now);
      }
}

TEST(Beam, KnowsWhenTheObjectExists) {
  const Beam<1> part = beam_of({2, 0, 1, 0, 0, 6}, {0, 8});
  EXPECT_EQ(part.begin, 0.25);
  EXPECT_EQ(part.end, 0.75);
  EXPECT_EQ(part.travel[0], 8) << "of the whole horizon";
  EXPECT_TRUE(beam_of({9, 0, 1, 0, 0, inf}, {0, 8}).box.is_empty());
  EXPECT_EQ(beam_of({2, 0, 1, 0, 0, 2}, {0, 8}).travel[0], 0) << "a life of one time has no travel";
}

}  // namespace
}  // namespace foresee
