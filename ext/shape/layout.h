// Which numbers does an object have? A layout is what a table declares; it fixes the order of an object's
// doubles in the stored record and in the row that queries compute with.
//
//   Layout drones{.axes = 3, .law = Law::accelerated, .shape = Shape::box, .has_t = true};
//   Offsets at = record_offsets(drones);      // .t = 0, .x = 1, .v = 4, .a = 7, .half = 10, .size = 13
//
// What is not declared has no place: its offset is `absent` and it costs no byte and no time.
#pragma once

#include <cstdint>

#include "motion/law.h"

namespace foresee {

/// What an object is around its centre.
enum class Shape : std::uint8_t {
  point,
  box,       ///< half extents on every axis
  ball,      ///< radius: an interval, a disc or a ball
  cylinder,  ///< three axes only: radius in x and y, half extent in z
  outline,   ///< a flat outline of its own, or on three axes the upright prism over it; grown by a radius
  mesh,      ///< three axes only: triangles of its own, a surface or a solid; grown by a radius
};

/// Whether what an object looks like is stored apart, and its record has the number of that.
constexpr bool is_stored_apart(Shape shape) {
  return shape == Shape::outline || shape == Shape::mesh;
}

/// In how many axes such a shape has bounds: a prism has its half height along z.
constexpr int bounded_axes(Shape shape) {
  return shape == Shape::mesh ? 3 : shape == Shape::outline ? 2 : 0;
}

struct Layout {
  int axes = 1;
  Law law = Law::rest;
  Shape shape = Shape::point;
  bool has_t = false;
  bool has_until = false;
  bool has_radius = false;       ///< of an outline or a mesh: each grows by an r
  bool has_heading = false;      ///< of an outline or a mesh: each is turned
  bool has_growth = false;       ///< from t on it grows: a box on every axis, what is upright in x and y
  bool has_growth_z = false;     ///< along z it grows at a rate of its own
  bool starts_as_point = false;  ///< a ball or cylinder that has no size but what growth gives it

  friend bool operator==(const Layout&, const Layout&) = default;
};

/// Whether objects become larger with time.
constexpr bool grows(const Layout& layout) {
  return layout.has_growth || layout.has_growth_z;
}

/// Whether bounds of objects move.
constexpr bool bounds_move(const Layout& layout) {
  return layout.law != Law::rest || grows(layout);
}

/// Where each quantity starts among an object's doubles; vectors take `axes` places, forces and masses sit
/// side by side.
struct Offsets {
  static constexpr int absent = -1;
  int t = absent;         ///< reference time
  int x = absent;         ///< centre at the reference time
  int v = absent;         ///< velocity at the reference time
  int a = absent;         ///< acceleration
  int force = absent;     ///< only in records
  int mass = absent;      ///< only in records
  int half = absent;      ///< half extents of a box
  int r = absent;         ///< radius of a ball or cylinder
  int hz = absent;        ///< half height of a cylinder or prism
  int growth = absent;    ///< by how much the shape grows in a unit of time
  int growth_z = absent;  ///< along z, apart from the rest
  int outline = absent;   ///< number of the outline or mesh (storage/table/stored_forms.h); 0: none
  int heading = absent;   ///< by which it is turned, in degrees clockwise
  int bounds = absent;  ///< of the turned outline around the centre: lower x, y, upper x, y; a mesh: x, y, z
  int until = absent;   ///< last moment of the motion, +infinity for ever
  int size = 0;         ///< doubles per object

  friend bool operator==(const Offsets&, const Offsets&) = default;
};

inline double value_or(const double* row, int place, double otherwise) {
  return place == Offsets::absent ? otherwise : row[place];
}

/// The order of the doubles as they are stored: t, x…, v…, a… or force… and mass, the sizes of the shape,
/// growth, growth_z, outline, heading and bounds, until.
Offsets record_offsets(const Layout& layout);

/// The order of the doubles that queries read: the same, with the acceleration in place of force and mass.
Offsets row_offsets(const Layout& layout);

/// Turns one stored record into the row that queries read. The two differ for Law::forced only.
void row_from_record(const Layout& layout, const double* record, double* row);

}  // namespace foresee
