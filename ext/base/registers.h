// SIMD registers of doubles for kernels (base/simd.h), as wide as the instruction set of the file allows.
//
// For loops that compilers do not vectorize automatically. All here is local to the file that includes it.
#pragma once

namespace foresee {
namespace {

/// Doubles per register.
#if defined(__AVX512F__)
constexpr int register_width = 8;
#elif defined(__AVX2__)
constexpr int register_width = 4;
#else
constexpr int register_width = 2;
#endif
using Register [[gnu::vector_size(8 * register_width), gnu::aligned(8), gnu::may_alias]] = double;

// Clang assumes that a reference to Register is aligned: lanes must be, and a value is passed as such.
inline void store(double* at, Register value) {
  *reinterpret_cast<Register*>(at) = value;
}
inline const Register& load(const double* at) {
  return *reinterpret_cast<const Register*>(at);
}

/// The value at `place` of each of `register_width` rows, gathered in a register. Many narrow stores would
/// stall the wide loads that follow.
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
