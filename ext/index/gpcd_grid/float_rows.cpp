#include "index/gpcd_grid/float_rows.h"

#include <array>

namespace foresee::gpcd {
namespace {

constexpr std::size_t chunk = 64;  // beams that stay in the innermost cache
constexpr std::size_t chunks_per_check = 64;

/// A fraction of the horizon as a place in [-1, 1], rounded outward.
float earlier(double fraction) {
  return static_cast<float>(2 * fraction - 1 - 0x1p-22);
}
float later(double fraction) {
  return static_cast<float>(2 * fraction - 1 + 0x1p-22);
}

}  // namespace

template <int D>
FloatRows<D>::FloatRows(const BeamSource<D>& source, const Frame<D>& frame, Columns columns,
                        Buffer<float>& memory, Interrupt& interrupt)
    : columns_(columns), width_(width(columns)), count_(source.count()) {
  float* out = memory.room(count_ * static_cast<std::size_t>(width_));
  values_ = out;
  std::array<Beam<D>, chunk> beams;
  for (std::size_t first = 0; first < count_; first += chunk) {
    if (first % (chunk * chunks_per_check) == 0) interrupt.check();
    const auto some = std::span(beams).first(std::min(chunk, count_ - first));
    source.read(first, some);
    for (const Beam<D>& beam : some) {
      const FloatBox<D> box = frame.round_outward(beam, columns.travel);
      out = std::copy_n(box.lower, D, out);
      out = std::copy_n(box.upper, D, out);
      if (columns.travel)
        for (int axis = 0; axis < D; ++axis) *out++ = frame.travel(beam, axis);
      if (columns.life) *out++ = earlier(beam.begin), *out++ = later(beam.end);
    }
  }
}

template class FloatRows<1>;
template class FloatRows<2>;
template class FloatRows<3>;

}  // namespace foresee::gpcd
