// Item of a tree of chunks: the moving box around some legs of a plan, with the whole shape of their object.
//
//   std::vector<double> item(static_cast<std::size_t>(record_offsets(chunk_layout(ships)).size));
//   write_chunk_item(ships, record, legs, item.data());                // legs of one chunk (motion/plan/chunks.h)
//
// Guarantee: at every time of a leg at which the object exists, its shape is within the box of the item, for the real
// numbers that these doubles are. The item ends where the object's `until` cuts the last leg, and never before it
// starts. Kinds are those of the object. Cost: that of chunk_box().
#pragma once

#include <span>

#include "motion/plan/plan.h"
#include "shape/row_layout.h"

namespace foresee {

/// `record`: of the object, record_offsets(layout). `item`: filled, record_offsets(chunk_layout(layout)).
/// `given`: null, or an item whose place, velocity and t the box has, instead of those of chunk_box().
/// Requires: a layout with plans; at least one leg.
void write_chunk_item(const Layout& layout, const double* record, std::span<const Leg> legs, double* item,
                      const double* given = nullptr);

}  // namespace foresee
