#include "sqlite/version.h"

#include "base/simd.h"
#include "database/sqlite_api.h"

namespace foresee {

const char* version() {
  return FORESEE_VERSION;
}

std::string debug_report() {
  std::string report = std::string("Version: ") + FORESEE_VERSION + "\nCommit: " + FORESEE_COMMIT;
#if defined(__clang__)
  report += "\nCompiler: Clang " __clang_version__;
#else
  report += "\nCompiler: GCC " __VERSION__;
#endif
  report += std::string("\nSIMD: ") + name_of(simd_in_use());
  report += std::string("\nSQLite: ") + sqlite3_libversion();
  return report;
}

}  // namespace foresee
