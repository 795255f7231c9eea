// Vector registers for kernels (base/simd.h), as wide as the instructions for which they are compiled. Where
// compilers do not find vector code by themselves, it is written down with these. Everything here is local to
// the file that includes it.
#pragma once

namespace foresee {
namespace {

/// As many numbers as a register holds.
#if defined(__AVX512F__)
constexpr int register_width = 8;
#elif defined(__AVX2__)
constexpr int register_width = 4;
#else
constexpr int register_width = 2;
#endif
using Register [[gnu::vector_size(8 * register_width), gnu::aligned(8), gnu::may_alias]] = double;

// Clang takes what a reference to Some stands for to be aligned: lanes must be.
inline void store(double* at, const Register& value) {
  *reinterpret_cast<Register*>(at) = value;
}
inline const Register& load(const double* at) {
  return *reinterpret_cast<const Register*>(at);
}

/// What each of some rows has at `place`. Put together in a register: many small stores would hold up the
/// wide loads that follow.
inline Register column(const double* const* row, long place) {
#if defined(__AVX512F__)
  return Register{row[0][place], row[1][place], row[2][place], row[3][place],
                  row[4][place], row[5][place], row[6][place], row[7][place]};
#elif defined(__AVX2__)
  return Register{row[0][place], row[1][place], row[2][place], row[3][place]};
#else
  return Register{row[0][place], row[1][place]};
#endif
}

}  // namespace
}  // namespace foresee
