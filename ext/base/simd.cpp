#include "base/simd.h"

#include <vector>

namespace foresee {
namespace {

std::vector<Simd> detect() {
  std::vector<Simd> found{Simd::baseline};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) found.push_back(Simd::avx2);
  if (__builtin_cpu_supports("avx512f")) found.push_back(Simd::avx512);
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
