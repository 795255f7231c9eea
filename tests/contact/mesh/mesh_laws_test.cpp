// What must hold whatever the numbers are: exchanging, mirroring and turning change nothing; a surface is the
// union of its triangles; it does not matter who is grown.
#include <gtest/gtest.h>

#include <algorithm>

#include "contact/case_count.h"
#include "contact/mesh/meshes_by_hand.h"

namespace foresee::contact {
namespace {

using namespace testing_by_hand;

constexpr MeshPairing all_pairings[] = {MeshPairing::meshes, MeshPairing::mesh_and_point,
                                        MeshPairing::mesh_and_box, MeshPairing::mesh_and_ball};

/// Draws scenes of all families, some of them grown and accelerated.
template <class Check>
void for_each_scene(int seeds, Check&& check) {
  for (MeshFamily family : mesh_families())
    for (const MeshPairing pairing : all_pairings)
      for (int seed = 1000; seed < 1000 + seeds; ++seed) {
        family.bent = seed % 3 == 0;
        MeshScene scene = draw_scene(family, pairing, static_cast<std::uint64_t>(seed));
        if (seed % 2 == 0) scene.question.within = std::ldexp(0.5, family.scale);
        ASSERT_NO_FATAL_FAILURE(check(scene, mesh_contact(scene)))
            << family.name << " pairing " << static_cast<int>(pairing) << " seed " << seed << '\n'
            << described(scene);
      }
}

/// The axes of a scene in another order, and each multiplied: new axis j is axis order[j] of the old.
struct Change {
  int order[3] = {0, 1, 2};
  double factor[3] = {1, 1, 1};

  SpaceCorner operator()(const SpaceCorner& c) const {
    const double old[3] = {c.x, c.y, c.z};
    double out[3];
    for (int j = 0; j < 3; ++j) out[j] = factor[j] * old[order[j]] + 0.0;
    return {out[0], out[1], out[2]};
  }
  void apply(double (&list)[3]) const {
    const SpaceCorner out = (*this)({list[0], list[1], list[2]});
    list[0] = out.x, list[1] = out.y, list[2] = out.z;
  }
};

MeshScene changed(MeshScene scene, const Change& change) {
  const double unit = std::abs(change.factor[0]);
  for (MeshObject* o : {&scene.a, &scene.b}) {
    for (auto* list : {&o->row.x, &o->row.v, &o->row.a, &o->row.half}) change.apply(*list);
    for (double& half : o->row.half) half = std::abs(half);
    o->row.r *= unit;
    o->mesh = mapped(o->mesh, change);
  }
  scene.question.within *= unit;
  return scene;
}

TEST(MeshLaws, ExchangingTheTwoChangesNothing) {
  for_each_scene(scaled_count(2), [](const MeshScene& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, mesh_contact({scene.b, scene.a, scene.question}), "exchanged");
  });
}

TEST(MeshLaws, AMirrorChangesNothing) {
  for_each_scene(scaled_count(2), [](const MeshScene& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, mesh_contact(changed(scene, {{0, 1, 2}, {-1, 1, 1}})), "mirrored in x");
    expect_same(answer, mesh_contact(changed(scene, {{0, 1, 2}, {1, 1, -1}})), "mirrored in z");
  });
}

TEST(MeshLaws, AQuarterTurnChangesNothing) {
  for_each_scene(scaled_count(2), [](const MeshScene& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, mesh_contact(changed(scene, {{1, 0, 2}, {1, -1, 1}})), "turned around z");
    expect_same(answer, mesh_contact(changed(scene, {{1, 2, 0}, {1, 1, 1}})), "axes exchanged");
  });
}

TEST(MeshLaws, LengthsInAnotherUnitChangeNothing) {
  const auto factors = [](double factor) -> Change { return {{0, 1, 2}, {factor, factor, factor}}; };
  for_each_scene(scaled_count(2), [&](const MeshScene& scene, const std::optional<ContactTimes>& answer) {
    expect_same(answer, mesh_contact(changed(scene, factors(0x1p20))), "scaled");
    // Where squares vanish, what is near is left to exact numbers. Of a subnormal number digits would.
    for (const double x : scene.b.row.x)
      if (x != 0 && std::abs(x) < 0x1p-700) return;
    expect_same(answer, mesh_contact(changed(scene, factors(0x1p-290))), "made small");
  });
}

TEST(MeshLaws, TimeInAnotherUnitChangesNothing) {
  for_each_scene(scaled_count(2), [](MeshScene scene, const std::optional<ContactTimes>& answer) {
    for (const double unit : {0x1p12, 0x1p-12}) {
      MeshScene other = scene;
      other.question.horizon.now *= unit, other.question.horizon.h *= unit;
      for (MeshObject* o : {&other.a, &other.b}) {
        o->row.t *= unit, o->row.until *= unit;
        for (double& v : o->row.v) v /= unit;
        for (double& a : o->row.a) a /= unit * unit;
      }
      auto found = mesh_contact(other);
      if (found)
        for (double* time : {&found->t, &found->dt, &found->t_end, &found->dt_end}) *time /= unit;
      expect_same(answer, found, "in another unit of time");
    }
  });
}

TEST(MeshLaws, AGreaterDistanceIsReachedNoLater) {
  for_each_scene(scaled_count(2), [](MeshScene scene, const std::optional<ContactTimes>& answer) {
    if (!answer) return;
    scene.question.within += 0x1p-300;
    const auto grown = mesh_contact(scene);
    ASSERT_TRUE(grown.has_value());
    EXPECT_LE(grown->dt, answer->dt);
  });
}

Mesh surface_of_some(const Mesh& mesh, std::span<const shape::Triangle> triangles) {
  Triangles some;
  for (const shape::Triangle& t : triangles)
    some.push_back({mesh.corners()[t[0]], mesh.corners()[t[1]], mesh.corners()[t[2]]});
  return surface_of(some);
}

TEST(MeshLaws, ASurfaceIsTouchedWhenTheFirstOfItsTrianglesIs) {
  for_each_scene(scaled_count(2), [](MeshScene scene, const std::optional<ContactTimes>& /*of a solid*/) {
    const Mesh mesh = scene.a.mesh;
    const auto as_surface = [&](std::span<const shape::Triangle> triangles) {
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

/// The end of the first of all stays together; those that begin when another ends belong to it or not.
double joined_end(std::vector<ContactTimes> stays, bool touching_joins) {
  std::sort(stays.begin(), stays.end(), [](const auto& s, const auto& t) { return s.dt < t.dt; });
  double end = stays[0].dt_end;
  for (const ContactTimes& s : stays)
    if (s.dt < end || (touching_joins && s.dt == end)) end = std::max(end, s.dt_end);
  return end;
}

TEST(MeshLaws, ContactWithASurfaceEndsWhenThatWithItsTrianglesDoes) {
  // A triangle meets what is convex and moves steadily once.
  for (const MeshFamily& family : mesh_families())
    for (const MeshPairing pairing : {MeshPairing::mesh_and_box, MeshPairing::mesh_and_ball})
      for (int seed = 2000; seed < 2000 + scaled_count(2); ++seed) {
        MeshScene scene = draw_scene(family, pairing, static_cast<std::uint64_t>(seed));
        if (seed % 2 == 0) scene.question.within = std::ldexp(0.5, family.scale);
        std::vector<ContactTimes> stays;
        const Mesh mesh = scene.a.mesh;
        for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
          scene.a.mesh = surface_of_some(mesh, mesh.triangles().subspan(t, 1));
          if (const auto found = mesh_contact(scene)) stays.push_back(*found);
        }
        scene.a.mesh = surface_of_some(mesh, mesh.triangles());
        const auto whole = mesh_contact(scene);
        ASSERT_EQ(whole.has_value(), !stays.empty()) << family.name << " seed " << seed;
        if (!whole) continue;
        // Two that are apart may round to one double.
        const bool is_end =
            whole->dt_end == joined_end(stays, false) || whole->dt_end == joined_end(stays, true);
        ASSERT_TRUE(is_end) << family.name << " seed " << seed;
      }
}

TEST(MeshLaws, WhicheverIsGrownTheDistanceIsTheSame) {
  for_each_scene(scaled_count(2), [](MeshScene scene, const std::optional<ContactTimes>& answer) {
    std::swap(scene.a.row.r, scene.question.within);
    expect_same(answer, mesh_contact(scene), "a grown");
    if (scene.b.row.layout.shape != Shape::mesh) return;
    std::swap(scene.a.row.r, scene.b.row.r);
    expect_same(answer, mesh_contact(scene), "b grown");
  });
}

TEST(MeshLaws, WhatHasNoMeshIsABall) {
  for_each_scene(scaled_count(2), [](MeshScene scene, const std::optional<ContactTimes>& /*with a mesh*/) {
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
}  // namespace foresee::contact
