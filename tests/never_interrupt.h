// Interrupt that never stops a computation, for tests that interrupt nothing.
#pragma once

#include "base/error.h"

namespace foresee::testing {

inline NeverInterrupt never;

}  // namespace foresee::testing
