// Boxes as conditions on where the other centre is, and boxes grown by R in the Euclidean sense. A face may
// be missing, as of windows that are open to one side.
//
// A grown box is the union of simpler sets; each lies inside it, and together they are it: the box grown
// along one axis, for every axis; in three dimensions a cylinder around every edge; a ball around every
// corner.
#pragma once

#include <vector>

#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"

namespace foresee {

/// Of every axis of the two tables: the box of both around the centre, `within` not added.
std::vector<Faces> faces_of_boxes(ContactSet& set, const Setup& setup);
/// The faces of the setup's window.
std::vector<Faces> faces_of_window(ContactSet& set, const Setup& setup);
/// Faces moved outward by a length.
Faces grown_faces(ContactSet& set, Faces faces, const Size& length);

/// The set of one piece, between the faces.
void add_box(ContactSet& set, std::span<const Faces> faces);

/// The bounds of faces.
std::vector<int> between(ContactSet& set, std::span<const Faces> faces);

/// Pieces and hull of the box between the faces grown by `radius`, on the axes of the faces; every piece also
/// lies between `along_z`, if given. Requires: two or three axes.
void add_rounded_box(ContactSet& set, std::span<const Faces> faces, const Size& radius,
                     const Faces* along_z = nullptr);

}  // namespace foresee
