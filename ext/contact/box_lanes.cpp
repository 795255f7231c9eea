// The kernel for the CPU that the build asks for, and the choice of a wider one.
#include "contact/box_lanes.h"

#include "base/simd.h"
#include "contact/box_ends_kernel.h"

namespace foresee {

template <int D, int Degree>
const BoxKernel<D, Degree>& box_kernel() {
#if defined(__x86_64__)
  if (simd_in_use() == Simd::avx512) return box_kernel_avx512<D, Degree>();
  if (simd_in_use() == Simd::avx2) return box_kernel_avx2<D, Degree>();
#endif
  return kernel_here<D, Degree>;
}

template const BoxKernel<1, 1>& box_kernel();
template const BoxKernel<1, 2>& box_kernel();
template const BoxKernel<2, 1>& box_kernel();
template const BoxKernel<2, 2>& box_kernel();
template const BoxKernel<3, 1>& box_kernel();
template const BoxKernel<3, 2>& box_kernel();

}  // namespace foresee
