// Meshes by hand: a few shapes to meet, and the answer about them within ten seconds.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "contact/mesh/mesh_scenes.h"

namespace foresee::testing_by_hand {

inline const Mesh unit_cube = solid_of(box_between({0, 0, 0}, {1, 1, 1}));
/// Level ground at 0.
inline const Mesh ground =
    surface_of({{{{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}}}, {{{-10, -10, 0}, {10, 10, 0}, {-10, 10, 0}}}});

inline double after(double x) {
  return std::nextafter(x, HUGE_VAL);
}
inline double before(double x) {
  return std::nextafter(x, -HUGE_VAL);
}

inline MeshObject moving_cube(const SpaceCorner& place, const SpaceCorner& velocity) {
  return moving(resting(unit_cube), place, velocity);
}
inline MeshObject moving_point(const SpaceCorner& place, const SpaceCorner& velocity) {
  return moving(box_object({0, 0, 0}), place, velocity);
}
inline MeshObject moving_box(const SpaceCorner& half, const SpaceCorner& place, const SpaceCorner& velocity) {
  return moving(box_object(half), place, velocity);
}
inline MeshObject moving_ball(double r, const SpaceCorner& place, const SpaceCorner& velocity) {
  return moving(ball_object(r, false), place, velocity);
}

inline std::optional<ContactTimes> within_ten(const MeshObject& a, const MeshObject& b, double within = 0) {
  return mesh_contact({a, b, {.horizon = {.now = 0, .h = 10}, .within = within}});
}
inline std::optional<ContactTimes> within_ten(const Mesh& a, const MeshObject& b, double within = 0) {
  return within_ten(resting(a), b, within);
}

inline void expect_contact(const std::optional<ContactTimes>& found, double t, double t_end) {
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->t, t);
  EXPECT_EQ(found->t_end, t_end);
}

}  // namespace foresee::testing_by_hand
