// The contact set of a pair of tables as Minkowski sums of boxes, balls, cylinders and windows, made from the
// rule of their distance (pair_rule.h).
//
//   const ContactSet set = contact_set(setup);                          // of the rule's distance
//   const Size radius = size_of_both(own, setup, setup.rule.radius);    // r_a + r_b + within, and both growths
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

#include "contact/minkowski/contact_set.h"
#include "contact/minkowski/relative_motion.h"

namespace foresee {

/// The contact set of the setup: between its tables, or between its window and the second table. Requires:
/// neither has outlines or meshes.
ContactSet contact_set(const Setup& setup);

/// A size of the rule, with its growth, as lengths of a set.
Size size_of_both(ContactSet& set, const Setup& setup, const PairSize& size);

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
