// Outlines to test with: random ones, and those that are hard.
#pragma once

#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "shape/outline/outline.h"

namespace foresee {

using Rings = std::vector<std::vector<Corner>>;

/// Of one part: its ring, then its holes.
Outline outline_of(const Rings& rings);
/// Of several.
Outline outline_of_parts(const std::vector<Rings>& parts);

/// Rings of random corners on a small grid, as holes or parts, often within a square: mostly unsound, and
/// full of corners on corners and edges.
Outline random_rings(std::mt19937_64& random);

/// The boundary of random cells of a grid, sheared: holes, parts and islands in holes that touch in corners.
/// Few are unsound.
Outline random_cells(std::mt19937_64& random);

/// A star around the position, with n corners at random distances.
Outline random_star(std::mt19937_64& random, int n);

/// Teeth that point to the right, one above the other.
Outline comb(int teeth);

/// A band that winds inwards.
Outline spiral(int turns);

/// A row of holes, each of which touches the one before it in a corner, the first and last the ring.
Outline chain_of_holes(int holes);

/// Every corner moved by `move`.
template <class Move>
Outline moved(const Outline& outline, Move&& move) {
  Outline there;
  for (std::size_t part = 0; part < outline.parts(); ++part)
    for (std::size_t r = outline.part_start(part); r < outline.part_start(part + 1); ++r) {
      r == outline.part_start(part) ? there.begin_part() : there.begin_hole();
      for (const Corner& corner : outline.ring(r)) there.add(move(corner));
      there.close_ring();
    }
  return there;
}

/// Scaled by a power of two, which is exact while nothing under- or overflows.
Outline scaled(const Outline& outline, int exponent);

/// Some corners moved to neighbouring doubles.
Outline shaken(const Outline& outline, std::mt19937_64& random);

}  // namespace foresee
