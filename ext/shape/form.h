// What do many rows look like? A form is what a column `shape` holds, an outline or a mesh: stored once and
// shared by rows, each of which turns it by a heading of its own.
//
//   const std::shared_ptr<const Form> hull = source.form(3);
//   hull->extents(37.5)                  // throws where it cannot be turned so
//
// Never changes: several threads and statements may hold one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "motion/box.h"
#include "shape/layout.h"

namespace foresee {

class Form {
 public:
  virtual ~Form() = default;
  /// Of the layout whose rows have such forms: Shape::outline is a SharedOutline, Shape::mesh a SharedMesh.
  virtual Shape shape() const = 0;
  /// By which memory is counted.
  virtual std::size_t corners() const = 0;
  /// Canonical well-known text.
  virtual std::string text() const = 0;
  /// The smallest box around it, turned by `heading` degrees (outline/outline_rotation.h); of an outline none along z.
  /// Throws Error if that is no outline or mesh, or beyond the largest double. Requires: -360 <= heading <=
  /// 360.
  virtual Extents<3> extents(double heading) const = 0;
};

/// Who knows forms by the numbers that rows have.
class FormSource {
 public:
  virtual ~FormSource() = default;
  /// Never null: throws where there is none of this number. It is one of the shape of the rows' layout.
  virtual std::shared_ptr<const Form> form(std::int64_t number) = 0;
};

/// The one that a text means. Throws Error, which says what is wrong and where, for a text that is none.
/// Requires: Shape::outline or Shape::mesh.
std::shared_ptr<const Form> read_form(Shape shape, std::string_view text);

/// "mesh": what messages call a form of this shape.
constexpr const char* name_of_form(Shape shape) {
  return shape == Shape::mesh ? "mesh" : "outline";
}

}  // namespace foresee
