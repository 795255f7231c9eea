// What must hold whatever the numbers are: a mesh that is a box is that box, one that is a prism that prism;
// exchanging, mirroring and turning change nothing; a surface is the union of its triangles.
#include <gtest/gtest.h>

#include "contact/case_count.h"
#include "contact/mesh/mesh_scenes.h"
#include "contact/outline/outline_scenes.h"

namespace foresee::contact {
namespace {

using namespace testing_by_hand;

constexpr MeshPairing all_pairings[] = {MeshPairing::meshes, MeshPairing::mesh_and_point,
                                        MeshPairing::mesh_and_box, MeshPairing::mesh_and_ball};

void expect_same(const std::optional<ContactTimes>& one, const std::optional<ContactTimes>& other,
                 const std::string& what) {
  ASSERT_EQ(one.has_value(), other.has_value()) << what;
  if (!one) return;
  ASSERT_EQ(one->dt, other->dt) << what;
  ASSERT_EQ(one->t, other->t) << what;
  ASSERT_EQ(one->dt_end, other->dt_end) << what;
  ASSERT_EQ(one->t_end, other->t_end) << what;
}

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
  for_each_scene(scaled_count(4), [](const MeshScene& scene, const std::optional<ContactTimes>& answer) {
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
  for_each_scene(scaled_count(4), [](MeshScene scene, const std::optional<ContactTimes>& answer) {
    if (!answer) return;
    scene.question.within += 0x1p-300;
    const auto grown = mesh_contact(scene);
    ASSERT_TRUE(grown.has_value());
    EXPECT_LE(grown->dt, answer->dt);
  });
}

TEST(MeshLaws, ASurfaceIsTouchedWhenTheFirstOfItsTrianglesIs) {
  for_each_scene(scaled_count(2), [](MeshScene scene, const std::optional<ContactTimes>& /*of a solid*/) {
    const Mesh mesh = scene.a.mesh;
    const auto as_surface = [&](std::span<const shape::Triangle> triangles) {
      Triangles all;
      for (const shape::Triangle& t : triangles)
        all.push_back({mesh.corners()[t[0]], mesh.corners()[t[1]], mesh.corners()[t[2]]});
      scene.a.mesh = surface_of(all);
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

/// Halves of whole numbers, so that touches, ties and grazes come up; or any.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed), whole_(seed % 3 != 0) {}

  double operator()(double range) {
    const double any = std::uniform_real_distribution<double>(-range, range)(random_);
    return whole_ ? std::round(2 * any) / 2 : any;
  }
  bool often() { return random_() % 2 == 0; }

 private:
  std::mt19937_64 random_;
  bool whole_;
};

Object moving_object(Numbers& number, Shape shape, bool bent) {
  Object o = object(3, shape);
  if (!bent) o.layout.law = Law::uniform;
  for (int j = 0; j < 3; ++j) {
    o.x[j] = number(4), o.v[j] = number(2), o.a[j] = bent ? number(2) : 0;
    o.half[j] = std::abs(number(3));
  }
  return o;
}

MeshObject as_mesh(const Object& box) {
  const double x = box.half[0], y = box.half[1], z = box.half[2];
  MeshObject o{box, solid_of(box_between({-x, -y, -z}, {x, y, z}))};
  o.row.layout.shape = Shape::mesh;
  o.row.layout.has_radius = true;
  return o;
}

/// A box and an object of `shape`: as they are, and with the box as a mesh, or both.
void compare_boxes(Shape shape, bool grown, int cases) {
  int contacts = 0;
  for (int seed = 0; seed < cases; ++seed) {
    Numbers number(static_cast<std::uint64_t>(seed));
    const bool bent = number.often();
    Object box = moving_object(number, Shape::box, bent), other = moving_object(number, shape, bent);
    for (double& half : box.half) half += 0.5;
    for (double& half : other.half) half += 0.5;
    ContactQuestion question{.horizon = {.now = 0, .h = 6}};
    if (grown) other.r = std::abs(number(2)), question.within = std::abs(number(1));
    const auto expected = contact(box, other, question);
    contacts += expected.has_value();
    const std::string what = "seed " + std::to_string(seed);
    const MeshObject mesh = as_mesh(box);
    ASSERT_NO_FATAL_FAILURE(expect_same(expected, mesh_contact({mesh, {other, {}}, question}), what));
    ASSERT_NO_FATAL_FAILURE(expect_same(expected, mesh_contact({{other, {}}, mesh, question}), what));
    if (shape != Shape::box) continue;
    ASSERT_NO_FATAL_FAILURE(expect_same(expected, mesh_contact({mesh, as_mesh(other), question}), what));
  }
  EXPECT_GT(contacts, cases / 10);
}

TEST(MeshLaws, AMeshThatIsABoxMeetsPointsAsTheBoxDoes) {
  compare_boxes(Shape::point, false, scaled_count(400));
}
TEST(MeshLaws, AMeshThatIsABoxMeetsBoxesAsTheBoxDoes) {
  compare_boxes(Shape::box, false, scaled_count(400));
}
TEST(MeshLaws, AMeshThatIsABoxMeetsBallsAsTheBoxDoes) {
  compare_boxes(Shape::ball, true, scaled_count(400));
}

/// An outline with a reflex corner, around the origin.
std::vector<shape::Corner> arrow(Numbers& number) {
  const double w = 1 + std::abs(number(3)), h = 1 + std::abs(number(3));
  return {{0, 0}, {w, -h}, {0, 2 * h}, {-w, -h}};
}

/// As an upright prism, and as a mesh.
struct Upright {
  OutlinedObject prism;
  MeshObject mesh;
};

Upright upright(Numbers& number, bool bent) {
  Object row = moving_object(number, Shape::cylinder, bent);
  row.hz = 0.5 + row.half[2];
  const std::vector<shape::Corner> ring = arrow(number);
  Ring numbers;
  for (const shape::Corner& corner : ring) numbers.push_back(corner.x), numbers.push_back(corner.y);
  Upright both{{row, outline_of({{numbers}})}, {row, solid_of(prism(ring, ring[0], -row.hz, row.hz))}};
  both.mesh.row.layout.shape = Shape::mesh;
  both.mesh.row.layout.has_radius = true;
  return both;
}

TEST(MeshLaws, AMeshThatIsAPrismMeetsOthersAsThePrismDoes) {
  const int cases = scaled_count(400);
  int contacts = 0;
  for (int seed = 0; seed < cases; ++seed) {
    Numbers number(static_cast<std::uint64_t>(seed));
    const bool bent = number.often();
    const Upright a = upright(number, bent), b = upright(number, bent);
    const ContactQuestion question{.horizon = {.now = 0, .h = 6}};
    const auto expected = outline_contact({a.prism, b.prism, question});
    contacts += expected.has_value();
    ASSERT_NO_FATAL_FAILURE(
        expect_same(expected, mesh_contact({a.mesh, b.mesh, question}), "seed " + std::to_string(seed)));
  }
  EXPECT_GT(contacts, cases / 10);
}

}  // namespace
}  // namespace foresee::contact
