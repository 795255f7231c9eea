// The scan kernel for AVX-512: sixteen lanes at a time, hits stored without a branch. Compiled with
// -mavx512f; called where the CPU has it.
#include "index/gpcd_grid/scan_kernel.h"
#include "index/gpcd_grid/scan_variants.h"

#if defined(__x86_64__)
#include <immintrin.h>

namespace foresee::gpcd {
namespace {

struct SixteenLanes {
  static constexpr std::size_t width = 16;
  using Floats = __m512;
  using Mask = __mmask16;

  static Floats all(float x) { return _mm512_set1_ps(x); }
  static Floats load(const float* x) { return _mm512_loadu_ps(x); }
  static Floats abs(Floats x) { return _mm512_abs_ps(x); }
  // Masked, because GCC 12 warns about its own header for the plain ones.
  static Floats max(Floats x, Floats y) { return _mm512_mask_max_ps(x, 0xffff, x, y); }
  static Floats min(Floats x, Floats y) { return _mm512_mask_min_ps(x, 0xffff, x, y); }
  static Mask and_greater(Mask kept, Floats x, Floats y) {
    return _mm512_mask_cmp_ps_mask(kept, x, y, _CMP_GT_OQ);
  }
  static Mask but_greater(Mask kept, Floats x, Floats y) {
    return _mm512_mask_cmp_ps_mask(kept, x, y, _CMP_NGT_UQ);
  }
  static Mask but(Mask kept, Mask others) { return static_cast<Mask>(kept & ~others); }
  static Mask unshared(const std::uint32_t* classes, std::uint32_t row) {
    return _mm512_testn_epi32_mask(_mm512_loadu_si512(classes), _mm512_set1_epi32(static_cast<int>(row)));
  }
  /// Moves the hits to the front, interleaves them with the row, and writes all sixteen: the next hits go
  /// over what is too much.
  static Pair* emit(Mask kept, std::uint32_t row, const std::uint32_t* ids, Pair* out) {
    const __m512i rows = _mm512_set1_epi32(static_cast<int>(row));
    const __m512i lanes = _mm512_maskz_compress_epi32(kept, _mm512_loadu_si512(ids));
    const __m512i first = _mm512_set_epi32(23, 7, 22, 6, 21, 5, 20, 4, 19, 3, 18, 2, 17, 1, 16, 0);
    const __m512i second = _mm512_set_epi32(31, 15, 30, 14, 29, 13, 28, 12, 27, 11, 26, 10, 25, 9, 24, 8);
    const int count = __builtin_popcount(kept);
    _mm512_storeu_si512(out, _mm512_permutex2var_epi32(rows, first, lanes));
    if (count > 8) _mm512_storeu_si512(out + 8, _mm512_permutex2var_epi32(rows, second, lanes));
    return out + count;
  }
};

}  // namespace

template <int D>
std::size_t run_avx512(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps) {
  return run_with<SixteenLanes>(scan, out, room, steps);
}

template std::size_t run_avx512(Scan<1>&, Pair*, std::size_t, std::size_t&);
template std::size_t run_avx512(Scan<2>&, Pair*, std::size_t, std::size_t&);
template std::size_t run_avx512(Scan<3>&, Pair*, std::size_t, std::size_t&);

}  // namespace foresee::gpcd
#endif
