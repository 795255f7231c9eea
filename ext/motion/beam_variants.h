// The loops of beams() for CPUs that have more than the build asks for; each in a file compiled for that CPU.
#pragma once

#include "motion/beam_lanes.h"

namespace foresee {

#if defined(__x86_64__)
template <int D>
void find_lives_avx2(BeamLanes<D>& lanes, std::size_t count, double now, double h);
template <int D, bool bent>
void find_beams_avx2(BeamLanes<D>& lanes, std::size_t count, const double (&margin)[D]);
template <int D>
void find_lives_avx512(BeamLanes<D>& lanes, std::size_t count, double now, double h);
template <int D, bool bent>
void find_beams_avx512(BeamLanes<D>& lanes, std::size_t count, const double (&margin)[D]);
#endif

}  // namespace foresee
