// The pieces of one object under a tree of boxes: those of its form, an outline or a mesh, or one box.
//
//   pieces.take_row(ships, ships.outlines, 7);        // or take(form), take_box(box), take_point()
//   if (pieces.is_leaf(node)) test(pieces.piece(pieces.item(node)));
//
// The box is made of the row's half extents; a point is a box of size 0. A window is a box too
// (bounded_window).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/pair.h"
#include "contact/minkowski/relative_motion.h"
#include "motion/axis_aligned_box.h"
#include "shape/form_rows.h"
#include "shape/outline/box_tree.h"
#include "shape/shapes.h"

namespace foresee {

/// Holds one object at a time, which must outlive its use here. `Pieces`, the class derived from this, has
/// take_box(), which sets `box_` and no form, take_point(), and the pieces themselves.
template <class Pieces, int D, class FormOfPieces>
class FormPieces {
 public:
  using Form = FormOfPieces;
  static constexpr int axes = D;
  using Node = typename BoxTree<D>::Node;
  static constexpr Node root = BoxTree<D>::root;

  void take(const Form& form) { form_ = &form; }
  /// Takes the shape of row i. `forms` may be null: then a row with a form counts as the smallest box around
  /// it.
  void take_row(const Bodies& bodies, const FormRows<Form>* forms, std::size_t i) {
    if (const Form* const form = forms ? forms->pieces(i, own_) : nullptr) return take(*form);
    const auto place = [row = bodies.row(i)](int at) { return Vec<D>::at(row + at); };
    const Offsets& at = bodies.at;
    Pieces& self = static_cast<Pieces&>(*this);
    if (!forms && at.bounds != Offsets::absent)
      return self.take_box({place(at.bounds), place(at.bounds + D)});
    if (at.half == Offsets::absent) return self.take_point();
    self.take_box({-place(at.half), place(at.half)});
  }

  std::size_t count() const { return form_ ? form_->count() : 1; }
  const Box<D>& box(Node node) const { return form_ ? form_->tree().box(node) : box_; }
  bool is_leaf(Node node) const { return !form_ || form_->tree().is_leaf(node); }
  std::size_t item(Node leaf) const { return form_ ? form_->tree().item(leaf) : 0; }
  static Node left(Node node) { return 2 * node + 1; }
  static Node right(Node node) { return 2 * node + 2; }

 protected:
  const Form* form_ = nullptr;  ///< null: the box
  Box<D> box_;

 private:
  ScratchPieces<Form> own_;
};

/// A window as a bounded box: a face that the window does not have stands farther out than the object can come.
/// Such a face is at the largest double if the object can come farther: a position that no double holds is
/// outside of the window then. Requires: the setup has a window, whose body is at the origin when the horizon
/// starts.
template <int D>
Box<D> bounded_window(const Setup& setup, const double* row_b) {
  const WindowFaces& faces = *setup.window;
  const double h = setup.horizon.h;
  const double ago = std::abs(setup.horizon.now - value_or(row_b, setup.b.at.t, 0)) + h;
  const auto extent_of = [&]<int Axes>(int axis) {
    const Shape shape = setup.b.layout.shape;
    return reach_of(extents_of<Axes>(shape, row_b, setup.b.at))[axis] +
           ago * growth_of<Axes>(shape, row_b, setup.b.at)[axis];
  };
  const auto size = [&](int axis) {
    return setup.b.layout.axes == 3 ? extent_of.template operator()<3>(axis)
                                    : extent_of.template operator()<2>(axis);
  };
  Box<D> box;
  for (int axis = 0; axis < D; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    const AxisMotion<double> b = axis_motion(setup.b, row_b, axis);
    const double distance = std::abs(b.x) + ago * (std::abs(b.v) + ago * std::abs(b.a)) +
                            h * std::abs(faces.velocity[j]) + size(axis) + std::abs(faces.reference(axis));
    constexpr double largest = std::numeric_limits<double>::max();
    const double far = distance == 0            ? 1
                       : 2 * distance < largest ? 2 * distance
                                                : largest;  // also where `distance` is NaN
    box.lower[axis] = faces.has_lower(axis) ? faces.lower[j] : -far;
    box.upper[axis] = faces.has_upper(axis) ? faces.upper[j] : far;
  }
  return box;
}

/// Takes the shapes of a pair of rows: `tables` has the forms of both tables (contact_factories.h). A window without a
/// form is the first table.
template <class Pieces, class Tables>
void take_pair(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables, const Pair& pair) {
  if (setup.window && !tables.a)
    a.take_box(bounded_window<Pieces::axes>(setup, setup.b.row(pair.b)));
  else
    a.take_row(setup.a, tables.a, pair.a);
  b.take_row(setup.b, tables.b, pair.b);
}

}  // namespace foresee
