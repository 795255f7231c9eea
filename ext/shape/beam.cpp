// Gathers rows into the columns that the kernel of beams reads, and runs it.
#include "shape/beam.h"

#include <algorithm>

#include "base/simd.h"
#include "shape/swept_boxes.h"

namespace foresee {
namespace {

template <int D>
const BeamKernels<D>& kernels() {
  return with_simd_in_use(
      []<Simd simd>(Level<simd>) -> const BeamKernels<D>& { return beam_kernels<D, simd>(); });
}

/// Consecutive rows, read one column at a time.
struct Rows {
  const double* first;
  std::size_t size, count;

  void copy(int place, double* column) const {
    const double* from = first + place;
#pragma GCC unroll 8
    for (std::size_t l = 0; l < count; ++l, from += size) column[l] = *from;
  }
  /// Copies a column; one that is not declared is `otherwise` in every row.
  void copy(int place, double* column, double otherwise) const {
    place == Offsets::absent ? static_cast<void>(std::fill_n(column, count, otherwise)) : copy(place, column);
  }
};

/// Fills in the extents of each body below and above its position, at the time at which it is largest.
template <int D>
void copy_extents(const Bodies& bodies, std::size_t first, std::size_t count, const Horizon& horizon,
                  BeamLanes<D>& lanes) {
  const auto copy = [&lanes](std::size_t l, const Extents<D>& extents) {
    for (int k = 0; k < D; ++k) lanes.below[k][l] = -extents.lower[k], lanes.above[k][l] = extents.upper[k];
  };
  if (grows(bodies.layout)) {
    for (std::size_t l = 0; l < count; ++l) copy(l, largest_extents<D>(bodies, first + l, horizon));
    return;
  }
  with_shape(bodies.layout.shape, [&](auto shape) {
    for (std::size_t l = 0; l < count; ++l)
      copy(l, shape.template extents<D>(bodies.row(first + l), bodies.at));
  });
}

/// Computes lives; one for all bodies if neither t nor until is declared.
template <int D>
void find_all_lives(const Rows& rows, const Offsets& at, const Horizon& horizon, BeamLanes<D>& lanes) {
  const bool alike = at.t == Offsets::absent && at.until == Offsets::absent;
  rows.copy(at.t, lanes.t, 0);
  rows.copy(at.until, lanes.until, std::numeric_limits<double>::infinity());
  kernels<D>().find_lives(lanes, alike ? 1 : rows.count, horizon.now, horizon.h);
  if (!alike) return;
  for (double* column : {lanes.from, lanes.to, lanes.reach, lanes.parts, lanes.begin, lanes.end})
    std::fill_n(column, rows.count, column[0]);
}

}  // namespace

template <int D>
void beams(const Bodies& bodies, std::size_t first, std::size_t count, const Horizon& horizon,
           const Vec<D>& margin, BeamLanes<D>& out) {
  const Offsets& at = bodies.at;
  const Rows rows{bodies.row(first), static_cast<std::size_t>(at.size), count};
  for (int k = 0; k < D; ++k) {
    rows.copy(at.x + k, out.x[k]);
    rows.copy(at.v == Offsets::absent ? at.v : at.v + k, out.v[k], 0);
    if (at.a != Offsets::absent) rows.copy(at.a + k, out.a[k]);
  }
  copy_extents(bodies, first, count, horizon, out);
  find_all_lives(rows, at, horizon, out);
  double grow[D];
  std::copy_n(margin.data(), D, grow);
  const auto find = at.a == Offsets::absent ? kernels<D>().find_beams : kernels<D>().find_bent_beams;
  find(out, count, grow);
}

#define FORESEE_OF_AXES(D) \
  template void beams(const Bodies&, std::size_t, std::size_t, const Horizon&, const Vec<D>&, BeamLanes<D>&)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
