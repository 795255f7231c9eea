// Beam: a box that moves along a straight line and contains a moving object during the whole horizon.
//
// It contains the object at every time of the horizon at which the object exists. Accelerated motion becomes
// linear, so that tests of time need no roots.
//
//   BeamLanes<2> lanes;
//   beams<2>(bodies, first, count, horizon, margin, lanes);
//   Beam<2> beam = beam_at(lanes, 7);                    // of the body in row first + 7
//
// A path of constant acceleration leaves its chord by at most |a| T^2 / 8 over a time T, to one side only.
// The line of the beam runs at half that distance from the chord, and the box is thicker by the same half.
// The beam is stored as the box that it sweeps and the travel of its centre; both give all else:
//
//   centre at fraction f of the horizon = centre of `box` + travel * (f - (begin + end) / 2)
//   half extents of what moves          = half extents of `box` - |travel| * (end - begin) / 2
//
// All bounds are rounded outward. An object that does not exist during the horizon has the empty box; bounds
// that no double holds are infinite. The beam of a short life has no travel: its box does not move. Beams are
// computed several at once with the widest vector instructions of the CPU, which all give the same bits.
// Cost: some nanoseconds per beam.
#pragma once

#include <cstddef>

#include "motion/axis_aligned_box.h"
#include "motion/beam_lanes.h"
#include "shape/bodies.h"

namespace foresee {

template <int D>
struct Beam {
  Box<D> box;
  Vec<D> travel;  ///< of the centre over the whole horizon, even if the object exists for only a part of it
  double begin, end;  ///< the object's life as fractions of the horizon; off by at most 2^-40
};

/// The beam of one lane.
template <int D>
Beam<D> beam_at(const BeamLanes<D>& lanes, std::size_t l) {
  Beam<D> beam;
  for (int k = 0; k < D; ++k) {
    beam.box.lower[k] = lanes.lower[k][l], beam.box.upper[k] = lanes.upper[k][l];
    beam.travel[k] = lanes.travel[k][l];
  }
  beam.begin = lanes.begin[l], beam.end = lanes.end[l];
  return beam;
}

template <int D>
void put(const Beam<D>& beam, BeamLanes<D>& lanes, std::size_t l) {
  for (int k = 0; k < D; ++k) {
    lanes.lower[k][l] = beam.box.lower[k], lanes.upper[k][l] = beam.box.upper[k];
    lanes.travel[k][l] = beam.travel[k];
  }
  lanes.begin[l] = beam.begin, lanes.end[l] = beam.end;
}

/// The beams of `count` bodies, at most BeamLanes::width, from row `first` on, grown by `margin` (>= 0) on
/// both sides of every axis. Later lanes are unspecified.
template <int D>
void beams(const Bodies& bodies, std::size_t first, std::size_t count, const Horizon& horizon,
           const Vec<D>& margin, BeamLanes<D>& out);

}  // namespace foresee
