#include <algorithm>

#include "contact/certified/bounded_window.h"
#include "contact/certified/exact_union.h"
#include "contact/certified/pair_context.h"
#include "contact/certified/pair_tests.h"
#include "contact/certified/union_contact.h"
#include "contact/certified/union_pair.h"
#include "contact/contact_factories.h"
#include "contact/mesh/containment.h"
#include "contact/mesh/disc_tests.h"
#include "contact/mesh/space_constraint.h"
#include "contact/mesh/space_sum.h"
#include "contact/mesh/space_tests.h"

namespace foresee {

/// Traits of contact between meshes (certified/pair_context.h): triangles, boxes and points in space.
template <int Degree>
struct SpaceTraits {
  static constexpr int axes = 3, degree = Degree;
  static constexpr bool has_solids = true, has_cuts = false, counts_work = true;
  using Tables = MeshTables;
  using Filter = EachPair;
  using Pieces = SpacePieces;
  using PieceConstraint = SpaceConstraint;
  template <class T>
  using Sizes = SpaceSizes<T>;
  using Space = PieceWorkspace<SpaceConstraint>;
  using Tests = SpaceTests<Degree>;
  using Walk = TreeWalk<3, SpacePieces, DiscTests>;
  using Containment = foresee::Containment;
  using Context = PairContext<SpaceTraits>;
  using Staged = UnionPair<SpaceTraits>;
  using Exact = ExactUnion<SpaceTraits>;

  template <class T>
  static SpaceSizes<T> sizes_of(const Setup& setup, const double* row_a, const double* row_b, const Pieces&) {
    SpaceSizes<T> sizes{.radius = {size_as_of_t<T>(setup.rule.radius, row_a, row_b)}};
    if constexpr (std::is_same_v<T, Bounded>) sizes.steady = steady_axes_of(setup, row_a, row_b);
    return sizes;
  }
  /// Nothing: the filter of meshes tests single pairs of triangles (triangle_filter.h).
  static FilterAnswer filter_answer(const PairContext<SpaceTraits>&, bool) { return {}; }
  static std::vector<SpaceConstraint> shared_constraints(const Setup&) { return {}; }
  /// Adds the parts of the sum of two pieces, for the exact stage.
  static void add_pair(UndecidedPieces<SpaceTraits>& out, const SpacePiece& a, const SpacePiece& b,
                       bool grown, const std::vector<int>&) {
    Conditions core;
    SpaceHull(a, b).for_each([&](const SpacePlanes& planes) {
      core.all.push_back(out.add(planes.before)), core.all.push_back(out.add(planes.beyond));
      return true;
    });
    out.add_piece(core);
    if (!grown) return;
    RoundParts(a, b).for_each([&out](const RoundPart& part) {
      Conditions conditions;
      for (int i = 0; i < part.count; ++i)
        conditions.all.push_back(out.add(part.beside[static_cast<std::size_t>(i)]));
      conditions.ball = out.add(part.round);
      conditions.all.push_back(conditions.ball);
      out.add_piece(conditions);
      return true;
    });
  }
  /// Reads the pieces of a pair of rows.
  static void take(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables, const Pair& pair);
};

namespace {

Vec<3> place_at(const double* numbers) {
  return Vec<3>(numbers[0], numbers[1], numbers[2]);
}

/// Reads the pieces of a row.
void take_row(SpacePieces& pieces, const Bodies& bodies, const MeshRows* meshes, std::size_t i) {
  const TriangleTree* const known = meshes ? meshes->pieces(i, pieces.own()) : nullptr;
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
void SpaceTraits<Degree>::take(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables,
                               const Pair& pair) {
  if (setup.window)
    a.take_box(bounded_window<3>(setup, setup.b.row(pair.b)));
  else
    take_row(a, setup.a, tables.a, pair.a);
  take_row(b, setup.b, tables.b, pair.b);
}

std::unique_ptr<Contact> make_mesh_contact(const Setup& setup, const MeshTables& meshes, int degree) {
  if (degree < 2) return std::make_unique<UnionContact<SpaceTraits<1>>>(setup, meshes);
  return std::make_unique<UnionContact<SpaceTraits<2>>>(setup, meshes);
}

}  // namespace foresee
