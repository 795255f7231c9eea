// Laws of contact between meshes: rotation and mirroring change nothing. A surface is the union of its
// triangles. It does not matter which object is grown. Laws that outlines share: form_laws_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>

#include "contact/form_laws.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

TEST(MeshLaws, AMirrorInZChangesNothing) {
  for_each_scene<MeshForms>([](const MeshScene& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, mesh_contact(changed(scene, {{0, 1, 2}, {1, 1, -1}})), "mirrored in z");
  });
}

TEST(MeshLaws, AQuarterTurnChangesNothing) {
  for_each_scene<MeshForms>([](const MeshScene& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, mesh_contact(changed(scene, {{1, 0, 2}, {1, -1, 1}})), "turned around z");
    expect_same(answer, mesh_contact(changed(scene, {{1, 2, 0}, {1, 1, 1}})), "axes exchanged");
  });
}

Mesh surface_of_some(const Mesh& mesh, std::span<const Triangle> triangles) {
  Triangles some;
  for (const Triangle& t : triangles)
    some.push_back({mesh.corners()[t[0]], mesh.corners()[t[1]], mesh.corners()[t[2]]});
  return surface_of(some);
}

TEST(MeshLaws, ContactOfASurfaceStartsWithItsFirstTriangle) {
  for_each_scene<MeshForms>([](MeshScene scene, const std::optional<ContactTimes>& /*of a solid*/) {
    const Mesh mesh = scene.a.mesh;
    const auto as_surface = [&](std::span<const Triangle> triangles) {
      scene.a.mesh = surface_of_some(mesh, triangles);
      return mesh_contact(scene);
    };
    const auto whole = as_surface(mesh.triangles());
    std::optional<ContactTimes> first;
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
      const auto found = as_surface(mesh.triangles().subspan(t, 1));
      if (found && !(first && first->dt <= found->dt)) first = found;
    }
    ASSERT_EQ(first.has_value(), whole.has_value());
    if (!first) return;
    ASSERT_EQ(first->dt, whole->dt);
    EXPECT_EQ(first->t, whole->t);
    EXPECT_LE(first->dt_end, whole->dt_end);
  });
}

/// Whether the first interval of the union may end at `end`. It may wherever an interval starts at the double at which
/// those before it end: two that are apart may round to one double.
bool may_end_at(double end, std::vector<ContactTimes> intervals) {
  std::sort(intervals.begin(), intervals.end(), [](const auto& s, const auto& t) { return s.dt < t.dt; });
  double last = intervals[0].dt_end;
  for (const ContactTimes& s : intervals) {
    if (last < s.dt || (s.dt == last && last == end)) break;
    last = std::max(last, s.dt_end);
  }
  return last == end;
}

TEST(MeshLaws, ContactWithASurfaceEndsWhenThatWithItsTrianglesDoes) {
  // A triangle meets what is convex and moves steadily once.
  for (const MeshFamily& family : mesh_families())
    for (const MeshPairing pairing : {MeshPairing::mesh_and_box, MeshPairing::mesh_and_ball})
      for (int seed = 2000; seed < 2000 + scaled_count(2); ++seed) {
        MeshScene scene = draw_scene(family, pairing, static_cast<std::uint64_t>(seed));
        if (seed % 2 == 0) scene.question.within = std::ldexp(0.5, family.scale);
        std::vector<ContactTimes> intervals;
        const Mesh mesh = scene.a.mesh;
        for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
          scene.a.mesh = surface_of_some(mesh, mesh.triangles().subspan(t, 1));
          if (const auto found = mesh_contact(scene)) intervals.push_back(*found);
        }
        scene.a.mesh = surface_of_some(mesh, mesh.triangles());
        const auto whole = mesh_contact(scene);
        ASSERT_EQ(whole.has_value(), !intervals.empty()) << family.name << " seed " << seed;
        if (!whole) continue;
        ASSERT_TRUE(may_end_at(whole->dt_end, intervals)) << family.name << " seed " << seed;
      }
}

TEST(MeshLaws, WhicheverIsGrownTheDistanceIsTheSame) {
  for_each_scene<MeshForms>([](MeshScene scene, const std::optional<ContactTimes>& answer) {
    std::swap(scene.a.row.r, scene.question.within);
    expect_same(answer, mesh_contact(scene), "a grown");
    if (scene.b.row.layout.shape != Shape::mesh) return;
    std::swap(scene.a.row.r, scene.b.row.r);
    expect_same(answer, mesh_contact(scene), "b grown");
  });
}

TEST(MeshLaws, WhatHasNoMeshIsABall) {
  for_each_scene<MeshForms>([](MeshScene scene, const std::optional<ContactTimes>& /*with a mesh*/) {
    Object a = scene.a.row, b = scene.b.row;
    if (!scene.b.mesh.triangles().empty()) return;
    scene.a.mesh = {};
    a.r = scene.a.row.r = 2 * scene.question.within;
    a.layout.shape = Shape::ball;
    if (b.layout.shape == Shape::mesh) b.layout.shape = Shape::ball;
    expect_same(contact(a, b, scene.question), mesh_contact(scene), "as balls");
  });
}

}  // namespace
}  // namespace foresee
