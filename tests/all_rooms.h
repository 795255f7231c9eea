// Tests and benchmarks look at the rooms from outside and know the names of all (base/rooms.h). A test of one
// room may stand in that room's namespace instead.
#pragma once

#include "base/rooms.h"

namespace foresee {

namespace testing {
using namespace sqlite;
}
namespace bench {
using namespace sqlite;
}

}  // namespace foresee
