#include "shape/row_layout.h"

#include <algorithm>
#include <limits>

#include "shape/shapes.h"

namespace foresee {
namespace {

Offsets offsets_of(const Layout& layout, bool stored) {
  Offsets at;
  int next = 0;
  auto take = [&next](int places) {
    const int place = next;
    next += places;
    return place;
  };
  if (layout.has_t) at.t = take(1);
  at.x = take(layout.axes);
  if (layout.law != Law::rest) at.v = take(layout.axes);
  if (layout.law == Law::forced && stored) {
    at.force = take(layout.axes);
    at.mass = take(1);
  } else if (layout.law == Law::accelerated || layout.law == Law::forced) {
    at.a = take(layout.axes);
  }
  for_each_size(layout, [&](const SizeColumn& column) {
    at.*column.place = take(column.on_all_axes ? layout.axes : 1);
  });
  if (is_stored_apart(layout.shape)) {
    at.outline = take(1);
    if (layout.has_heading) at.heading = take(1);
    at.bounds = take(2 * bounded_axes(layout.shape));
  }
  if (layout.has_until) at.until = take(1);
  if (layout.has_category) at.category = take(1);
  if (layout.has_mask) at.mask = take(1);
  if (layout.has_plan && stored) at.plan = take(1), at.chunks = take(1);
  at.size = next;
  return at;
}

}  // namespace

Offsets record_offsets(const Layout& layout) {
  return offsets_of(layout, true);
}

Offsets row_offsets(const Layout& layout) {
  return offsets_of(layout, false);
}

Layout chunk_layout(const Layout& layout) {
  return {.axes = layout.axes,
          .law = Law::uniform,
          .shape = Shape::box,
          .has_t = true,
          .has_until = true,
          .has_category = layout.has_category,
          .has_mask = layout.has_mask};
}

void row_from_record(const Layout& layout, const double* record, double* row) {
  const Offsets from = record_offsets(layout);
  if (layout.law != Law::forced) {
    std::copy_n(record, layout.has_plan ? from.plan : from.size, row);
    if (has_plan(from, record)) row[from.until] = -std::numeric_limits<double>::infinity();
    return;
  }
  const Offsets to = row_offsets(layout);
  std::copy_n(record, from.force, row);
  for (int axis = 0; axis < layout.axes; ++axis)
    row[to.a + axis] = record[from.force + axis] / record[from.mass];
  std::copy(record + from.mass + 1, record + from.size, row + to.a + layout.axes);
}

}  // namespace foresee
