// Where the objects behind the beams lie, for whoever asks about pairs next. Anywhere in memory: a scan
// computes more than it reads, so it asks for them early, and never reads them.
#pragma once

#include <cstddef>

namespace foresee::gpcd {

struct ObjectRows {
  const char* first = nullptr;  ///< null: nobody will ask
  std::size_t bytes = 0;        ///< from one to the next
};

}  // namespace foresee::gpcd
