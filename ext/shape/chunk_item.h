// Legs of a plan among the doubles of objects: the motion of a leg in a record, and the item of a tree of chunks.
//
//   write_leg(record_offsets(ships), ships.axes, legs[0], record);     // an object starts as its first leg
//   std::vector<double> item(static_cast<std::size_t>(record_offsets(chunk_layout(ships)).size));
//   write_chunk_item(ships, record, legs, item.data());                // legs of one chunk (motion/plan/chunks.h)
//
// An item is the moving box around some legs, with the whole shape of their object.
// Guarantee: at every time of a leg at which the object exists, its shape is within the box of the item, for the real
// numbers that these doubles are. The item ends where the object's `until` cuts the last leg, and never before it
// starts. Kinds are those of the object. Cost: that of chunk_box().
#pragma once

#include <span>

#include "motion/plan/plan.h"
#include "shape/row_layout.h"

namespace foresee {

/// Writes t, x, v and a of a leg to their places in a record or row. Requires: a layout with plans.
void write_leg(const Offsets& at, int axes, const Leg& leg, double* numbers);

/// `record`: of the object, record_offsets(layout). `item`: filled, record_offsets(chunk_layout(layout)).
/// `given`: null, or an item whose place, velocity and t the box has, instead of those of chunk_box().
/// Requires: a layout with plans; at least one leg.
void write_chunk_item(const Layout& layout, const double* record, std::span<const Leg> legs, double* item,
                      const double* given = nullptr);

}  // namespace foresee
