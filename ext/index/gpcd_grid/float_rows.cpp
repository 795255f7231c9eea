#include "index/gpcd_grid/float_rows.h"

namespace foresee::gpcd {
namespace {

/// Columns of lanes as rows of `width` floats.
template <int width>
void write_rows(const float* const* columns, std::size_t count, float* out) {
  for (std::size_t l = 0; l < count; ++l, out += width)
    for (int k = 0; k < width; ++k) out[k] = columns[k][l];
}

}  // namespace

template <int D>
void FloatRows<D>::write(std::size_t first, const FloatLanes<D>& lanes, std::size_t count) {
  const float* columns[3 * D + 2];
  for (int k = 0; k < D; ++k)
    columns[k] = lanes.lower[k], columns[D + k] = lanes.upper[k], columns[2 * D + k] = lanes.travel[k];
  columns[3 * D] = lanes.begin, columns[3 * D + 1] = lanes.end;
  float* out = values_ + first * width_;
  if (columns_.life)
    write_rows<3 * D + 2>(columns, count, out);
  else if (columns_.travel)
    write_rows<3 * D>(columns, count, out);
  else
    write_rows<2 * D>(columns, count, out);
}

template class FloatRows<1>;
template class FloatRows<2>;
template class FloatRows<3>;

}  // namespace foresee::gpcd
