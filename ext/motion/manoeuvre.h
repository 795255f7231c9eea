// How can an object change its motion? Five manoeuvres, each a function of one number k: what the object does
// from a moment on, as numbers that a table can store.
//
//   const OwnMotion base = motion_from(ship, 600);            // the same motion as of t = 600
//   // 15 degrees to starboard
//   const OwnMotion turned = changed(base, {Manoeuvre::turn, speed_of(base)}, 15);
//
//   turn         velocity and acceleration are turned by k degrees clockwise (x east, y north), and so is
//                what has a heading
//   speed        k is added to the speed along the course: v (m + k) / m, m = |v| rounded once
//   climb        k is added to vz
//   accelerate   k is added to the acceleration along the course: a + k v / m
//   delay        everything starts, and ends, later by k: earlier where k < 0
//
// k = 0 changes nothing. Each number is the exact value rounded once, the same on every machine; 0 is never
// -0. A force is changed in place of the acceleration that it gives. Instantaneous, as all velocity obstacles
// are: a change must be a motion that a row can hold. Cost: microseconds.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace foresee {

enum class Manoeuvre : std::uint8_t { turn, speed, climb, accelerate, delay };

/// Its name in SQL.
std::string_view name_of(Manoeuvre manoeuvre);

/// One object's motion with what it is made of; axes that are not there are 0.
struct OwnMotion {
  double t = 0, until = std::numeric_limits<double>::infinity();
  std::array<double, 3> x{}, v{}, a{};
  std::array<double, 3> force{};
  double mass = 0;     ///< 0: no forces; else a is force / mass, rounded
  double heading = 0;  ///< of what has a shape that can be turned, -360 to 360

  friend bool operator==(const OwnMotion&, const OwnMotion&) = default;
};

/// The same motion with its place and velocity as of s, each rounded once. Requires: s >= motion.t.
OwnMotion motion_from(const OwnMotion& motion, double s);

/// The length of the velocity, rounded once; infinite where no double holds it.
double speed_of(const OwnMotion& motion);

/// What is changed, and by the speed of which motion the course is measured.
struct Change {
  Manoeuvre manoeuvre;
  double speed;      ///< speed_of() the base motion
  double later = 0;  ///< of motions_between(): by so much the base itself begins earlier than what is delayed
};

/// The base motion after a change by k; of what overflows, numbers are infinite. Requires: k finite; speed >
/// 0 for Manoeuvre::speed and accelerate.
OwnMotion changed(const OwnMotion& base, const Change& change, double k);

/// Every number is finite but `until`.
bool is_finite(const OwnMotion& motion);

}  // namespace foresee
