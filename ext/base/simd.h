// Run-time selection of the vector instructions (SSE, AVX2, AVX-512) that kernels use.
//
// The widest instruction set of the CPU is chosen once; results do not depend on it. `baseline` is the
// build's own target: plain C++ on four lanes, which compilers turn into SSE or NEON.
//
// A kernel is a file named *.kernel.cpp. It holds loops and a table of pointers to them, and is compiled once
// per Simd; FORESEE_SIMD names the one. Its header declares the table,
//
//   template <int D, Simd simd>
//   const BeamKernels<D>& beam_kernels();                // defined in beam.kernel.cpp
//
// and the caller takes the table of the instruction set in use:
//
//   with_simd_in_use([&]<Simd simd>(Level<simd>) {
//     beam_kernels<2, simd>().find_lives(lanes, count, now, h);
//   });
//
// All else in a kernel is local to the file and made of built-in types: a function shared with code for older
// CPUs must not be emitted with newer instructions.
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

namespace foresee {

enum class Simd : std::uint8_t { baseline, avx2, avx512 };

/// The common name: "AVX2".
const char* name_of(Simd simd);

/// The levels that this build has and this CPU can run, narrowest first; always includes the baseline.
std::span<const Simd> available_simd();

/// The widest available, unless a test has chosen another.
Simd simd_in_use();

template <Simd simd>
using Level = std::integral_constant<Simd, simd>;

/// Calls use(Level<simd_in_use()>{}).
template <class Use>
decltype(auto) with_simd_in_use(Use&& use) {
#if defined(__x86_64__)
  if (simd_in_use() == Simd::avx512) return use(Level<Simd::avx512>{});
  if (simd_in_use() == Simd::avx2) return use(Level<Simd::avx2>{});
#endif
  return use(Level<Simd::baseline>{});
}

/// For tests: computations that start from now on use `simd`, which must be available. Not thread-safe.
void use_simd(Simd simd);

}  // namespace foresee
