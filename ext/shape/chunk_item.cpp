#include "shape/chunk_item.h"

#include <algorithm>
#include <limits>

#include "base/axes.h"
#include "base/float_environment.h"
#include "motion/plan/chunks.h"
#include "shape/shapes.h"

namespace foresee {
namespace {

/// The box of these legs around the path of an item.
ChunkBox box_along(const double* item, const Offsets& at, std::span<const Leg> legs, int axes) {
  ChunkBox box{.t = item[at.t], .until = legs.back().until};
  std::copy_n(item + at.x, axes, box.x.begin());
  std::copy_n(item + at.v, axes, box.v.begin());
  box.half = half_extents_around(box, legs, axes);
  box.t = legs.front().t;
  return box;
}

}  // namespace

void write_leg(const Offsets& at, int axes, const Leg& leg, double* numbers) {
  numbers[at.t] = leg.t;
  std::copy_n(leg.x.begin(), axes, numbers + at.x);
  std::copy_n(leg.v.begin(), axes, numbers + at.v);
  if (at.a != Offsets::absent) std::copy_n(leg.a.begin(), axes, numbers + at.a);
}

void write_chunk_item(const Layout& layout, const double* record, std::span<const Leg> legs, double* item,
                      const double* given) {
  const FloatEnvironment environment;
  const Offsets from = record_offsets(layout), at = record_offsets(chunk_layout(layout));
  Leg cut;
  if (legs.back().until == no_end && record[from.until] < no_end && legs.back().t <= record[from.until]) {
    cut = legs.back(), cut.until = record[from.until];  // a leg without end is a chunk of its own
    legs = {&cut, 1};
  }
  const ChunkBox box = given ? box_along(given, at, legs, layout.axes) : chunk_box(legs, layout.axes);
  item[at.t] = box.t;
  item[at.until] = std::max(box.t, std::min(box.until, record[from.until]));
  with_axes(layout.axes, [&]<int D>(Axes<D>) {
    const Vec<D> reach = reach_of(extents_of<D>(layout.shape, record, from));
    for (int axis = 0; axis < D; ++axis) {
      const auto j = static_cast<std::size_t>(axis);
      item[at.x + axis] = box.x[j], item[at.v + axis] = box.v[j];
      // The tree takes finite sizes; the largest one is no bound to it.
      item[at.half + axis] =
          std::min(sum_outward(box.half[j], reach[axis]), std::numeric_limits<double>::max());
    }
  });
  if (at.category != Offsets::absent) item[at.category] = record[from.category];
  if (at.mask != Offsets::absent) item[at.mask] = record[from.mask];
}

}  // namespace foresee
