// Where can an object be, and when? A box that moves along a straight line and contains the object at every
// moment of the horizon at which it exists: accelerated motion made linear, for tests of time that need no
// root.
//
// A path of constant acceleration leaves its chord to one side only, by at most |a| T^2 / 8 over a time T;
// the line runs half of that beside the chord, and the box is thicker by the same half. The beam is stored as
// the box that it sweeps and the travel of its centre, from which all else follows:
//
//   centre at fraction f of the horizon = centre of `box` + travel * (f - (begin + end) / 2)
//   half extents of what moves          = half extents of `box` - |travel| * (end - begin) / 2
//
// Everything is rounded outward. An object that does not exist during the horizon has the empty box; what no
// double holds is infinite. A short life has no travel: its box stands still. Cost: some tens of flops an
// axis.
#pragma once

#include <cstddef>
#include <span>

#include "motion/swept_box.h"

namespace foresee {

template <int D>
struct Beam {
  Box<D> box;
  Vec<D> travel;  ///< of the centre during the whole horizon, also where the object lives for a part of it
  double begin, end;  ///< when the object exists, as fractions of the horizon; off by at most 2^-40
};

/// The beams of out.size() bodies from row `first` on, grown by `margin` (>= 0) on both sides of every axis.
template <int D>
void beams(const Bodies& bodies, std::size_t first, const Horizon& horizon, const Vec<D>& margin,
           std::span<Beam<D>> out);

/// Whether every body that exists during the horizon does so at each of its moments.
bool all_exist_throughout(const Bodies& bodies, const Horizon& horizon, Interrupt& interrupt);

}  // namespace foresee
