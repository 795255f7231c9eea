// The loops of beams() for AVX2: four doubles at a time. Compiled with -mavx2; called where the CPU has it.
#include "motion/beam_kernel.h"
#include "motion/beam_variants.h"

#if defined(__x86_64__)
namespace foresee {

template <int D>
void find_lives_avx2(BeamLanes<D>& lanes, std::size_t count, double now, double h) {
  find_lives_here(lanes, count, now, h);
}

template <int D, bool bent>
void find_beams_avx2(BeamLanes<D>& lanes, std::size_t count, const double (&margin)[D]) {
  find_beams_here<D, bent>(lanes, count, margin);
}

#define FORESEE_BEAMS_OF_AXES(D)                                                           \
  template void find_lives_avx2(BeamLanes<D>&, std::size_t, double, double);               \
  template void find_beams_avx2<D, false>(BeamLanes<D>&, std::size_t, const double(&)[D]); \
  template void find_beams_avx2<D, true>(BeamLanes<D>&, std::size_t, const double(&)[D])
FORESEE_BEAMS_OF_AXES(1);
FORESEE_BEAMS_OF_AXES(2);
FORESEE_BEAMS_OF_AXES(3);
#undef FORESEE_BEAMS_OF_AXES

}  // namespace foresee
#endif
