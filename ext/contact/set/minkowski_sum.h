// Minkowski sums of boxes, balls, cylinders and windows, as pieces of a contact set: the combined sizes of a
// pair, and boxes rounded by a radius.
//
//   const Size radius = radius_of_both(set, setup, setup.within);  // r_a + r_b + within, and both growths
//
// A shape of size r at its t has size r + growth (s - t) at time s. For a pair that is an exact linear
// function of time, too, whose two reference times may differ. If no table declares a growth, then sizes are
// constant.
//
// Boxes are bounds on the other centre. A face may be missing, for example of a window without x1. A box
// inflated by R in the Euclidean sense is the union of simpler sets. These are the box inflated along one
// axis, for every axis, a ball around every corner and, on three axes, a cylinder around every edge.
#pragma once

#include <vector>

#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"

namespace foresee {

/// The growth along an axis until `now` of balls and cylinders; both places may be absent.
Length growth_of_both(const Setup& setup, int axis);
/// The sum of the radii of balls and cylinders and `limit`, the distance that counts as touching.
Size radius_of_both(ContactSet& set, const Setup& setup, double limit);
/// The sum of the half heights of cylinders and `limit`.
Size height_of_both(ContactSet& set, const Setup& setup, double limit);
/// The sum of the half extents of boxes along an axis.
Size half_of_both(ContactSet& set, const Setup& setup, int axis);

/// The faces, on every axis, of the sum of both boxes around the origin; `within` is not added.
std::vector<Faces> faces_of_boxes(ContactSet& set, const Setup& setup);
/// The faces of the setup's window.
std::vector<Faces> faces_of_window(ContactSet& set, const Setup& setup);
/// Faces moved outward by a length.
Faces grown_faces(ContactSet& set, Faces faces, const Size& length);

/// Adds the piece and the hull between the faces.
void add_box(ContactSet& set, std::span<const Faces> faces);

/// The primitives of the faces.
std::vector<int> between(ContactSet& set, std::span<const Faces> faces);

/// Adds pieces and hull of the box between the faces, inflated by `radius` on the axes of the faces. Every
/// piece is also between `along_z`, if given. Requires: two or three axes.
void add_rounded_box(ContactSet& set, std::span<const Faces> faces, const Size& radius,
                     const Faces* along_z = nullptr);

/// Adds the piece and the hull |x| <= radius over the first `axes` axes, between `along_z` if given.
void add_ball(ContactSet& set, int axes, const Size& radius, const Faces* along_z = nullptr);

}  // namespace foresee
