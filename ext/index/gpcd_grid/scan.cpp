#include "index/gpcd_grid/scan.h"

namespace foresee::index::gpcd {

template <int D>
std::size_t run(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps) {
  const auto kernel = with_simd_in_use([]<Simd simd>(Level<simd>) { return scan_kernel<D, simd>(); });
  return kernel(scan, out, room, steps);
}

template std::size_t run(Scan<1>&, Pair*, std::size_t, std::size_t&);
template std::size_t run(Scan<2>&, Pair*, std::size_t, std::size_t&);
template std::size_t run(Scan<3>&, Pair*, std::size_t, std::size_t&);

}  // namespace foresee::index::gpcd
