// The kernel for AVX2: four doubles at a time. Compiled with -mavx2; called where the CPU has it.
#include "contact/box_lanes_kernel.h"

#if defined(__x86_64__)
namespace foresee {

template <int D, int Degree>
void settle_avx2(BoxLanes<D, Degree>& lanes) {
  settle_here(lanes);
}

void find_meetings_avx2(MeetingLanes& lanes, double now) {
  find_meetings_here(lanes, now);
}

template void settle_avx2(BoxLanes<1, 1>&);
template void settle_avx2(BoxLanes<1, 2>&);
template void settle_avx2(BoxLanes<2, 1>&);
template void settle_avx2(BoxLanes<2, 2>&);
template void settle_avx2(BoxLanes<3, 1>&);
template void settle_avx2(BoxLanes<3, 2>&);

}  // namespace foresee
#endif
