// Workloads: the scenes of all speed figures, from fixed seeds.
//
//   Workload w = make_workload("S-100000");               // rows, layout, horizon
//
//   S-<n>   plane of side sqrt(14 n), half extents 0.5, |v| <= 3, |a| <= 0.5, h = 3: about 1 pair per object
//
//   U-<n>   S-<n> in uniform motion: no acceleration
//
//   K-<n>   S-<n>, stored in Morton order
//
//   M-<n>   S-<n>, but 1 % of the objects 1000 times faster and 0.1 % 1000 times larger
//
//   L-<h>   S-100000 without acceleration, horizon h
//
//   G-<p>   S-100000, but p per cent of the objects 100 times larger
//
//   P-uniform-<n>, P-zipf-<n>, P-city-<n>
//           the paper's scene: 10000 x 10000 x 50, half extents 2.5, |v| <= 3, |a| <= 0.5 (along z a tenth of
//           the speed and no acceleration), h = 3; centres uniform, by Zipf's law in 1000 bins, or around 50
//           cities
//
//   P-cube-<n>  a cube of side (40 n)^(1/3), half extents 0.5
//
//   D-<n>   S-<n>, but discs of radius 0.5 with the same motions
//
//   C-<n>   a cube of side (28 n)^(1/3), upright cylinders of radius 0.5 and half height 0.5, |v| <= 3,
//           |a| <= 0.5, h = 3: about one pair per object
//
//   X-<n>   n/2 boxes as those of S and n/2 discs as those of D in two tables, on a plane of side sqrt(7 n),
//           joined for the pairs of a box and a disc: about one pair per object
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "shape/bodies.h"

namespace foresee::bench {

struct Workload {
  std::string name;
  Layout layout;
  std::vector<double> rows;  ///< row_offsets(layout): x, v, a (unless uniform), then what the shape has
  std::size_t count = 0;
  double h = 3;
  std::shared_ptr<const Workload> other = nullptr;  ///< the second table of a join of two; else null

  Bodies bodies() const { return {layout, rows.data(), count}; }
  /// What the objects are joined with: those of the other table, or themselves.
  const Workload& second() const { return other ? *other : *this; }
  /// In both tables.
  std::size_t objects() const { return count + (other ? other->count : 0); }
};

enum class Spread { uniform, zipf, city };
inline constexpr Spread all_spreads[] = {Spread::uniform, Spread::zipf, Spread::city};
std::string name_of(Spread spread);

/// The paper's scene with all that its experiments vary; what is left out is its default, and P-<spread>-<n>.
struct PaperScene {
  Spread spread = Spread::uniform;
  std::size_t count = 2000;
  double h = 3, v_max = 3, a_max = 0.5;
  bool accelerated = true;  ///< else the same objects without acceleration
  std::uint64_t seed = 0;   ///< other scenes of the same kind
};
Workload paper_workload(const PaperScene& scene, const std::string& name);

/// Throws Error for a name that is not in the list above.
Workload make_workload(const std::string& name);

}  // namespace foresee::bench
