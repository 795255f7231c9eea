// run() of scan.h for CPUs that have more than the build asks for; each in a file compiled for that CPU.
#pragma once

#include "index/gpcd_grid/scan.h"

namespace foresee::gpcd {

#if defined(__x86_64__)
template <int D>
std::size_t run_avx2(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps);
template <int D>
std::size_t run_avx512(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps);
#endif

}  // namespace foresee::gpcd
