// What contact of meshes is made of (pieces/union_pair.h): triangles, boxes and points in space.
#pragma once

#include "contact/mesh/plate_tests.h"
#include "contact/mesh/space_polynomials.h"
#include "contact/mesh/space_tests.h"
#include "contact/mesh/within.h"
#include "contact/mesh_contact.h"
#include "contact/pieces/pair_way.h"
#include "contact/pieces/plain_answer.h"

namespace foresee {

template <int Degree>
struct SpaceKit {
  static constexpr int axes = 3, degree = Degree;
  static constexpr bool has_solids = true;
  using Tables = MeshTables;
  using Pieces = SpacePieces;
  using Condition = SpaceCondition;
  template <class T>
  using Sizes = SpaceSizes<T>;
  using Space = PieceSpace<SpaceCondition>;
  using Tests = SpaceTests<Degree>;
  using NodeTests = PlateTests;
  using Within = foresee::Within;
  using Polynomials = SpacePolynomials;

  template <class T>
  static SpaceSizes<T> sizes_of(const Setup& setup, const double* row_a, const double* row_b) {
    return {radius_of<T>(setup, row_a, row_b), steady_axes_of(setup, row_a, row_b)};
  }
  /// None: triangles are many, and asked one by one (plain_passing.h).
  static PlainAnswer plain_answer(const PairWay<SpaceKit>&, bool) { return {}; }
  static constexpr bool is_cut(const SpaceCondition&) { return false; }
  /// What the rows of a pair look like.
  static void take(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables, const Pair& pair);
};

}  // namespace foresee
