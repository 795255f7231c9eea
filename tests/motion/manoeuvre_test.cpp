// The five manoeuvres; a set of changed motions contains each of them.
#include <gtest/gtest.h>

#include <cmath>

#include "motion/changes.h"
#include "scenes.h"

namespace foresee {
namespace {

using testing::Random;

OwnMotion drone(Random& random) {
  OwnMotion motion;
  motion.t = random.in(-5, 5), motion.until = motion.t + 30;
  for (std::size_t j = 0; j < 3; ++j)
    motion.x[j] = random.in(-9, 9), motion.v[j] = random.in(-3, 3), motion.a[j] = random.in(-1, 1);
  return motion;
}

std::unique_ptr<Changes> changes(Manoeuvre manoeuvre, const OwnMotion& base, double lo = 0,
                                 bool scales_bend = false) {
  return manoeuvre == Manoeuvre::delay ? delays_of(base, lo) : changes_by(manoeuvre, base, scales_bend);
}

OwnMotion changed(Manoeuvre manoeuvre, const OwnMotion& base, double k) {
  return changes(manoeuvre, base)->changed(k);
}

constexpr Manoeuvre all[] = {Manoeuvre::turn, Manoeuvre::speed, Manoeuvre::climb, Manoeuvre::accelerate,
                             Manoeuvre::delay};

TEST(Manoeuvre, ChangesNothingByZero) {
  Random random(1);
  const OwnMotion base = drone(random);
  for (const Manoeuvre manoeuvre : all) EXPECT_EQ(changed(manoeuvre, base, 0), base);
}

TEST(Manoeuvre, ChangesWhatItSays) {
  OwnMotion ship;
  ship.t = 10, ship.v = {3, 4, 0};
  EXPECT_EQ(speed_of(ship), 5);
  EXPECT_EQ(changed(Manoeuvre::turn, ship, 90).v, (std::array<double, 3>{4, -3, 0}));
  EXPECT_EQ(changed(Manoeuvre::speed, ship, 5).v, (std::array<double, 3>{6, 8, 0}));
  const OwnMotion stopped = changed(Manoeuvre::speed, ship, -5);
  EXPECT_EQ(stopped.v, (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(changed(Manoeuvre::climb, ship, 2).v[2], 2);
  EXPECT_EQ(changed(Manoeuvre::accelerate, ship, 0.5).a, (std::array<double, 3>{0.3, 0.4, 0}));
  EXPECT_EQ(changed(Manoeuvre::delay, ship, 7).t, 17);
  ship.a = {0, 0, -2};
  const auto along_the_earth = changes(Manoeuvre::speed, ship, 0, true);
  EXPECT_EQ(along_the_earth->changed(5).a, (std::array<double, 3>{0, 0, -8}));
  EXPECT_EQ(along_the_earth->changed(-5).a, (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(along_the_earth->changed(-10).a, ship.a) << "backwards on the same path";
  ship.mass = 2, ship.force = {2, 0, 0}, ship.a = {1, 0, 0};
  const OwnMotion pushed = changed(Manoeuvre::accelerate, ship, 0.5);
  EXPECT_EQ(pushed.force, (std::array<double, 3>{2.6, 0.8, 0}));
  EXPECT_EQ(pushed.a, (std::array<double, 3>{1.3, 0.4, 0}));
}

TEST(Manoeuvre, IsAsOfTheTimeOfTheChange) {
  OwnMotion motion;
  motion.x = {1, 0, 0}, motion.v = {2, 0, 0}, motion.a = {1, 0, 0};
  const OwnMotion from = motion_from(motion, 4);
  EXPECT_EQ(from.t, 4);
  EXPECT_EQ(from.x[0], 17);
  EXPECT_EQ(from.v[0], 6);
}

TEST(MotionSet, HoldsEachOfItsMotions) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const OwnMotion base = drone(random);
    const Manoeuvre manoeuvre = all[i % 5];
    const auto set_of = changes(manoeuvre, base, -random.in(2, 5), i % 2 == 0);
    const OwnMotion& from = set_of->reference();
    const double width = std::exp2(random.in(-40, 2)) * (manoeuvre == Manoeuvre::turn ? 90 : 1);
    const double p = random.in(-2, 2), q = p + width;
    const MotionSet<3> set = set_of->between<3>(p, q);
    const double k = i % 3 == 0 ? p : i % 3 == 1 ? q : p + width * random.unit();
    const OwnMotion one = set_of->changed(k);
    Vec<3> n;
    for (double& part : n) part = random.in(-1, 1);
    const double tau = random.in(0, 20);
    double there = 0, speed = 0, bend = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto j = static_cast<std::size_t>(axis);
      const double s = tau - (one.t - from.t);
      there += n[axis] * (one.x[j] - base.x[j] + one.v[j] * s + 0.5 * one.a[j] * s * s);
      speed += n[axis] * one.v[j], bend += n[axis] * one.a[j];
    }
    const double bound =
        set.place.support(n) + set.velocity.support(n) * tau + 0.5 * set.acceleration.support(n) * tau * tau;
    EXPECT_LE(there, bound + 1e-13 * (1 + std::abs(bound))) << name_of(manoeuvre);
    if (manoeuvre != Manoeuvre::delay) {
      EXPECT_LE(speed, set.velocity.support(n));
      EXPECT_LE(bend, set.acceleration.support(n));
    }
    EXPECT_GE(set.velocity.support(n), -set.velocity.support(-n));
  }
}

}  // namespace
}  // namespace foresee
