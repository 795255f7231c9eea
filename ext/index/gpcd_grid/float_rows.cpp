#include "index/gpcd_grid/float_rows.h"

#include <array>

#include "index/together.h"

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
                        Buffer<float>& memory, std::size_t helpers, Interrupt& interrupt)
    : columns_(columns), width_(width(columns)), count_(source.count()) {
  float* values = memory.room(count_ * static_cast<std::size_t>(width_));
  values_ = values;
  run_together(helpers, interrupt, [&](std::size_t part, std::size_t parts, Interrupt& asked) {
    const std::size_t begin = part * count_ / parts, end = (part + 1) * count_ / parts;
    fill(source, frame, begin, end, values + begin * static_cast<std::size_t>(width_), asked);
  });
}

template <int D>
void FloatRows<D>::fill(const BeamSource<D>& source, const Frame<D>& frame, std::size_t begin,
                        std::size_t end, float* out, Interrupt& interrupt) const {
  std::array<Beam<D>, chunk> beams;
  std::size_t chunks = 0;
  for (std::size_t first = begin; first < end; first += chunk) {
    if (chunks++ % chunks_per_check == 0) interrupt.check();
    const auto some = std::span(beams).first(std::min(chunk, end - first));
    source.read(first, some);
    for (const Beam<D>& beam : some) {
      const FloatBox<D> box = frame.round_outward(beam, columns_.travel);
      out = std::copy_n(box.lower, D, out);
      out = std::copy_n(box.upper, D, out);
      if (columns_.travel)
        for (int axis = 0; axis < D; ++axis) *out++ = frame.travel(beam, axis);
      if (columns_.life) *out++ = earlier(beam.begin), *out++ = later(beam.end);
    }
  }
}

template class FloatRows<1>;
template class FloatRows<2>;
template class FloatRows<3>;

}  // namespace foresee::gpcd
