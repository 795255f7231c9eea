// A moving window meets a mesh as the box between its faces does; a face that is not there is one far away.
#include <gtest/gtest.h>

#include "contact/case_count.h"
#include "contact/mesh/mesh_scenes.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

/// Farther off than any object of a scene comes, of which a double holds the sum with what is near.
constexpr double far_off = 0x1p20;

/// The box between the faces, from `now` on.
MeshObject box_between_faces(const WindowFaces& faces, double now) {
  MeshObject box = box_object({1, 1, 1});
  box.row.t = now;
  for (int j = 0; j < 3; ++j) {
    const auto axis = static_cast<std::size_t>(j);
    const double lower = faces.has_lower(j) ? faces.lower[axis] : -far_off;
    const double upper = faces.has_upper(j) ? faces.upper[axis] : far_off;
    box.row.x[j] = (lower + upper) / 2, box.row.half[j] = (upper - lower) / 2;
    box.row.v[j] = faces.velocity[axis];
  }
  return box;
}

TEST(MeshWindow, IsTheBoxBetweenItsFaces) {
  std::mt19937_64 random(3);
  const auto half_of_whole = [&random](int range) {
    return std::uniform_int_distribution<int>(-2 * range, 2 * range)(random) / 2.0;
  };
  int contacts = 0;
  for (MeshFamily family : mesh_families()) {
    if (family.offset != 0 || family.scale != 0) continue;
    for (int seed = 0; seed < scaled_count(20); ++seed) {
      family.bent = seed % 3 == 0;
      const MeshScene scene = draw_scene(family, MeshPairing::meshes, static_cast<std::uint64_t>(seed));
      WindowFaces faces;
      for (std::size_t j = 0; j < 3; ++j) {
        const double one = half_of_whole(6), other = half_of_whole(6);
        if (random() % 4 != 0) faces.lower[j] = std::min(one, other);
        if (random() % 4 != 0) faces.upper[j] = std::max(one, other);
        faces.velocity[j] = half_of_whole(2);
      }
      const Horizon horizon = scene.question.horizon;
      const auto expected =
          mesh_contact({box_between_faces(faces, horizon.now), scene.a, {.horizon = horizon}});
      const auto found = mesh_in_window(faces, scene.a, horizon);
      contacts += found.has_value();
      const std::string what = std::string(family.name) + " seed " + std::to_string(seed);
      ASSERT_EQ(found.has_value(), expected.has_value()) << what;
      if (!found) continue;
      ASSERT_EQ(found->dt, expected->dt) << what;
      ASSERT_EQ(found->t, expected->t) << what;
      ASSERT_EQ(found->dt_end, expected->dt_end) << what;
      ASSERT_EQ(found->t_end, expected->t_end) << what;
    }
  }
  EXPECT_GT(contacts, scaled_count(100));
}

TEST(MeshWindow, OfNoFacesIsMetAtOnce) {
  const MeshObject object = moving(ball_object(0, true), {1e300, 0, 0}, {1, 2, 3});
  const auto met = mesh_in_window({}, object, {.now = 0, .h = 10});
  ASSERT_TRUE(met.has_value());
  EXPECT_EQ(met->dt, 0);
  EXPECT_EQ(met->dt_end, 10);
}

TEST(MeshWindow, WithAnOutlineHasNoDistance) {
  const MeshObject object = ball_object(1, true);
  const std::vector<double> row = object.row.row();
  const Bodies bodies(object.row.layout, row.data(), 1);
  Outline square;
  square.begin_part();
  for (const Corner& corner : {Corner{0, 0}, Corner{1, 0}, Corner{1, 1}, Corner{0, 1}}) square.add(corner);
  const MovingWindow zone({}, bodies.layout, 0, std::make_shared<const SharedOutline>(square));
  EXPECT_THROW(make_window_contact(zone, bodies, {0, 1}), Error);
}

}  // namespace
}  // namespace foresee
