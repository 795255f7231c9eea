// Distance of a pair of shapes: which metric decides contact of two tables, and which sizes add up for it.
//
//   const PairRule rule(ships, quays, 926);      // two layouts: rule.distance == Distance::euclidean,
//   size_as_of_t<double>(rule.radius, row_a, row_b);                       // r_a + r_b + 926
//
// Two objects touch while the vector from a to b lies in one convex set. That is a box of half extents
// `extent`, whose round axes are inflated together by `radius`. Round are all axes for the Euclidean
// distance, x and y for upright shapes, and none for the distance per axis. Outlines and meshes replace the
// box by Minkowski sums of their pieces. A window is such a box with faces of its own.
//
// The rule is made once per statement from both layouts. Contact sets, box lanes, conditions of pieces,
// clearance and reach read it, so that they cannot disagree. A new Shape compiles only with its own row in
// the table of pair_rule.cpp.
#pragma once

#include <optional>
#include <string>

#include "numbers/exact_conversion.h"
#include "shape/row_layout.h"

namespace foresee {

enum class Distance : std::uint8_t {
  per_axis,   ///< on every axis alone
  euclidean,  ///< from surface to surface
  upright     ///< Euclidean in x and y, and along z alone
};

/// What the contact set of a pair is made of.
enum class PieceKind : std::uint8_t {
  none,    ///< a few lengths in the rows: one set serves all pairs
  planar,  ///< convex pieces of outlines in x and y
  spatial  ///< triangles of meshes
};

/// A size of both objects together: the numbers of the two rows at these places, and `limit`, added. From
/// the t of each row on it grows at the rates at its place of growth. An absent place counts as 0.
struct PairSize {
  int a = Offsets::absent, b = Offsets::absent;
  int growth_a = Offsets::absent, growth_b = Offsets::absent;
  double limit = 0;
};

/// Both sizes at their own reference times, before they grow.
template <class T>
T size_as_of_t(const PairSize& size, const double* row_a, const double* row_b) {
  using E = Exactly<T>;
  return E::number(value_or(row_a, size.a, 0)) + E::number(value_or(row_b, size.b, 0)) +
         E::number(size.limit);
}

struct PairRule {
  PairRule() = default;
  /// `within`, `within_z`: the distances of the query. Requires: layouts that have a distance
  /// (require_distance()).
  PairRule(const Layout& a, const Layout& b, double within = 0, std::optional<double> within_z = {});
  /// The rule for a window, or for a zone, and a table.
  static PairRule of_window(const Layout& window, const Layout& objects, bool is_zone);

  /// The distance per axis, which is the same if nothing is round.
  PairRule without_radius() const;

  bool has_extent(int axis) const {
    const PairSize& size = extent[axis];
    return size.a != Offsets::absent || size.b != Offsets::absent;
  }
  /// The distances that count as touching: in x and y, or on all axes; and along z.
  double within() const { return distance == Distance::per_axis ? extent[0].limit : radius.limit; }
  double within_z() const { return distance == Distance::upright ? extent[2].limit : within(); }

  /// The inflation of swept boxes, of both tables together, with which the boxes of every pair that touches intersect:
  /// in x and y, or on all axes; and along z. Both are upper bounds.
  struct Reach {
    double within, within_z;
  };
  Reach reach() const { return {within(), within_z()}; }

  Distance distance = Distance::per_axis;
  PieceKind pieces = PieceKind::none;
  bool grows = false;                                ///< the sizes of a table grow with time
  int t_a = Offsets::absent, t_b = Offsets::absent;  ///< the places of the reference times
  PairSize radius;                                   ///< on the round axes together
  PairSize extent[3];                                ///< on each axis; of pieces only along z

 private:
  struct Side;
  PairRule(const Side& a, const Side& b, double within, std::optional<double> within_z);
};

/// Throws Error for two tables, or for a zone and a table, that have no distance. It depends on the
/// declarations alone, so that the error does not depend on rows, ids or methods.
void require_distance(const Layout& a, const Layout& b, const std::optional<double>& within_z,
                      const std::string& name_a, const std::string& name_b);
void require_distance_from_zone(const Layout& objects, bool zone_has_z);

}  // namespace foresee
