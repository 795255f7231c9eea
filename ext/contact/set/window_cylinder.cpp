#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"

namespace foresee::contact {

ContactSet window_cylinder_set(const Setup& setup) {
  ContactSet set;
  std::vector<Faces> faces = faces_of_window(set, setup);
  const Faces along_z = grown(set, faces[2], set.in_both(setup.a.at.hz, setup.b.at.hz));
  faces.pop_back();
  add_rounded_box(set, faces, set.in_both(setup.a.at.r, setup.b.at.r), &along_z);
  return set;
}

}  // namespace foresee::contact
