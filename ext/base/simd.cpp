#include "base/simd.h"

#include <vector>

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace foresee {
namespace {

#if defined(__x86_64__)
/// Is each bit of `mask` set in XCR0: does the operating system save these registers?
bool are_saved(unsigned mask) {
  unsigned low, high;
  asm("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return (low & mask) == mask;
}
#endif

// Reads the CPUID registers: __builtin_cpu_supports needs a variable that some runtimes of compilers lack.
std::vector<Simd> detect() {
  std::vector<Simd> found{Simd::baseline};
#if defined(__x86_64__)
  constexpr unsigned osxsave = 1 << 27, avx2 = 1 << 5, avx512f = 1 << 16;
  constexpr unsigned ymm_saved = 0x6, zmm_saved = 0xe6;
  unsigned a, b, c, d;
  if (!__get_cpuid(1, &a, &b, &c, &d) || !(c & osxsave) || !are_saved(ymm_saved)) return found;
  if (!__get_cpuid_count(7, 0, &a, &b, &c, &d)) return found;
  if (b & avx2) found.push_back(Simd::avx2);
  if (b & avx512f && are_saved(zmm_saved)) found.push_back(Simd::avx512);
#endif
  return found;
}

Simd& chosen() {
  static Simd simd = available_simd().back();
  return simd;
}

}  // namespace

const char* name_of(Simd simd) {
  if (simd == Simd::avx512) return "AVX-512";
  if (simd == Simd::avx2) return "AVX2";
#if defined(__SSE4_2__)
  return "SSE4.2";
#elif defined(__SSE2__)
  return "SSE2";
#elif defined(__ARM_NEON)
  return "NEON";
#else
  return "none";
#endif
}

std::span<const Simd> available_simd() {
  static const std::vector<Simd> found = detect();
  return found;
}

Simd simd_in_use() {
  return chosen();
}

void use_simd(Simd simd) {
  chosen() = simd;
}

}  // namespace foresee
