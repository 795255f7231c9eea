// The loops of BoxKernel: a kernel (base/simd.h).
#include "contact/boxes/box_ends_kernel.h"

namespace foresee {

template <int D, int Degree, Simd simd>
const BoxKernel<D, Degree>& box_kernel() {
  static constexpr BoxKernel<D, Degree> kernel{settle_here<D, Degree>,
                                               settle_rows_here<D, Degree>,
                                               take_crossings<D, Degree, BoxLanes<D, Degree>>,
                                               find_crossings<Way::in, Degree>,
                                               settle_ends_here<D, Degree>,
                                               take_crossings<D, Degree, EndLanes>,
                                               find_crossings<Way::out, Degree>};
  return kernel;
}

template const BoxKernel<1, 1>& box_kernel<1, 1, Simd::FORESEE_SIMD>();
template const BoxKernel<1, 2>& box_kernel<1, 2, Simd::FORESEE_SIMD>();
template const BoxKernel<2, 1>& box_kernel<2, 1, Simd::FORESEE_SIMD>();
template const BoxKernel<2, 2>& box_kernel<2, 2, Simd::FORESEE_SIMD>();
template const BoxKernel<3, 1>& box_kernel<3, 1, Simd::FORESEE_SIMD>();
template const BoxKernel<3, 2>& box_kernel<3, 2, Simd::FORESEE_SIMD>();

}  // namespace foresee
