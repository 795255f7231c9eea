// GPCD's grid (Yu and Wong, steps 1 to 5a; DESIGN.md section 6), laid out as stripes.
//
// Space is cut into stripes along every axis but x. A box is entered into each stripe that it meets, sorted
// by the lower end of its x-interval (counting sort), so that a stripe is scanned from left to right with
// contiguous loads. A pair that shares several stripes is reported in exactly one of them, by position and
// without a set. Boxes far larger than the rest stay outside the grid and visit the stripes that they cross.
//
// Cost: about linear in objects + candidates; memory follows the number of boxes, never the number of pairs.
#pragma once

#include "index/candidates.h"

namespace foresee {

/// Pairs among `boxes`. The grid keeps no reference to them. `interrupt` must outlive the grid.
template <int D>
std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<D>> boxes, Interrupt& interrupt);

/// Pairs between `boxes_a` and `boxes_b`.
template <int D>
std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<D>> boxes_a, std::span<const Box<D>> boxes_b,
                                           Interrupt& interrupt);

}  // namespace foresee
