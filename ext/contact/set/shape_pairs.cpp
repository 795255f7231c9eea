#include "contact/set/shape_pairs.h"

#include "contact/set/minkowski_sum.h"

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

ContactSet ball_ball_set(const Setup& setup) {
  ContactSet set;
  add_ball(set, setup.a.layout.axes, radius_of_both(set, setup, setup.within));
  return set;
}

ContactSet box_ball_set(const Setup& setup) {
  ContactSet set;
  add_rounded_box(set, faces_of_boxes(set, setup), radius_of_both(set, setup, setup.within));
  return set;
}

ContactSet cylinder_cylinder_set(const Setup& setup) {
  ContactSet set;
  const Size radius = radius_of_both(set, setup, setup.within),
             height = height_of_both(set, setup, setup.within_z);
  const Faces along_z{.axis = 2, .below = height, .above = height};
  add_ball(set, 2, radius, &along_z);
  return set;
}

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

ContactSet window_box_set(const Setup& setup) {
  ContactSet set;
  const std::vector<Faces> boxes = faces_of_boxes(set, setup);
  // In one dimension a ball is an interval.
  const Size ball = setup.a.layout.axes == 1 ? radius_of_both(set, setup, 0) : Size{};
  std::vector<Faces> faces = faces_of_window(set, setup);
  for (Faces& f : faces)
    f = grown_faces(set, f, set.sum(boxes[static_cast<std::size_t>(f.axis)].above, ball));
  add_box(set, faces);
  return set;
}

ContactSet window_ball_set(const Setup& setup) {
  ContactSet set;
  add_rounded_box(set, faces_of_window(set, setup), radius_of_both(set, setup, 0));
  return set;
}

ContactSet window_cylinder_set(const Setup& setup) {
  ContactSet set;
  std::vector<Faces> faces = faces_of_window(set, setup);
  const Faces along_z = grown_faces(set, faces[2], height_of_both(set, setup, 0));
  faces.pop_back();
  add_rounded_box(set, faces, radius_of_both(set, setup, 0), &along_z);
  return set;
}

}  // namespace foresee
