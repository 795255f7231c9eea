// Interrupt that stops a computation at a check that the test chooses.
//
//   StopAt stop(3);                                      // three checks pass, the fourth throws Interrupted
//   EXPECT_THROW(PaperGrid<2>(boxes, stop), Interrupted);
#pragma once

#include "base/error.h"

namespace foresee::testing {

struct StopAt final : Interrupt {
  explicit StopAt(int passing) : checks_left(passing) {}
  void check() override {
    if (--checks_left < 0) throw Interrupted();
  }
  int checks_left;
};

}  // namespace foresee::testing
