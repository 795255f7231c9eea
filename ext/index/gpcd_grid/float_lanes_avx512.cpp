// The loops of float_lanes.h for AVX-512. Compiled with -mavx512f; called where the CPU has it.
#include "index/gpcd_grid/float_lanes_kernel.h"

#if defined(__x86_64__)
namespace foresee::gpcd {

template <int D>
void round_outward_avx512(const BeamLanes<D>& beams, std::size_t count, const Frame<D>& frame,
                          Columns columns, FloatLanes<D>& out) {
  round_outward_here(beams, count, frame, columns, out);
}

template <int D>
void find_stripes_avx512(FloatLanes<D>& lanes, std::size_t count, const Partition<D>& partition) {
  find_stripes_here(lanes, count, partition);
}

#define FORESEE_FLOATS_OF_AXES(D)                                                                \
  template void round_outward_avx512(const BeamLanes<D>&, std::size_t, const Frame<D>&, Columns, \
                                     FloatLanes<D>&);                                            \
  template void find_stripes_avx512(FloatLanes<D>&, std::size_t, const Partition<D>&)
FORESEE_FLOATS_OF_AXES(1);
FORESEE_FLOATS_OF_AXES(2);
FORESEE_FLOATS_OF_AXES(3);
#undef FORESEE_FLOATS_OF_AXES

}  // namespace foresee::gpcd
#endif
