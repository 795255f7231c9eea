// Which vector instructions does this CPU have, and which are used?
//
// The widest are chosen once; answers do not depend on them. `baseline` is what the build was made for: plain
// C++ on four lanes, which compilers turn into SSE or NEON.
#pragma once

#include <cstdint>
#include <span>

namespace foresee {

enum class Simd : std::uint8_t { baseline, avx2, avx512 };

/// "AVX2", as people write it.
const char* name_of(Simd simd);

/// What this build has and this CPU can run, narrowest first; the baseline always.
std::span<const Simd> available_simd();

/// The widest available, unless a test has chosen another.
Simd simd_in_use();

/// For tests: what starts from now on uses `simd`, which must be available. Not for use beside other
/// threads.
void use_simd(Simd simd);

}  // namespace foresee
