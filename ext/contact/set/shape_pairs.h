// The contact set of each pair of shapes, made once per statement from the declarations of the two tables and
// the distances of the query. The numbers of a pair are read later.
#pragma once

#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"

namespace foresee {

/// Two boxes, points that coincide, and all shapes on one axis: on every axis |x| <= H.
ContactSet box_box_set(const Setup& setup);
/// Two discs or balls, or points that come within a distance: the Euclidean |x| <= R, where R is the sum of
/// both radii and the distance.
ContactSet ball_ball_set(const Setup& setup);
/// A box and a disc, ball, or point that comes within a distance: Euclidean from box to surface.
ContactSet box_ball_set(const Setup& setup);
/// Two upright cylinders; a point is a cylinder of size 0: a disc in x and y, and an interval along z.
ContactSet cylinder_cylinder_set(const Setup& setup);
/// An upright cylinder (or a point as one of size 0) and a box: a rounded rectangle in x and y, an interval
/// along z.
ContactSet cylinder_box_set(const Setup& setup);

// The first table is a window.

/// A box or a point, and all shapes on one axis: on every axis between the faces, half extents added.
ContactSet window_box_set(const Setup& setup);
/// A disc or ball: Euclidean from window to surface.
ContactSet window_ball_set(const Setup& setup);
/// An upright cylinder: a rounded rectangle in x and y, an interval along z.
ContactSet window_cylinder_set(const Setup& setup);

}  // namespace foresee
