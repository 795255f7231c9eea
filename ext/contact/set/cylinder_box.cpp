#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"

namespace foresee::contact {

ContactSet cylinder_box_set(const Setup& setup) {
  ContactSet set;
  const int radius = set.sum(set.in_both(setup.a.at.r, setup.b.at.r), set.given(setup.within));
  const int height = set.sum(set.in_both(setup.a.at.hz, setup.b.at.hz), set.given(setup.within_z));
  std::vector<Faces> faces = faces_of_boxes(set, setup);
  const Faces along_z = grown(set, faces[2], height);
  faces.pop_back();
  add_rounded_box(set, faces, radius, &along_z);
  return set;
}

}  // namespace foresee::contact
