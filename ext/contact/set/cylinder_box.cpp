#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"
#include "contact/set/sizes_of_both.h"

namespace foresee {

ContactSet cylinder_box_set(const Setup& setup) {
  ContactSet set;
  const Size radius = radius_of_both(set, setup, setup.within),
             height = height_of_both(set, setup, setup.within_z);
  std::vector<Faces> faces = faces_of_boxes(set, setup);
  const Faces along_z = grown_faces(set, faces[2], height);
  faces.pop_back();
  add_rounded_box(set, faces, radius, &along_z);
  return set;
}

}  // namespace foresee
