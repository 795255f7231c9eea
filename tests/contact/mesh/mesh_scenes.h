// Random test scenes of pairs with meshes, in families of hard cases: sliding faces and edges, corners on
// corners, parallel faces, terrain, solids in cavities and holes. Coordinates may be far from 0 and scales
// extreme.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <string>

#include "contact/mesh/mesh_shapes.h"
#include "contact/pair_by_hand.h"
#include "contact/window_contact.h"

namespace foresee::testing_by_hand {

/// One object: its row, and its mesh in its pose; an object without a mesh is a point or a ball.
struct MeshObject {
  Object row;
  Mesh mesh;
};

/// A mesh, at rest at the origin.
MeshObject resting(const Mesh& mesh);
/// The same, moved.
MeshObject moving(MeshObject object, const SpaceCorner& place, const SpaceCorner& velocity);
/// A box, or a point; half extents may be 0.
MeshObject box_object(const SpaceCorner& half);
/// A ball: of a table of balls, or of one of meshes in which it has none.
MeshObject ball_object(double r, bool is_in_table_of_meshes);

/// The same triangles, with `place_of` each corner.
template <class PlaceOf>
Mesh mapped(const Mesh& mesh, PlaceOf&& place_of) {
  std::vector<SpaceCorner> corners;
  for (const SpaceCorner& corner : mesh.corners()) corners.push_back(place_of(corner));
  return Mesh(mesh.kind(), mesh.is_solid(), corners, {mesh.triangles().begin(), mesh.triangles().end()});
}

struct MeshScene {
  MeshObject a, b;
  ContactQuestion question;
};

/// The result of Contact; checks that decide() and first_contacts() with both TimesWanted agree.
std::optional<ContactTimes> mesh_contact(const MeshScene& scene);
/// The same with an interrupt.
std::optional<ContactTimes> mesh_contact(const MeshScene& scene, Interrupt& interrupt);

/// Of a window and an object.
std::optional<ContactTimes> mesh_in_window(const WindowFaces& faces, const MeshObject& object,
                                           const Horizon& horizon);

/// How the numbers of a family look.
struct MeshFamily {
  enum class Motion : std::uint8_t {
    any,              ///< random positions and speeds at an integer time
    along_axes,       ///< whole numbers, and some are 0
    meets_a_corner,   ///< a corner of b comes to a corner of a at an integer time
    along_an_edge,    ///< the same, along an edge of a
    across_a_face,    ///< the same, in the plane of a triangle of a
    through_corners,  ///< from a corner of a to another, whatever lies between
    passes_a_corner,  ///< a corner of b passes one of a at the contact distance, at an integer time
    none              ///< corner on corner, and no relative motion
  };
  enum class Cast : std::uint8_t {
    any,      ///< all of them
    boxes,    ///< one or several, beside, on and in each other
    terrain,  ///< a is one
    nested,   ///< a has cavities, a hole or walls; b is small
    slivers,  ///< triangles that are nearly lines, solids that are nearly flat
    many      ///< a has some two hundred triangles
  };
  const char* name;
  Motion motion = Motion::any;
  Cast cast = Cast::any;
  int ulps = 0;        ///< places are then moved by up to so many units in the last place
  bool whole = true;   ///< halves of whole numbers: exact touches, ties
  double offset = 0;   ///< far from the origin
  int scale = 0;       ///< lengths times 2^scale
  int pace = 0;        ///< and relative velocities times 2^pace
  double now = 0;      ///< time of the query; reports are from time 0
  double ages = 0;     ///< reference times lie up to this before now
  bool lives = false;  ///< objects cease to exist at an integer time
  int turned = 0;      ///< so many degrees, or any heading if below 0
  bool bent = false;   ///< accelerated
};

std::span<const MeshFamily> mesh_families();

/// Which kinds of objects meet.
enum class MeshPairing : std::uint8_t { meshes, mesh_and_point, mesh_and_box, mesh_and_ball };

MeshScene draw_scene(const MeshFamily& family, MeshPairing pairing, std::uint64_t seed);

/// In words, for messages.
std::string described(const MeshScene& scene);

}  // namespace foresee::testing_by_hand
