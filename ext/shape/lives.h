// Do all objects exist for as long as the horizon asks about them? Who need not look at single lives saves
// that.
//
//   all_exist_at_begin(ships, {.now = 600, .h = 300}, interrupt)
//
// Cost: one pass over the rows, up to the first body that does not; none where the layout says it.
#pragma once

#include "base/error.h"
#include "shape/bodies.h"

namespace foresee {

/// Whether every body that exists during the horizon is there when it begins.
bool all_exist_at_begin(const Bodies& bodies, const Horizon& horizon, Interrupt& interrupt);

/// Whether every body that exists during the horizon does so at each of its moments.
bool all_exist_throughout(const Bodies& bodies, const Horizon& horizon, Interrupt& interrupt);

}  // namespace foresee
