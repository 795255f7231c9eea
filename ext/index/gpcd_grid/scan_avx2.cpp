// The scan kernel for AVX2: eight lanes at a time. Compiled with -mavx2; called where the CPU has it.
#include "index/gpcd_grid/scan_kernel.h"
#include "index/gpcd_grid/scan_variants.h"

#if defined(__x86_64__)
#include <immintrin.h>

namespace foresee::gpcd {
namespace {

struct EightLanes {
  static constexpr std::size_t width = 8;
  using Floats = __m256;
  using Mask = __m256i;

  static Floats all(float x) { return _mm256_set1_ps(x); }
  static Floats load(const float* x) { return _mm256_loadu_ps(x); }
  static Floats abs(Floats x) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), x); }
  static Floats max(Floats x, Floats y) { return _mm256_max_ps(x, y); }
  static Floats min(Floats x, Floats y) { return _mm256_min_ps(x, y); }
  static Mask and_greater(Mask kept, Floats x, Floats y) { return kept & greater(x, y); }
  static Mask but_greater(Mask kept, Floats x, Floats y) { return but(kept, greater(x, y)); }
  static Mask but(Mask kept, Mask others) { return _mm256_andnot_si256(others, kept); }
  static Mask unshared(const std::uint32_t* classes, std::uint32_t row) {
    const __m256i lanes = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(classes));
    const __m256i shared = _mm256_and_si256(lanes, _mm256_set1_epi32(static_cast<int>(row)));
    return _mm256_cmpeq_epi32(shared, _mm256_setzero_si256());
  }
  static Pair* emit(Mask kept, std::uint32_t row, const std::uint32_t* ids, Pair* out) {
    return emit_bits(static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(kept))), row, ids, out);
  }

 private:
  static Mask greater(Floats x, Floats y) { return _mm256_castps_si256(_mm256_cmp_ps(x, y, _CMP_GT_OQ)); }
};

}  // namespace

template <int D>
std::size_t run_avx2(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps) {
  return run_with<EightLanes>(scan, out, room, steps);
}

template std::size_t run_avx2(Scan<1>&, Pair*, std::size_t, std::size_t&);
template std::size_t run_avx2(Scan<2>&, Pair*, std::size_t, std::size_t&);
template std::size_t run_avx2(Scan<3>&, Pair*, std::size_t, std::size_t&);

}  // namespace foresee::gpcd
#endif
