// Cost of exact contact of meshes, beside a textbook that tests all corners, edges and triangles in plain
// double, and beside FCL's continuous collision, where that is installed.
//
//   bench_mesh_cost [--quick] [80] [924] [9800]            // triangles
//
// Closed meshes between spheres and potatoes, of about the same size whatever their triangles, fly through
// each other's space over 60 s. The pairs are candidates: their swept boxes intersect. Trees are made before
// the clock starts, ours and FCL's. pair_costs.h describes the output. The textbook runs on fewer pairs of
// 924 triangles, and not on larger meshes.
#include <cmath>
#include <cstdio>
#include <random>

#include "contact/contact_factories.h"
#include "fcl_rival.h"
#include "motion/swept_box.h"
#include "pair_costs.h"
#include "plain_mesh.h"
#include "program.h"
#include "shape/mesh/triangle_tree.h"

namespace foresee::bench {
namespace {

constexpr double h = 60;
constexpr double size = 50;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec<3> place(double limit) {
    return Vec<3>(number(-limit, limit), number(-limit, limit), number(-limit, limit));
  }

  /// A sphere of rings and two poles, like circles of latitude, with 2 * around * (rings - 1) triangles.
  /// Three waves along random directions move its corners up and down by a tenth of an edge.
  Mesh potato(std::uint32_t around, std::uint32_t rings) {
    const std::array<Vec<3>, 3> waves = {place(3), place(3), place(3)};
    const auto corner = [&](double polar, double angle) {
      const Vec<3> direction(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                             std::cos(polar));
      double height = 1 + number(-0.3, 0.3) / around;
      for (const Vec<3>& wave : waves) height += 0.1 * std::sin((wave * direction).sum());
      return SpaceCorner{size * height * direction[0], size * height * direction[1],
                         size * height * direction[2]};
    };
    std::vector<SpaceCorner> corners{corner(0, 0)};
    for (std::uint32_t ring = 1; ring < rings; ++ring)
      for (std::uint32_t i = 0; i < around; ++i)
        corners.push_back(corner(pi * ring / rings, 2 * pi * (i + 0.5 * ring) / around));
    corners.push_back(corner(pi, 0));
    const std::uint32_t last = static_cast<std::uint32_t>(corners.size()) - 1;
    const auto at = [=](std::uint32_t ring, std::uint32_t i) { return 1 + (ring - 1) * around + i % around; };
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < around; ++i) {
      triangles.push_back({0, at(1, i), at(1, i + 1)});
      for (std::uint32_t ring = 1; ring + 1 < rings; ++ring) {
        triangles.push_back({at(ring, i), at(ring + 1, i), at(ring, i + 1)});
        triangles.push_back({at(ring, i + 1), at(ring + 1, i), at(ring + 1, i + 1)});
      }
      triangles.push_back({last, at(rings - 1, i + 1), at(rings - 1, i)});
    }
    return {Mesh::Kind::solid, true, std::move(corners), std::move(triangles)};
  }

 private:
  static constexpr double pi = 3.14159265358979;
  std::mt19937_64 random_;
};

/// Meshes that move uniformly.
struct Fleet final : MeshRows {
  Fleet(Draw& draw, std::size_t count, std::uint32_t around, std::uint32_t rings) {
    for (std::size_t i = 0; i < count; ++i) {
      for (const Vec<3>& numbers : {draw.place(4 * size), draw.place(6)})
        for (int j = 0; j < 3; ++j) rows.push_back(numbers[j]);
      meshes.push_back(draw.potato(around, rings));
      trees.emplace_back(meshes.back());
      plain.emplace_back(meshes.back());
    }
  }

  const TriangleTree* pieces(std::size_t row, ScratchPieces<TriangleTree>&) const override {
    return &trees[row];
  }
  Bodies bodies() const { return {{.axes = 3, .law = Law::uniform}, rows.data(), rows.size() / 6}; }

  std::vector<double> rows;
  std::vector<Mesh> meshes;
  std::vector<TriangleTree> trees;
  std::vector<PlainMesh> plain;
};

std::vector<Pair> candidates(const Fleet& a, const Fleet& b, std::size_t max_pairs) {
  const auto swept = [](const Fleet& fleet, std::size_t i) {
    return swept_box<3>(motion_of<3>(fleet.bodies(), i), {0, h}, fleet.meshes[i].extents());
  };
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < a.bodies().count; ++i)
    for (std::uint32_t j = 0; j < b.bodies().count && pairs.size() < max_pairs; ++j)
      if (swept(a, i).meets(swept(b, j))) pairs.push_back({i, j});
  return pairs;
}

Flight flight_of(const Fleet& a, const Fleet& b, const Pair& pair) {
  const double *of_a = a.bodies().row(pair.a), *of_b = b.bodies().row(pair.b);
  const auto gap = [&](int first) {
    return Vec<3>(of_b[first] - of_a[first], of_b[first + 1] - of_a[first + 1],
                  of_b[first + 2] - of_a[first + 2]);
  };
  return {gap(0), gap(3), h};
}

struct Scene {
  const char* name;
  std::uint32_t around, rings;
  std::size_t fleet, max_pairs, plain_pairs;
};

void compare(const Scene& scene, int repetitions) {
  Draw draw(scene.around);
  const Fleet a(draw, scene.fleet, scene.around, scene.rings),
      b(draw, scene.fleet, scene.around, scene.rings);
  const Setup setup{a.bodies(), b.bodies(), {0, h}, PairRule(a.bodies().layout, b.bodies().layout)};
  const auto contact = make_mesh_contact(setup, {&a, &b}, 1);
  PairCosts costs(*contact, candidates(a, b, scene.max_pairs));
  if (scene.plain_pairs > 0)
    costs.add_rival("plain double", scene.plain_pairs, scene.around > 8 ? 0 : repetitions,
                    [&](const Pair& pair) {
                      const Flight flight = flight_of(a, b, pair);
                      return first_touch(a.plain[pair.a], b.plain[pair.b], flight.from, flight.velocity, h);
                    });
#ifdef FORESEE_FCL
  const std::vector<FclMesh> fcl_a(a.meshes.begin(), a.meshes.end()), fcl_b(b.meshes.begin(), b.meshes.end());
  for (const int samples : {10, 1000})
    costs.add_rival("FCL, " + std::to_string(samples) + " samples", scene.max_pairs, repetitions,
                    [&, samples](const Pair& pair) {
                      return first_collision(fcl_a[pair.a], fcl_b[pair.b], flight_of(a, b, pair), samples);
                    });
#endif
  costs.measure(repetitions);
  costs.print(scene.name);
}

int main_of(const Options& options) {
  const int repetitions = options.has("--quick") ? 3 : 9;
  for (const std::string& name : options.names({"80", "924", "9800"})) {
    if (name == "80") compare({"meshes of 80 triangles", 8, 6, 25, 200, 200}, repetitions);
    if (name == "924") compare({"meshes of 924 triangles", 22, 22, 15, 100, 6}, repetitions);
    if (name == "9800") compare({"meshes of 9,800 triangles", 70, 71, 10, 40, 0}, repetitions);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
