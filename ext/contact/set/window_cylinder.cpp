#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"
#include "contact/set/sizes_of_both.h"

namespace foresee {

ContactSet window_cylinder_set(const Setup& setup) {
  ContactSet set;
  std::vector<Faces> faces = faces_of_window(set, setup);
  const Faces along_z = grown_faces(set, faces[2], height_of_both(set, setup, 0));
  faces.pop_back();
  add_rounded_box(set, faces, radius_of_both(set, setup, 0), &along_z);
  return set;
}

}  // namespace foresee
