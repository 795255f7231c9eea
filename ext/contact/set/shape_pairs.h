// The contact sets behind the door, one function per pair of shapes. Each is made once a statement, from what
// the two tables declare and what the question asks; the numbers of a pair come later.
#pragma once

#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"

namespace foresee {

// Discs and balls around the origin of the relative motion.

/// |x| <= radius over the first `axes` axes, as the one piece of a set; also between `along_z`, if given.
void add_ball(ContactSet& set, int axes, const Size& radius, const Faces* along_z = nullptr);

/// Boxes, points that coincide, and everything in one dimension: on every axis |x| <= H.
ContactSet box_box_set(const Setup& setup);
/// Discs and balls, and points that come within a distance: |x| <= R, all axes together; R is both radii and
/// the distance, added.
ContactSet ball_ball_set(const Setup& setup);
/// A box and a disc, ball, or point that comes within a distance: Euclidean from the box to the surface.
ContactSet box_ball_set(const Setup& setup);
/// Upright cylinders, and points as cylinders of no size: a disc in x and y, and an interval along z.
ContactSet cylinder_cylinder_set(const Setup& setup);
/// An upright cylinder (or a point as one of no size) and a box: a rounded rectangle in x and y, an interval
/// along z.
ContactSet cylinder_box_set(const Setup& setup);

// The first side is a window.

/// A box or a point, and anything in one dimension: on every axis between the faces, half extents added.
ContactSet window_box_set(const Setup& setup);
/// A disc or ball: Euclidean from the window to the surface.
ContactSet window_ball_set(const Setup& setup);
/// An upright cylinder: a rounded rectangle in x and y, an interval along z.
ContactSet window_cylinder_set(const Setup& setup);

}  // namespace foresee
