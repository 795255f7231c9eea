#include "base/simd.h"

#include <vector>

namespace foresee {
namespace {

#if defined(__x86_64__)
struct Cpuid {
  unsigned a, b, c, d;
};

/// The registers that CPUID returns for `leaf`, subleaf 0. Not __get_cpuid_count of <cpuid.h>: Clang may put
/// its result in the register that holds the subleaf. In a frame of its own, so that rbx is free.
[[gnu::noinline]] Cpuid cpuid(unsigned leaf) {
  Cpuid found;
  asm volatile("cpuid" : "=a"(found.a), "=b"(found.b), "=c"(found.c), "=d"(found.d) : "a"(leaf), "c"(0));
  return found;
}

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
  if (cpuid(0).a < 7 || !(cpuid(1).c & osxsave) || !are_saved(ymm_saved)) return found;
  const unsigned features = cpuid(7).b;
  if (features & avx2) found.push_back(Simd::avx2);
  if (features & avx512f && are_saved(zmm_saved)) found.push_back(Simd::avx512);
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
