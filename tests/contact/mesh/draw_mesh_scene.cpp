// How scenes of meshes are drawn.
#include <algorithm>
#include <cmath>

#include "contact/mesh/draw_mesh.h"
#include "shape/mesh/mesh.h"

namespace foresee::testing_by_hand {
namespace {

using Motion = MeshFamily::Motion;
using Cast = MeshFamily::Cast;

class DrawScene {
 public:
  DrawScene(const MeshFamily& family, MeshPairing pairing, std::uint64_t seed)
      : family_(family), pairing_(pairing), draw_(family, seed) {}

  MeshScene scene() {
    MeshScene scene;
    scene.question.horizon = {.now = family_.ages > 0 ? 100.0 : family_.now, .h = 8};
    heading_ = family_.turned < 0 ? std::abs(draw_.number(180)) : family_.turned;
    scene.a = mesh_object(true), scene.b = other_object();
    if (family_.bent) bend(scene);
    move(scene);
    scale(scene);
    return scene;
  }

 private:
  /// One, or both.
  void bend(MeshScene& scene) {
    const std::uint64_t which = draw_.below(4);
    for (MeshObject* o : {&scene.a, &scene.b}) {
      if (which == (o == &scene.a ? 0U : 1U)) continue;
      o->row.layout.law = Law::accelerated;
      for (double& a : o->row.a) a = draw_.number(1);
    }
  }

  MeshObject mesh_object(bool is_a) {
    MeshObject o = resting(turned(draw_.mesh(is_a), heading_));
    if (family_.turned < 0) heading_ = std::abs(draw_.number(180));
    return o;
  }

  MeshObject other_object() {
    if (pairing_ == MeshPairing::meshes) return mesh_object(false);
    MeshObject o = ball_object(0, draw_.below(2));
    if (pairing_ == MeshPairing::mesh_and_point && draw_.below(2)) o = box_object({0, 0, 0});
    if (pairing_ == MeshPairing::mesh_and_ball) o.row.r = draw_.above(0.25, 2);
    if (pairing_ == MeshPairing::mesh_and_box) {
      o = box_object({});
      o.row.layout.shape = Shape::box;
      for (double& half : o.row.half) half = draw_.below(8) ? std::abs(draw_.number(2)) : 0;
    }
    return o;
  }

  SpaceCorner corner_of(const MeshObject& o) {
    const auto corners = o.mesh.corners();
    if (!corners.empty()) return corners[draw_.below(corners.size())];
    const double* half = o.row.half;
    return {draw_.below(2) ? half[0] : -half[0], draw_.below(2) ? half[1] : -half[1],
            draw_.below(2) ? half[2] : -half[2]};
  }

  void move(MeshScene& scene) {
    Object &a = scene.a.row, &b = scene.b.row;
    const auto time = static_cast<double>(draw_.below(9));
    Meeting met = meeting(scene);
    met.velocity *= std::ldexp(1.0, family_.pace);
    for (int j = 0; j < 3; ++j) {
      // From that time back to now.
      const double bend = b.a[j] - a.a[j], velocity = met.velocity[j] - time * bend;
      const double place = met.place[j] - time * (velocity + time * bend / 2);
      a.x[j] = family_.offset + draw_.number(5), a.v[j] = draw_.number(2);
      b.x[j] = a.x[j] + place, b.v[j] = a.v[j] + velocity;
      for (auto i = family_.ulps > 0 ? draw_.below(family_.ulps + 1) : 0; i > 0; --i)
        b.x[j] = std::nextafter(b.x[j], draw_.below(2) ? 1e300 : -1e300);
    }
    const double t = family_.ages > 0 ? scene.question.horizon.now : 0;
    for (Object* o : {&a, &b}) {
      o->t = t;
      if (family_.ages > 0) age(*o, std::abs(draw_.number(family_.ages)));
      if (family_.lives) o->until = t + static_cast<double>(draw_.below(9));
    }
  }

  /// So much older, and where it was then.
  static void age(Object& o, double years) {
    o.t -= years;
    for (int j = 0; j < 3; ++j) {
      o.v[j] -= o.a[j] * years;
      o.x[j] -= years * (o.v[j] + o.a[j] * years / 2);
    }
  }

  /// The relative position and velocity of b at some time.
  struct Meeting {
    Vec<3> place, velocity;
  };

  Meeting meeting(MeshScene& scene) {
    Meeting any{place_of(draw_.place(4)), place_of(draw_.place(3))};
    if (family_.motion == Motion::along_axes)
      for (double& v : any.velocity) v = draw_.below(2) ? std::round(v) : 0;
    if (family_.motion <= Motion::along_axes) return any;
    const auto corners = scene.a.mesh.corners();
    const auto triangles = scene.a.mesh.triangles();
    const Triangle& t = triangles[draw_.below(triangles.size())];
    const Vec<3> p = place_of(corners[t[0]]), q = place_of(corner_of(scene.b));
    const auto path_to = [&](const SpaceCorner& corner) -> Vec<3> {
      const double pace = std::ldexp(1.0, static_cast<int>(draw_.below(4)) - 2) * (draw_.below(2) ? 1 : -1);
      return pace * (place_of(corner) - p);
    };
    Meeting met{p - q, any.velocity};
    if (family_.motion == Motion::none) met.velocity = Vec<3>::zero();
    if (family_.motion == Motion::along_an_edge) met.velocity = path_to(corners[t[1]]);
    if (family_.motion == Motion::across_a_face) {
      met.velocity = path_to(corners[t[1]]);
      met.velocity += path_to(corners[t[2]]);
    }
    if (family_.motion == Motion::through_corners)
      met.velocity = path_to(corners[draw_.below(corners.size())]);
    if (family_.motion == Motion::passes_a_corner) pass(scene, met);
    return met;
  }

  /// At a distance that is a number, and at a right angle to the way.
  void pass(MeshScene& scene, Meeting& met) {
    static constexpr double gaps[3][4] = {{1, 1.5, 3, 3.5}, {0, 1.5, 2, 2.5}, {0, 0, 3, 3}};
    const auto& gap = gaps[draw_.below(3)];
    const std::uint64_t first = draw_.below(3);
    Vec<3> apart;
    for (std::uint64_t j = 0; j < 3; ++j) apart[j] = gap[(first + j) % 3] * (draw_.below(2) ? 1 : -1);
    scene.question.within = gap[3] - scene.b.row.r;
    met.place += apart;
    const Vec<3> v = met.velocity;
    met.velocity = Vec<3>(apart[1] * v[2] - apart[2] * v[1], apart[2] * v[0] - apart[0] * v[2],
                          apart[0] * v[1] - apart[1] * v[0]) /
                   2;
  }

  void scale(MeshScene& scene) const {
    if (family_.scale == 0) return;
    const double factor = std::ldexp(1.0, family_.scale);
    scene.question.within *= factor;
    for (MeshObject* o : {&scene.a, &scene.b}) {
      Object& row = o->row;
      row.r *= factor;
      for (double* list : {row.x, row.v, row.a, row.half})
        for (int j = 0; j < 3; ++j) list[j] *= factor;
      o->mesh = mapped(o->mesh, [factor](const SpaceCorner& c) -> SpaceCorner {
        return {factor * c.x, factor * c.y, factor * c.z};
      });
    }
  }

  const MeshFamily& family_;
  const MeshPairing pairing_;
  DrawMesh draw_;
  double heading_ = 0;
};

}  // namespace

MeshScene draw_scene(const MeshFamily& family, MeshPairing pairing, std::uint64_t seed) {
  return DrawScene(family, pairing, seed).scene();
}

}  // namespace foresee::testing_by_hand
