// Identification of the build: version, commit, compiler, SIMD level.
#pragma once

#include <string>

namespace foresee {

/// The version as SQL reports it, e.g. "0.2.0".
const char* version();

/// Version, commit, compiler, SIMD in use and SQLite, one per line.
std::string debug_report();

}  // namespace foresee
