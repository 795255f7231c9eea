// Nobody who asks a computation to stop: what a test passes where it interrupts nothing.
#pragma once

#include "base/error.h"

namespace foresee::testing {

inline NeverInterrupt never;

}  // namespace foresee::testing
