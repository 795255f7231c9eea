// Seeded families of pairs, each with one numerical difficulty, for the report on accuracy and for comparing
// builds.
//
//   Family family = make_family("box graze-near", 1000, 7);      // pair i: object i of a, object i of b
//
//   random, dense          nothing special; few and many contacts
//   reference-times        the two numbers of a pair hold at different instants
//   graze-exact            the paths touch at one instant and separate again; as doubles exactly so
//   graze-near             the same with one number moved by one to three units in the last place
//   simultaneous-exact     overlap ends on one axis at the very instant it starts on another (-near: moved)
//   near-parallel          relative speeds of 1e-7, horizons of 1e8
//   huge-offset            coordinates of 1e15 with extents around 1
//   huge-acceleration      1e9
//   denormal, overflow     all lengths times 2^-1060; times 2^700
//   instant                horizon 0: do they touch now?
//   same-motion            nothing moves relative to the other; some touch exactly
//   zero-extent            points on a lattice, some of which meet
//   cancelling-root        a short distance at a great speed: the textbook formula subtracts equals
//   mixed-scale            each number times a power of two of its own, up to 2^30
//   unix-times             now = 1.7e9, encounters of microseconds
//   in-out-in              (balls) the path bends back: two contacts, of which the first is queried
//   tangent-exact, -near   (balls) as graze for boxes
//   point-meets-point      (balls) radius 0 and a common point: a double root at least
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shape/bodies.h"

namespace foresee::bench {

struct Family {
  std::string name;
  Layout layout;  ///< three axes, accelerated, t; boxes or balls
  Horizon horizon;
  std::vector<double> rows_a, rows_b;
  std::size_t count = 0;

  Bodies a() const { return {layout, rows_a.data(), count}; }
  Bodies b() const { return {layout, rows_b.data(), count}; }
  bool balls() const { return layout.shape == Shape::ball; }
};

/// "box random", …, "ball random", …
std::vector<std::string> family_names();

/// Throws Error for an unknown name.
Family make_family(const std::string& name, std::size_t count, std::uint64_t seed);

}  // namespace foresee::bench
