#include "contact/set/rounded_box.h"
#include "contact/set/shape_pairs.h"
#include "contact/set/sizes_of_both.h"

namespace foresee {

ContactSet box_box_set(const Setup& setup) {
  ContactSet set;
  // In one dimension a ball is an interval.
  const Size more =
      setup.a.layout.axes == 1 ? radius_of_both(set, setup, setup.within) : Size{set.given(setup.within)};
  std::vector<Faces> faces = faces_of_boxes(set, setup);
  for (Faces& f : faces) f = grown_faces(set, f, more);
  add_box(set, faces);
  return set;
}

}  // namespace foresee
