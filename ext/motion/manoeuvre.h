// Manoeuvres of one object, and the numbers of its motion as a table stores them.
//
//   const OwnMotion base = motion_from(ship, 600);            // the same motion as of t = 600
//   changes_by(Manoeuvre::turn, base)->changed(15)            // 15 degrees to starboard (changes.h)
//
//   turn         turns velocity and acceleration by k degrees clockwise (x east, y north), and the heading
//                of a shape that has one
//   speed        adds k to the speed along the course: v (m + k) / m, m = |v| rounded once. On a path that
//                bends because the Earth is round, the acceleration becomes a ((m + k) / m)^2
//   climb        adds k to vz
//   accelerate   adds k to the acceleration along the course: a + k v / m
//   delay        shifts start and end by k: later, or earlier where k < 0
//   wait         rests for k from its start on, then goes on: all that follows is later by k
//
// Changes are instantaneous, as in all velocity obstacles: the result must be a motion that a row can hold. Each
// number is the exact value rounded once. Cost: microseconds.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace foresee {

enum class Manoeuvre : std::uint8_t { turn, speed, climb, accelerate, delay, wait };

/// The manoeuvre's name in SQL.
std::string_view name_of(Manoeuvre manoeuvre);

/// The stored numbers of one object's motion, with force and mass; unused axes are 0.
struct OwnMotion {
  double t = 0, until = std::numeric_limits<double>::infinity();
  std::array<double, 3> x{}, v{}, a{};
  std::array<double, 3> force{};
  double mass = 0;     ///< 0: no forces; else a is force / mass, rounded
  double heading = 0;  ///< of a shape that can be turned, -360 to 360

  friend bool operator==(const OwnMotion&, const OwnMotion&) = default;
};

/// The same motion with position and velocity as of s, each rounded once. Requires: s >= motion.t.
OwnMotion motion_from(const OwnMotion& motion, double s);

/// The length of the velocity, rounded once; infinite where no double holds it.
double speed_of(const OwnMotion& motion);

/// Whether all numbers are finite, except perhaps `until`.
bool is_finite(const OwnMotion& motion);

}  // namespace foresee
