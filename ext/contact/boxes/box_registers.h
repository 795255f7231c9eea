// Vector registers for box_lanes.kernel.cpp, as wide as the instructions for which it is compiled, and rows
// of objects turned into columns in them. Everything here is local to the file that includes it.
#pragma once

#include "contact/boxes/box_lanes.h"

namespace foresee {
namespace {

/// As many numbers as a register holds. Where compilers do not find vector code by themselves, it is written
/// down.
#if defined(__AVX512F__)
constexpr int register_width = 8;
#elif defined(__AVX2__)
constexpr int register_width = 4;
#else
constexpr int register_width = 2;
#endif
using Some [[gnu::vector_size(8 * register_width), gnu::aligned(8), gnu::may_alias]] = double;

// Clang takes what a reference to Some stands for to be aligned: lanes must be.
inline Some& some(double* at) {
  return *reinterpret_cast<Some*>(at);
}
inline const Some& some(const double* at) {
  return *reinterpret_cast<const Some*>(at);
}

/// Some rows, column by column. Columns are put together in registers: many small stores would hold up the
/// wide loads that follow.
template <int Width>
struct SomeRows {
  const double* row[Width];

  explicit SomeRows(const double* const* rows) {
    for (int l = 0; l < Width; ++l) row[l] = rows[l];
  }

  /// D columns from `place` on, into the lanes of each of `out` from `lane` on; none if there is no place.
  template <int D>
  [[gnu::always_inline]] inline void take(int place, double (&out)[D][lanes_width], int lane) const {
    if (place < 0) return;
    for (int j = 0; j < D; ++j) {
      const long i = place + j;
      Some& column = some(&out[j][lane]);
      if constexpr (Width == 8)
        column = Some{row[0][i], row[1][i], row[2][i], row[3][i], row[4][i], row[5][i], row[6][i], row[7][i]};
      else if constexpr (Width == 4)
        column = Some{row[0][i], row[1][i], row[2][i], row[3][i]};
      else
        column = Some{row[0][i], row[1][i]};
    }
  }
};

}  // namespace
}  // namespace foresee
