#include "contact/mesh/mesh_scenes.h"

#include <cmath>
#include <sstream>

#include "shape/form_rows.h"
#include "shape/mesh/triangle_tree.h"

namespace foresee::testing_by_hand {
namespace {

/// The meshes of a table of one row.
class OneMesh final : public MeshRows {
 public:
  explicit OneMesh(const Mesh& mesh) {
    if (!mesh.triangles().empty()) tree_ = TriangleTree(mesh);
  }
  const TriangleTree* pieces(std::size_t /*row*/, ScratchPieces<TriangleTree>& /*own*/) const override {
    return tree_.count() > 0 ? &tree_ : nullptr;
  }

 private:
  TriangleTree tree_;
};

/// The row, with what it says about its mesh.
std::vector<double> row_of(const MeshObject& o) {
  std::vector<double> row = o.row.row();
  const Offsets at = row_offsets(o.row.layout);
  if (at.bounds < 0 || o.mesh.triangles().empty()) return row;
  row[at.outline] = 1;
  const Extents<3> extents = o.mesh.extents();
  for (int j = 0; j < 3; ++j)
    row[at.bounds + j] = extents.lower[j], row[at.bounds + 3 + j] = extents.upper[j];
  return row;
}

}  // namespace

MeshObject resting(const Mesh& mesh) {
  MeshObject o{object(3, Shape::mesh), mesh};
  o.row.layout.law = Law::uniform;
  o.row.layout.has_radius = true;
  return o;
}

MeshObject moving(MeshObject o, const SpaceCorner& place, const SpaceCorner& velocity) {
  o.row.x[0] = place.x, o.row.x[1] = place.y, o.row.x[2] = place.z;
  o.row.v[0] = velocity.x, o.row.v[1] = velocity.y, o.row.v[2] = velocity.z;
  return o;
}

MeshObject box_object(const SpaceCorner& half) {
  MeshObject o{object(3, half == SpaceCorner{0, 0, 0} ? Shape::point : Shape::box), {}};
  o.row.layout.law = Law::uniform;
  o.row.half[0] = half.x, o.row.half[1] = half.y, o.row.half[2] = half.z;
  return o;
}

MeshObject ball_object(double r, bool is_in_table_of_meshes) {
  MeshObject o = resting({});
  if (!is_in_table_of_meshes) o.row.layout.shape = Shape::ball, o.row.layout.has_radius = false;
  o.row.r = r;
  return o;
}

std::optional<ContactTimes> mesh_contact(const MeshScene& scene) {
  NeverInterrupt never;
  return mesh_contact(scene, never);
}

std::optional<ContactTimes> mesh_contact(const MeshScene& scene, Interrupt& interrupt) {
  const std::vector<double> row_a = row_of(scene.a), row_b = row_of(scene.b);
  Bodies a(scene.a.row.layout, row_a.data(), 1), b(scene.b.row.layout, row_b.data(), 1);
  const OneMesh mesh_a(scene.a.mesh), mesh_b(scene.b.mesh);
  if (a.layout.shape == Shape::mesh) a.meshes = &mesh_a;
  if (b.layout.shape == Shape::mesh) b.meshes = &mesh_b;
  const auto contact = make_contact(a, b, scene.question, "a", "b");
  contact->set_interrupt(interrupt);
  return answer_of(*contact);
}

std::optional<ContactTimes> mesh_in_window(const WindowFaces& faces, const MeshObject& object,
                                           const Horizon& horizon) {
  const std::vector<double> row = row_of(object);
  Bodies bodies(object.row.layout, row.data(), 1);
  const OneMesh mesh(object.mesh);
  if (bodies.layout.shape == Shape::mesh) bodies.meshes = &mesh;
  const MovingWindow window(faces, bodies.layout, horizon.now);
  return answer_of(*make_window_contact(window, bodies, horizon));
}

std::span<const MeshFamily> mesh_families() {
  using Motion = MeshFamily::Motion;
  using Cast = MeshFamily::Cast;
  static constexpr MeshFamily families[] = {
      {.name = "whole"},
      {.name = "any", .whole = false},
      {.name = "an ulp off", .ulps = 2},
      {.name = "corner on corner", .motion = Motion::meets_a_corner},
      {.name = "corner beside corner", .motion = Motion::meets_a_corner, .ulps = 1},
      {.name = "along an edge", .motion = Motion::along_an_edge},
      {.name = "along an edge, an ulp off", .motion = Motion::along_an_edge, .ulps = 1},
      {.name = "across a face", .motion = Motion::across_a_face},
      {.name = "across a face, an ulp off", .motion = Motion::across_a_face, .ulps = 1},
      {.name = "along an edge, any numbers", .motion = Motion::along_an_edge, .whole = false},
      {.name = "across a face, any numbers", .motion = Motion::across_a_face, .whole = false},
      {.name = "through corners", .motion = Motion::through_corners},
      {.name = "past corners", .motion = Motion::through_corners, .ulps = 1},
      {.name = "through corners, any numbers", .motion = Motion::through_corners, .whole = false},
      {.name = "corner past corner", .motion = Motion::passes_a_corner},
      {.name = "corner past corner, an ulp off", .motion = Motion::passes_a_corner, .ulps = 1},
      {.name = "no relative motion", .motion = Motion::none},
      {.name = "no relative motion, an ulp off", .motion = Motion::none, .ulps = 1},
      {.name = "boxes", .motion = Motion::along_axes, .cast = Cast::boxes},
      {.name = "boxes, an ulp off", .motion = Motion::along_axes, .cast = Cast::boxes, .ulps = 1},
      {.name = "boxes turned alike", .motion = Motion::along_axes, .cast = Cast::boxes, .turned = 30},
      {.name = "boxes corner on corner", .motion = Motion::meets_a_corner, .cast = Cast::boxes},
      {.name = "terrain", .cast = Cast::terrain},
      {.name = "terrain, any numbers", .cast = Cast::terrain, .whole = false},
      {.name = "across terrain", .motion = Motion::across_a_face, .cast = Cast::terrain},
      {.name = "nested", .cast = Cast::nested},
      {.name = "nested, along axes", .motion = Motion::along_axes, .cast = Cast::nested},
      {.name = "nested, any numbers", .cast = Cast::nested, .whole = false},
      {.name = "nested, through corners", .motion = Motion::through_corners, .cast = Cast::nested},
      {.name = "slivers", .cast = Cast::slivers},
      {.name = "slivers, corner on corner", .motion = Motion::meets_a_corner, .cast = Cast::slivers},
      {.name = "across slivers", .motion = Motion::across_a_face, .cast = Cast::slivers},
      {.name = "many triangles", .cast = Cast::many, .whole = false},
      {.name = "across many triangles", .motion = Motion::across_a_face, .cast = Cast::many},
      {.name = "far", .motion = Motion::meets_a_corner, .offset = 1e7},
      {.name = "far, any numbers", .motion = Motion::meets_a_corner, .whole = false, .offset = 1e7},
      {.name = "small", .motion = Motion::meets_a_corner, .scale = -300},
      {.name = "large", .motion = Motion::meets_a_corner, .scale = 200},
      {.name = "fast", .motion = Motion::meets_a_corner, .pace = 30},
      {.name = "slow", .motion = Motion::across_a_face, .pace = -30},
      {.name = "slow, any numbers", .motion = Motion::meets_a_corner, .whole = false, .pace = -40},
      {.name = "aged", .motion = Motion::meets_a_corner, .ages = 64},
      {.name = "aged, any numbers", .whole = false, .ages = 1e6},
      {.name = "short lives", .motion = Motion::meets_a_corner, .lives = true},
      {.name = "lives that no double measures", .motion = Motion::meets_a_corner, .now = 0.1, .lives = true},
      {.name = "slides that no double measures", .motion = Motion::along_an_edge, .now = 0.1, .lives = true},
      {.name = "turned", .motion = Motion::meets_a_corner, .turned = -1},
      {.name = "turned by 90", .motion = Motion::across_a_face, .turned = 90},
      {.name = "turned by 30", .motion = Motion::along_an_edge, .turned = 30},
  };
  return families;
}

std::string described(const MeshScene& scene) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const MeshObject* o : {&scene.a, &scene.b}) {
    const Object& row = o->row;
    out << "t " << row.t << " until " << row.until << " r " << row.r << " half " << row.half[0] << ' '
        << row.half[1] << ' ' << row.half[2];
    for (int j = 0; j < 3; ++j) out << " axis " << row.x[j] << ' ' << row.v[j] << ' ' << row.a[j];
    out << (o->mesh.is_solid() ? " solid" : " surface");
    for (const Triangle& t : o->mesh.triangles()) {
      out << " (";
      for (const std::uint32_t i : t) {
        const SpaceCorner& c = o->mesh.corners()[i];
        out << (i == t[0] ? "" : ", ") << c.x << ' ' << c.y << ' ' << c.z;
      }
      out << ')';
    }
    out << '\n';
  }
  return out.str();
}

}  // namespace foresee::testing_by_hand
