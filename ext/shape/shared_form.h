// Form: an outline or a mesh that many rows share, the value of a column `shape`.
//
// It is stored once; each row rotates it by a heading of its own.
//
//   const std::shared_ptr<const Form> hull = source.form(3);
//   hull->extents(37.5)                  // throws if this rotation is not possible
//
// Immutable: several threads and statements may hold one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "motion/axis_aligned_box.h"
#include "shape/row_layout.h"

namespace foresee {

class Form {
 public:
  virtual ~Form() = default;
  /// The shape in a layout: Shape::outline for a SharedOutline, Shape::mesh for a SharedMesh.
  virtual Shape shape() const = 0;
  /// The measure of memory.
  virtual std::size_t corners() const = 0;
  /// Canonical well-known text.
  virtual std::string text() const = 0;
  /// The bounding box after a rotation by `heading` degrees (outline/outline_rotation.h); 0 along z for an
  /// outline. Throws Error if the result is not a valid outline or mesh, or beyond the largest double.
  /// Requires: -360 <= heading <= 360.
  virtual Extents<3> extents(double heading) const = 0;
};

/// Loads forms by the numbers that rows store.
class FormSource {
 public:
  virtual ~FormSource() = default;
  /// Never null: throws if no form has this number. The form has the shape of the rows' layout.
  virtual std::shared_ptr<const Form> form(std::int64_t number) = 0;
};

/// Reads a form from well-known text. Throws Error, which says what is wrong and where. Requires:
/// Shape::outline or Shape::mesh.
std::shared_ptr<const Form> read_form(Shape shape, std::string_view text);

/// The name of such a form in messages: "mesh".
constexpr const char* name_of_form(Shape shape) {
  return shape == Shape::mesh ? "mesh" : "outline";
}

}  // namespace foresee
