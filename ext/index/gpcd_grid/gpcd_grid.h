// GPCD's grid (Yu and Wong, steps 1 to 5c of docs/gpcd.md), laid out as stripes.
//
//   auto candidates = make_gpcd_grid<2>({ships, horizon, margin}, nullptr, interrupt);
//
// Space is cut into stripes along every axis but x. A box is entered into each stripe that it meets, sorted
// by the lower end of its x-interval (counting sort), so that a stripe is scanned from left to right with
// contiguous loads. A pair that shares several stripes is reported in exactly one of them, by position and
// without a set. Boxes far larger than the rest stay outside the grid and visit the stripes that they cross.
// What moves is compared as beams (shape/beam.h), so that most candidates come close at the same time. What
// giants cover at the beginning comes in batches of its own that touch for certain (giants.h).
//
// Cost: about linear in objects + candidates; memory follows the number of boxes, never the number of pairs.
#pragma once

#include "index/candidates.h"
#include "index/gpcd_grid/work_space.h"

namespace foresee {

/// Boxes in motion: what bodies sweep during the horizon, grown by `margin` on both sides of every axis.
template <int D>
struct MovingBoxes {
  Bodies bodies;
  Horizon horizon;
  Vec<D> margin;
};

/// The whole grid in one step: pairs among the objects of `a`, or between `a` and `b` if that is not null.
///
/// Nothing is missed: every pair comes, once, whose boxes, each grown by its margin, meet at a moment of the
/// horizon at which both objects exist. Others come only where their beams meet all the same: beams are
/// straight and rounded outward. Any finite numbers are fine: what is too large or too small to compute with
/// counts as near. The order is that of the stripes, not of time; it is the same for all vector instructions,
/// any `space` and any number of helpers.
///
/// All objects are entered before this returns, and the bodies not read afterwards; pairs are found while
/// they are pulled. `interrupt` is asked all the while and must outlive the grid. Throws Error where the
/// objects of a side meet more than 2^32 stripes in all. `space` saves fresh memory; null: the grid has its
/// own.
template <int D>
std::unique_ptr<Candidates> make_gpcd_grid(const MovingBoxes<D>& a, const MovingBoxes<D>* b,
                                           Interrupt& interrupt, std::shared_ptr<GridSpace> space = nullptr);

/// The same grid for several threads: entered by this one and `helpers` beside it, then visited in parts of
/// about as much work. Part after part gives the candidates in the order of make_gpcd_grid().
template <int D>
std::unique_ptr<DividedCandidates> make_divided_grid(const MovingBoxes<D>& a, const MovingBoxes<D>* b,
                                                     std::size_t helpers, Interrupt& interrupt,
                                                     std::shared_ptr<GridSpace> space);

}  // namespace foresee
