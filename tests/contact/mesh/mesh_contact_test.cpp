// Contact of meshes against the judge in whole numbers: the decision, and both times to the last bit.
#include <gtest/gtest.h>

#include "contact/case_count.h"
#include "contact/mesh/mesh_oracle.h"
#include "contact/mesh/mesh_scenes.h"

namespace foresee {
namespace {

using namespace testing_by_hand;
using oracle::Body;
using oracle::Encounter;
using oracle::Rational;
using oracle::RationalInterval;
using oracle::SpacePlace;

Body body_of(const MeshObject& o) {
  if (!o.mesh.triangles().empty()) return oracle::body_of(o.mesh);
  return oracle::box_body(o.row.half[0], o.row.half[1], o.row.half[2]);
}

Encounter encounter_of(const MeshScene& scene) {
  return {scene.a.row, scene.b.row, scene.question};
}

SpacePlace place_at(const Encounter& encounter, const Rational& time) {
  return {encounter.place(0, time), encounter.place(1, time), encounter.place(2, time)};
}

/// Empty if the answer is right, else what is wrong.
std::string judged(const MeshScene& scene, const std::optional<ContactTimes>& answer) {
  const Encounter encounter = encounter_of(scene);
  const RationalInterval queried = encounter.queried();
  const SpacePlace velocity{encounter.velocity(0), encounter.velocity(1), encounter.velocity(2)};
  std::optional<RationalInterval> exact;
  if (queried.begin <= queried.end)
    exact =
        oracle::first_contact(body_of(scene.a), body_of(scene.b), place_at(encounter, 0), velocity, queried);
  return oracle::compared(exact, answer, scene.question.horizon.now);
}

/// The same, of any radius and motion.
std::string judged_by_times(const MeshScene& scene, const std::optional<ContactTimes>& answer) {
  const Encounter encounter = encounter_of(scene);
  const Body a = body_of(scene.a), b = body_of(scene.b);
  const auto touch = [&](const Rational& time) {
    return oracle::touch_at(a, b, place_at(encounter, time), encounter.radius(time));
  };
  return oracle::judged_by_times(touch, scene.question.horizon.h, answer);
}

TEST(MeshContact, IsThatOfRationalNumbers) {
  int cases = 0, contacts = 0;
  for (const MeshFamily& family : mesh_families())
    for (const auto pairing : {MeshPairing::meshes, MeshPairing::mesh_and_point, MeshPairing::mesh_and_box})
      for (int seed = 0; seed < scaled_count(pairing == MeshPairing::mesh_and_point ? 24 : 8); ++seed) {
        const MeshScene scene = draw_scene(family, pairing, static_cast<std::uint64_t>(seed));
        if (scene.question.within > 0) continue;  // judged below
        const auto answer = mesh_contact(scene);
        ++cases, contacts += answer.has_value();
        ASSERT_EQ(judged(scene, answer), "")
            << family.name << " pairing " << static_cast<int>(pairing) << " seed " << seed << '\n'
            << described(scene);
      }
  EXPECT_GE(3 * contacts, cases);
}

TEST(MeshContact, OfAnyRadiusAndMotionIsRightAtEveryTime) {
  int cases = 0, contacts = 0;
  for (MeshFamily family : mesh_families())
    for (const auto pairing : {MeshPairing::meshes, MeshPairing::mesh_and_point, MeshPairing::mesh_and_box,
                               MeshPairing::mesh_and_ball})
      for (int seed = 0; seed < scaled_count(4); ++seed) {
        family.bent = seed % 2 == 1;
        if (family.lives || family.ages > 100) continue;
        MeshScene scene = draw_scene(family, pairing, static_cast<std::uint64_t>(seed));
        const double unit = std::ldexp(1.0, family.scale);
        if (seed % 3 > 0 && scene.question.within == 0) scene.question.within = unit * (seed % 5) / 2;
        if (seed % 5 == 2) scene.a.row.r = unit / 4;
        if (!family.bent && encounter_of(scene).radius(0) == 0) continue;  // judged above
        const auto answer = mesh_contact(scene);
        ++cases, contacts += answer.has_value();
        ASSERT_EQ(judged_by_times(scene, answer), "")
            << family.name << " pairing " << static_cast<int>(pairing) << " seed " << seed << '\n'
            << described(scene);
      }
  EXPECT_GE(3 * contacts, cases);
}

TEST(MeshContact, EndsThoughTheNextStartsWithinAnUlp) {
  for (MeshFamily family : mesh_families()) {
    if (std::string(family.name) != "across a face") continue;
    family.bent = true;
    const MeshScene scene = draw_scene(family, MeshPairing::meshes, 75);
    const Encounter encounter = encounter_of(scene);
    const auto touch = [&](int ulps_by_64) {
      const Rational time = 5 + Rational(ulps_by_64) * Rational(0x1p-56);
      return oracle::touch_at(body_of(scene.a), body_of(scene.b), place_at(encounter, time), 0);
    };
    EXPECT_FALSE(touch(-1));
    EXPECT_TRUE(touch(0) && touch(11));
    EXPECT_FALSE(touch(12) || touch(31));
    EXPECT_TRUE(touch(32) && touch(64));
    const auto answer = mesh_contact(scene);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->dt, 5);
    EXPECT_EQ(answer->dt_end, 5);
    EXPECT_EQ(judged_by_times(scene, answer), "");
    return;
  }
  FAIL() << "no such family";
}

}  // namespace
}  // namespace foresee
