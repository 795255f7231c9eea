#include "contact/mesh_contact.h"

#include "contact/mesh/space_kit.h"
#include "contact/pieces/union_contact.h"
#include "contact/pieces/window_near.h"

namespace foresee {
namespace {

Vec<3> place_at(const double* numbers) {
  return Vec<3>(numbers[0], numbers[1], numbers[2]);
}

/// What the row of a table looks like.
void take_row(SpacePieces& pieces, const Bodies& bodies, const MeshRows* meshes, std::size_t i) {
  const TriangleTree* const known = meshes ? meshes->triangles(i, pieces.own()) : nullptr;
  if (known) return pieces.take(*known);
  const double* const row = bodies.row(i);
  const Offsets& at = bodies.at;
  if (!meshes && at.bounds != Offsets::absent)
    return pieces.take_box({place_at(row + at.bounds), place_at(row + at.bounds + 3)});
  if (at.half == Offsets::absent) return pieces.take_point();
  pieces.take_box({-place_at(row + at.half), place_at(row + at.half)});
}

}  // namespace

template <int Degree>
void SpaceKit<Degree>::take(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables,
                            const Pair& pair) {
  if (setup.window)
    a.take_box(window_near<3>(setup, setup.b.row(pair.b)));
  else
    take_row(a, setup.a, tables.a, pair.a);
  take_row(b, setup.b, tables.b, pair.b);
}

std::unique_ptr<Contact> make_mesh_contact(const Setup& setup, const MeshTables& meshes, int degree) {
  if (degree < 2) return std::make_unique<UnionContact<SpaceKit<1>>>(setup, meshes);
  return std::make_unique<UnionContact<SpaceKit<2>>>(setup, meshes);
}

}  // namespace foresee
