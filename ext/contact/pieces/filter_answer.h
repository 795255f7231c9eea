// What plain doubles tell of a pair at once, without its stays.
#pragma once

#include "contact/certain/advancement.h"

namespace foresee {

struct FilterAnswer {
  Verdict touches = Verdict::uncertain;
  bool at_start = false;   ///< they surely touch when what is asked about begins
  bool all_along = false;  ///< and until it ends
};

}  // namespace foresee
