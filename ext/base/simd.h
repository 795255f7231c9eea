// Which vector instructions does this CPU have, and which are used?
//
// The widest are chosen once; answers do not depend on them. `baseline` is what the build was made for: plain
// C++ on four lanes, which compilers turn into SSE or NEON.
//
// A kernel is a file named *.kernel.cpp: loops that are compiled once for each Simd, with FORESEE_SIMD
// telling which, and a table of pointers to them. Its header declares the table,
//
//   template <int D, Simd simd>
//   const BeamKernels<D>& beam_kernels();                // defined in beam.kernel.cpp
//
// and whoever computes asks for the one in use:
//
//   with_simd_in_use([&]<Simd simd>(Level<simd>) {
//     beam_kernels<2, simd>().find_lives(lanes, count, now, h);
//   });
//
// All else in such a file is local to it and made of built-in types: a function shared with code for older
// CPUs must not be emitted with newer instructions.
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

namespace foresee {

enum class Simd : std::uint8_t { baseline, avx2, avx512 };

/// "AVX2", as people write it.
const char* name_of(Simd simd);

/// What this build has and this CPU can run, narrowest first; the baseline always.
std::span<const Simd> available_simd();

/// The widest available, unless a test has chosen another.
Simd simd_in_use();

template <Simd simd>
using Level = std::integral_constant<Simd, simd>;

/// use(Level<simd_in_use()>{}).
template <class Use>
decltype(auto) with_simd_in_use(Use&& use) {
#if defined(__x86_64__)
  if (simd_in_use() == Simd::avx512) return use(Level<Simd::avx512>{});
  if (simd_in_use() == Simd::avx2) return use(Level<Simd::avx2>{});
#endif
  return use(Level<Simd::baseline>{});
}

/// For tests: what starts from now on uses `simd`, which must be available. Not for use beside other
/// threads.
void use_simd(Simd simd);

}  // namespace foresee
