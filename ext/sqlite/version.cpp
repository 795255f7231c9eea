#include "sqlite/version.h"

#include "storage/sqlite_api.h"

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
#if defined(__AVX2__)
  report += "\nSIMD: AVX2";
#elif defined(__SSE4_2__)
  report += "\nSIMD: SSE4.2";
#elif defined(__ARM_NEON)
  report += "\nSIMD: NEON";
#else
  report += "\nSIMD: baseline";
#endif
  report += std::string("\nSQLite: ") + sqlite3_libversion();
  return report;
}

}  // namespace foresee
