// The production grid for collision candidates: GPCD (Yu and Wong, steps 1 to 5c of docs/explanation/gpcd.md), laid out
// as stripes.
//
//   auto candidates = make_gpcd_grid<2>({ships, horizon, margin}, nullptr, interrupt);
//
// Space is cut into stripes along every axis but x. A box is entered into each stripe that it meets. A
// counting sort orders a stripe by the lower ends along x, so a scan from left to right uses contiguous
// loads. A pair that shares several stripes is reported in exactly one of them, chosen by position and
// without a set. Boxes far larger than the rest are not entered; they are compared with the stripes that they
// cross. Moving objects are compared as beams (shape/beam.h), so most candidates come close at the same time.
// Pairs that giants cover at the start of the horizon come in separate batches and certainly touch
// (giants.h).
//
// Cost: about linear in objects + candidates; memory is linear in the number of boxes, not of pairs.
#pragma once

#include "index/candidates.h"
#include "index/gpcd_grid/work_space.h"
#include "shape/kinds.h"

namespace foresee {

/// Objects in motion, with boxes grown by `margin` on both sides of every axis.
template <int D>
struct MovingBoxes {
  Bodies bodies;
  Horizon horizon;
  Vec<D> margin;
  const Kinds* kinds = nullptr;  ///< by row, or null: all may meet. Of both sides, or of none
};

/// Enters all objects and returns the candidates: pairs within `a`, or between `a` and `b` if that is not
/// null.
///
/// Every pair is reported once whose boxes, each grown by its margin, meet at a time of the horizon at which
/// both objects exist. Other pairs are reported only if their beams meet: beams are straight and rounded
/// outward. With kinds, a pair that may not meet is not reported. Any finite numbers are valid; those too
/// large or too small to compute with count as near. The order is that of the stripes, not of time. It is the
/// same for all vector instructions, any `space` and any number of helpers.
///
/// The bodies are not read after this returns, but their kinds are; pairs are found while they are pulled.
/// `interrupt` is polled throughout and must outlive the grid. Throws Error if the objects of a side meet
/// more than 2^32 stripes in total. `space` is memory for reuse; if it is null, the grid allocates its own.
template <int D>
std::unique_ptr<Candidates> make_gpcd_grid(const MovingBoxes<D>& a, const MovingBoxes<D>* b,
                                           Interrupt& interrupt, std::shared_ptr<GridSpace> space = nullptr);

/// make_gpcd_grid() for several threads. This thread and `helpers` others enter the objects; partitions of about
/// equal work can then be visited in parallel. The concatenated partitions give the candidates in the order
/// of make_gpcd_grid().
template <int D>
std::unique_ptr<DividedCandidates> make_divided_grid(const MovingBoxes<D>& a, const MovingBoxes<D>* b,
                                                     std::size_t helpers, Interrupt& interrupt,
                                                     std::shared_ptr<GridSpace> space);

}  // namespace foresee
