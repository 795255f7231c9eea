// Layout: the columns that a table declares, and the order of an object's doubles in records and rows.
//
//   Layout drones{.axes = 3, .law = Law::accelerated, .shape = Shape::box, .has_t = true};
//   Offsets at = record_offsets(drones);      // .t = 0, .x = 1, .v = 4, .a = 7, .half = 10, .size = 13
//
// A record is the stored form, a row the one that queries read. A column that is not declared has the offset
// `absent` and costs no byte and no time.
#pragma once

#include <cstdint>

#include "motion/motion.h"

namespace foresee {

/// The shape of an object around its centre.
enum class Shape : std::uint8_t {
  point,
  box,       ///< half extents on every axis
  ball,      ///< radius: an interval, a disc or a ball
  cylinder,  ///< three axes only: radius in x and y, half extent in z
  outline,   ///< a flat outline, or on three axes the upright prism over it; inflated by a radius
  mesh,      ///< three axes only: triangles, a surface or a solid; inflated by a radius
};

/// Whether the form of an object is stored separately, and its record has the form's number.
constexpr bool is_stored_apart(Shape shape) {
  return shape == Shape::outline || shape == Shape::mesh;
}

/// The number of axes with stored bounds: a prism has a half height along z instead.
constexpr int bounded_axes(Shape shape) {
  return shape == Shape::mesh ? 3 : shape == Shape::outline ? 2 : 0;
}

struct Layout {
  int axes = 1;
  Law law = Law::rest;
  Shape shape = Shape::point;
  bool has_t = false;
  bool has_until = false;
  bool has_radius = false;       ///< of an outline or a mesh: each is inflated by an r
  bool has_heading = false;      ///< of an outline or a mesh: each is rotated
  bool has_growth = false;       ///< it grows from t on: a box on every axis, an upright shape in x and y
  bool has_growth_z = false;     ///< it grows along z at a separate rate
  bool starts_as_point = false;  ///< a ball or cylinder of size 0 at t, which only grows
  bool has_category = false;     ///< of its kinds (kinds.h)
  bool has_mask = false;         ///< of its kinds
  /// An object may have a plan of several legs (motion/plan/plan.h). Requires: t, until, and a law with v and without
  /// forces; no growth.
  bool has_plan = false;

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

/// The offset of each quantity among an object's doubles; vectors take `axes` places, force and mass are
/// adjacent.
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
  int growth = absent;    ///< rate at which the shape grows, per unit of time
  int growth_z = absent;  ///< rate along z, if separate
  int outline = absent;   ///< number of the outline or mesh (storage/table/stored_forms.h); 0: a row without
  int heading = absent;   ///< rotation in degrees clockwise
  int bounds = absent;  ///< of the rotated outline around the centre: lower x, y, upper x, y; a mesh: x, y, z
  int until = absent;   ///< last time of the motion, +infinity: unbounded
  int category = absent;  ///< bits of its category, a whole number below 2^32
  int mask = absent;      ///< bits of the categories that it may meet, likewise
  int plan = absent;      ///< number of the first chunk of its plan, 0: it has none; only in records
  int chunks = absent;    ///< how many chunks; only in records
  int size = 0;           ///< doubles per object

  friend bool operator==(const Offsets&, const Offsets&) = default;
};

inline double value_or(const double* row, int place, double otherwise) {
  return place == Offsets::absent ? otherwise : row[place];
}

/// The order of the doubles as they are stored: t, x…, v…, a… or force… and mass, the sizes of the shape,
/// growth, growth_z, outline, heading and bounds, until, category, mask, plan, chunks.
Offsets record_offsets(const Layout& layout);

/// The order of the doubles that queries read: the same, with the acceleration in place of force and mass, and
/// without plan and chunks.
Offsets row_offsets(const Layout& layout);

/// The layout of the items of a tree of chunks (motion/plan/chunks.h): moving boxes with t and until, and the kinds of
/// their objects. Requires: a layout with plans.
Layout chunk_layout(const Layout& layout);

/// Whether the record is of an object with a plan: its t, x, v, a are those of its first leg.
inline bool has_plan(const Offsets& record_offsets, const double* record) {
  return value_or(record, record_offsets.plan, 0) != 0;
}

/// Turns one stored record into the row that queries read. The two differ for Law::forced, and where the layout has
/// plans. The row of an object with a plan ends before it starts, so no query finds it; its legs are rows of their own.
void row_from_record(const Layout& layout, const double* record, double* row);

}  // namespace foresee
