// The kernel for the CPU that the build asks for, and the choice of a wider one.
#include "contact/box_lanes.h"

#include "contact/box_lanes_kernel.h"
#include "motion/simd.h"

namespace foresee {

template <int D, int Degree>
void settle(BoxLanes<D, Degree>& lanes) {
#if defined(__x86_64__)
  if (simd_in_use() == Simd::avx512) return settle_avx512(lanes);
  if (simd_in_use() == Simd::avx2) return settle_avx2(lanes);
#endif
  settle_here(lanes);
}

void find_meetings(MeetingLanes& lanes, double now) {
#if defined(__x86_64__)
  if (simd_in_use() == Simd::avx512) return find_meetings_avx512(lanes, now);
  if (simd_in_use() == Simd::avx2) return find_meetings_avx2(lanes, now);
#endif
  find_meetings_here(lanes, now);
}

template void settle(BoxLanes<1, 1>&);
template void settle(BoxLanes<1, 2>&);
template void settle(BoxLanes<2, 1>&);
template void settle(BoxLanes<2, 2>&);
template void settle(BoxLanes<3, 1>&);
template void settle(BoxLanes<3, 2>&);

}  // namespace foresee
