// Which build is this?
#pragma once

#include <string>

#include "base/rooms.h"

namespace foresee::sqlite {

/// The version as SQL reports it, e.g. "0.2.0".
const char* version();

/// Version, commit, compiler, SIMD in use and SQLite, one a line.
std::string debug_report();

}  // namespace foresee::sqlite
