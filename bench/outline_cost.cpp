// Cost of exact contact of outlines, beside a textbook and beside methods that sample.
//
//   bench_outline_cost [--quick] [ships] [stars] [points] [ships-50]
//
// The textbook tests all corners of each against all edges of the other in plain double. The methods that
// sample are FCL's continuous collision of upright prisms, where that is installed, and Boost.Geometry's
// intersects() in steps of 0.1 s.
//
// Ships of 5 to 11 corners over 600 s, stars of 100 corners over 60 s, points and such a star; ships that
// come within 50 m, without a rival. The pairs are candidates: their swept boxes intersect. pair_costs.h
// describes the output. The textbook's "all corners" also tests each corner of outlines that touch at the
// start, as the end of a contact requires.
#include "contact/contact_factories.h"
#include "outline_steps.h"
#include "pair_costs.h"
#include "plain_outline.h"
#include "program.h"

namespace foresee::bench {
namespace {

constexpr std::size_t max_pairs = 20000;

Flight flight_of(const OutlineScene& scene, const Pair& pair) {
  const double *a = scene.a.bodies().row(pair.a), *b = scene.b.bodies().row(pair.b);
  return {Vec<3>(b[0] - a[0], b[1] - a[1], 0), Vec<3>(b[2] - a[2], b[3] - a[3], 0), scene.h};
}

PlainOutlines plain_pair(const OutlineScene& scene, const Pair& pair) {
  static constexpr Corner point[] = {{0, 0}};
  const Flight flight = flight_of(scene, pair);
  const auto ring = [](const OutlineFleet& fleet, std::size_t i) {
    return fleet.outlines.empty() ? std::span<const Corner>(point) : fleet.outlines[i].ring(0);
  };
  return {ring(scene.a, pair.a), ring(scene.b, pair.b), flight.from[0], flight.from[1],
          flight.velocity[0],    flight.velocity[1],    scene.h};
}

void add_textbook(PairCosts& costs, const OutlineScene& scene, int repetitions) {
  for (const bool all : {false, true})
    costs.add_rival(all ? "plain double, all corners" : "plain double", max_pairs, repetitions,
                    [&scene, all](const Pair& pair) { return first_touch(plain_pair(scene, pair), all); });
}

/// Methods that sample run on few pairs.
void compare(const OutlineScene& scene, int repetitions, std::size_t sampled_pairs) {
  const Bodies a = scene.a.bodies(), b = scene.b.bodies();
  const Setup setup{a, b, {0, scene.h}, PairRule(a.layout, b.layout, scene.within)};
  const auto contact = make_outline_contact(setup, {&scene.a, &scene.b}, 1);
  PairCosts costs(*contact, candidates(scene, max_pairs));
  if (scene.within == 0) add_textbook(costs, scene, repetitions);
  if (sampled_pairs == 0) {
    costs.measure(repetitions);
    return costs.print(scene.name);
  }
#ifdef FORESEE_FCL
  const std::vector<FclMesh> prisms_a = prisms_of(scene.a, -1, 0.5), prisms_b = prisms_of(scene.b, -0.5, 1);
  for (const int samples : {10, 1000})
    costs.add_rival(
        "FCL, " + std::to_string(samples) + " samples", sampled_pairs, 3, [&, samples](const Pair& pair) {
          return first_collision(prisms_a[pair.a], prisms_b[pair.b], flight_of(scene, pair), samples);
        });
#endif
  BoostSteps boost(scene.a, scene.b);
  costs.add_rival("Boost, steps of 0.1 s", sampled_pairs, 1, [&](const Pair& pair) {
    return boost.first_intersection(pair, flight_of(scene, pair), 0.1);
  });
  costs.measure(repetitions);
  costs.print(scene.name);
}

OutlineScene within_50(OutlineScene scene) {
  scene.name = "the same ships, within 50 m", scene.within = 50;
  return scene;
}

int main_of(const Options& options) {
  const bool quick = options.has("--quick");
  const int repetitions = quick ? 3 : 15;
  const std::size_t sampled = quick ? 200 : 1000;
  for (const std::string& name : options.names({"ships", "stars", "points", "ships-50"})) {
    if (name == "ships") compare(ships(400), repetitions, sampled);
    if (name == "stars") compare(stars(60), repetitions, sampled);
    if (name == "points") compare(points_and_a_star(20000), repetitions, 0);
    if (name == "ships-50") compare(within_50(ships(400)), repetitions, 0);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
