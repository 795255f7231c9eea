// What the laws of outlines and of meshes share: numbers, scenes, and one interface to both.
//
//   for_each_scene<MeshForms>([](const MeshScene& scene, const std::optional<ContactTimes>& answer) {
//     expect_same(answer, mesh_contact({scene.b, scene.a, scene.question}), "exchanged");
//   });
#pragma once

#include <gtest/gtest.h>

#include "contact/case_count.h"
#include "contact/mesh/meshes_by_hand.h"
#include "contact/outline/outline_scenes.h"

namespace foresee::testing_by_hand {

/// Halves of whole numbers, so that touches, ties and grazes come up; or any.
class DrawnNumbers {
 public:
  explicit DrawnNumbers(std::uint64_t seed) : random_(seed), whole_(seed % 3 != 0) {}

  double operator()(double range) {
    const double any = std::uniform_real_distribution<double>(-range, range)(random_);
    return whole_ ? std::round(2 * any) / 2 : any;
  }
  bool often() { return random_() % 2 == 0; }

 private:
  std::mt19937_64 random_;
  bool whole_;
};

inline void expect_same(const std::optional<ContactTimes>& one, const std::optional<ContactTimes>& other,
                        const std::string& what) {
  ASSERT_EQ(one.has_value(), other.has_value()) << what;
  if (!one) return;
  ASSERT_EQ(one->dt, other->dt) << what;
  ASSERT_EQ(one->t, other->t) << what;
  ASSERT_EQ(one->dt_end, other->dt_end) << what;
  ASSERT_EQ(one->t_end, other->t_end) << what;
}

inline OutlineScene changed(OutlineScene scene, Corner factor) {
  for (OutlinedObject* o : {&scene.a, &scene.b}) {
    for (double* list : {o->row.x, o->row.v, o->row.a}) list[0] *= factor.x, list[1] *= factor.y;
    o->row.half[0] *= std::abs(factor.x), o->row.half[1] *= std::abs(factor.y);
    o->outline = changed(o->outline, factor);
  }
  scene.question.within *= std::abs(factor.y);
  return scene;
}

/// The axes of a scene in another order, and each multiplied: new axis j is axis order[j] of the old.
struct MeshChange {
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

inline MeshScene changed(MeshScene scene, const MeshChange& change) {
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

struct OutlineForms {
  static constexpr const char* name = "outlines";
  static constexpr int seeds = 10;
  static constexpr OutlinePairing pairings[] = {OutlinePairing::outlines, OutlinePairing::outline_and_point,
                                                OutlinePairing::outline_and_box};

  static auto families() { return outline_families(); }
  static auto answer(const OutlineScene& scene) { return outline_contact(scene); }
  static std::vector<double> corner_numbers(const OutlineScene& scene) {
    std::vector<double> numbers;
    for (const OutlinedObject* o : {&scene.a, &scene.b})
      for (const Corner& corner : o->outline.corners()) numbers.insert(numbers.end(), {corner.x, corner.y});
    return numbers;
  }
  static OutlineScene mirrored(const OutlineScene& scene) { return changed(scene, {-1, 1}); }
  static OutlineScene scaled(const OutlineScene& scene, double unit) { return changed(scene, {unit, unit}); }
};

struct MeshForms {
  static constexpr const char* name = "meshes";
  static constexpr int seeds = 2;
  static constexpr MeshPairing pairings[] = {MeshPairing::meshes, MeshPairing::mesh_and_point,
                                             MeshPairing::mesh_and_box, MeshPairing::mesh_and_ball};

  static auto families() { return mesh_families(); }
  static auto answer(const MeshScene& scene) { return mesh_contact(scene); }
  static std::vector<double> corner_numbers(const MeshScene& scene) {
    std::vector<double> numbers;
    for (const MeshObject* o : {&scene.a, &scene.b})
      for (const SpaceCorner& c : o->mesh.corners()) numbers.insert(numbers.end(), {c.x, c.y, c.z});
    return numbers;
  }
  static MeshScene mirrored(const MeshScene& scene) { return changed(scene, {{0, 1, 2}, {-1, 1, 1}}); }
  static MeshScene scaled(const MeshScene& scene, double unit) {
    return changed(scene, {{0, 1, 2}, {unit, unit, unit}});
  }
};

/// check(scene, its answer) for scenes of all families, some of them grown and accelerated.
template <class Forms, class Check>
void for_each_scene(Check&& check) {
  for (auto family : Forms::families())
    for (const auto pairing : Forms::pairings)
      for (int seed = 1000; seed < 1000 + scaled_count(Forms::seeds); ++seed) {
        family.bent = seed % 3 == 0;
        auto scene = draw_scene(family, pairing, static_cast<std::uint64_t>(seed));
        if (seed % 2 == 0) scene.question.within = std::ldexp(0.5, family.scale);
        ASSERT_NO_FATAL_FAILURE(check(scene, Forms::answer(scene)))
            << family.name << " pairing " << static_cast<int>(pairing) << " seed " << seed << '\n'
            << described(scene);
      }
}

}  // namespace foresee::testing_by_hand
