// Vector registers of the scan kernel, as wide as the including file's instruction set: floats, and masks
// from comparisons. Local to that file.
#pragma once

#include "index/gpcd_grid/scan.h"

#if defined(__AVX2__) || defined(__AVX512F__)
#include <immintrin.h>
#elif defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace foresee::gpcd {
namespace {

/// Writes the pair of `row` and each lane whose bit is set, in ascending order.
[[gnu::always_inline]] inline Pair* emit_bits(unsigned bits, std::uint32_t row, const std::uint32_t* ids,
                                              Pair* out) {
  for (; bits != 0; bits &= bits - 1) *out++ = {row, ids[__builtin_ctz(bits)]};
  return out;
}

#if defined(__AVX512F__)
/// Stores pairs without a branch.
struct SixteenLanes {
  static constexpr std::size_t width = 16;
  using Floats = __m512;
  using Mask = __mmask16;

  static Floats all(float x) { return _mm512_set1_ps(x); }
  static Floats load(const float* x) { return _mm512_loadu_ps(x); }
  static Floats abs(Floats x) { return _mm512_abs_ps(x); }
  // Masked, because GCC 12 warns about its own header for the unmasked ones.
  static Floats max(Floats x, Floats y) { return _mm512_mask_max_ps(x, 0xffff, x, y); }
  static Floats min(Floats x, Floats y) { return _mm512_mask_min_ps(x, 0xffff, x, y); }
  static Mask and_greater(Mask kept, Floats x, Floats y) {
    return _mm512_mask_cmp_ps_mask(kept, x, y, _CMP_GT_OQ);
  }
  static Mask but_greater(Mask kept, Floats x, Floats y) {
    return _mm512_mask_cmp_ps_mask(kept, x, y, _CMP_NGT_UQ);
  }
  static Mask but(Mask kept, Mask others) { return static_cast<Mask>(kept & ~others); }
  static Mask sharing(Mask kept, const std::uint32_t* bits, std::uint32_t row) {
    return _mm512_mask_test_epi32_mask(kept, _mm512_loadu_si512(bits),
                                       _mm512_set1_epi32(static_cast<int>(row)));
  }
  static Mask unshared(const std::uint32_t* classes, std::uint32_t row) {
    return _mm512_testn_epi32_mask(_mm512_loadu_si512(classes), _mm512_set1_epi32(static_cast<int>(row)));
  }
  /// Compresses the kept ids to the front, interleaves them with the row, and stores all sixteen pairs; the
  /// next call overwrites the surplus.
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
using Vector = SixteenLanes;
#elif defined(__AVX2__)
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
  static Mask sharing(Mask kept, const std::uint32_t* bits, std::uint32_t row) {
    return but(kept, unshared(bits, row));
  }
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
using Vector = EightLanes;
#else
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
  static Mask sharing(Mask kept, const std::uint32_t* bits, std::uint32_t row) {
    return but(kept, unshared(bits, row));
  }
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
using Vector = FourLanes;
#endif

}  // namespace
}  // namespace foresee::gpcd
