// The scan kernel for the CPU that the build asks for, four lanes at a time in plain C++, and the choice of a
// wider one.
#include "base/simd.h"
#include "index/gpcd_grid/scan_kernel.h"
#include "index/gpcd_grid/scan_variants.h"

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace foresee::gpcd {
namespace {

struct FourLanes {
  static constexpr std::size_t width = 4;
  using Floats = float __attribute__((vector_size(16)));
  using Mask = std::int32_t __attribute__((vector_size(16)));

  static Floats all(float x) { return Floats{x, x, x, x}; }
  static Floats load(const float* x) {
    Floats lanes;
    __builtin_memcpy(&lanes, x, sizeof lanes);
    return lanes;
  }
  static Floats abs(Floats x) { return as_floats(as_mask(x) & 0x7fffffff); }
  static Floats max(Floats x, Floats y) { return chosen(x > y, x, y); }
  static Floats min(Floats x, Floats y) { return chosen(x < y, x, y); }
  static Mask and_greater(Mask kept, Floats x, Floats y) { return kept & (x > y); }
  static Mask but_greater(Mask kept, Floats x, Floats y) { return kept & ~(x > y); }
  static Mask but(Mask kept, Mask others) { return kept & ~others; }
  static Mask unshared(const std::uint32_t* classes, std::uint32_t row) {
    Mask lanes;
    __builtin_memcpy(&lanes, classes, sizeof lanes);
    return (lanes & static_cast<std::int32_t>(row)) == 0;
  }
  static Pair* emit(Mask kept, std::uint32_t row, const std::uint32_t* ids, Pair* out) {
#if defined(__SSE__)
    const auto bits = static_cast<unsigned>(_mm_movemask_ps(as_floats(kept)));
#else
    unsigned bits = 0;
    for (int l = 0; l < 4; ++l) bits |= static_cast<unsigned>(kept[l] & 1) << l;
#endif
    return emit_bits(bits, row, ids, out);
  }

 private:
  static Floats as_floats(Mask x) {
    return reinterpret_cast<Floats>(x);
  }
  static Mask as_mask(Floats x) {
    return reinterpret_cast<Mask>(x);
  }
  static Floats chosen(Mask first, Floats x, Floats y) {
    return as_floats((as_mask(x) & first) | (as_mask(y) & ~first));
  }
};

}  // namespace

template <int D>
std::size_t run(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps) {
#if defined(__x86_64__)
  if (simd_in_use() == Simd::avx512) return run_avx512(scan, out, room, steps);
  if (simd_in_use() == Simd::avx2) return run_avx2(scan, out, room, steps);
#endif
  return run_with<FourLanes>(scan, out, room, steps);
}

template std::size_t run(Scan<1>&, Pair*, std::size_t, std::size_t&);
template std::size_t run(Scan<2>&, Pair*, std::size_t, std::size_t&);
template std::size_t run(Scan<3>&, Pair*, std::size_t, std::size_t&);

}  // namespace foresee::gpcd
