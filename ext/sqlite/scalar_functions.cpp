// Scalar SQL functions: foresee_version(), foresee_debug() and geo_distance(); those of plans have files of their own.
#include <cmath>
#include <exception>

#include "base/float_environment.h"
#include "database/value_text.h"
#include "geography/geodesic.h"
#include "sqlite/callback.h"
#include "sqlite/functions/geo/geo_inputs.h"
#include "sqlite/functions/plan/plan_functions.h"
#include "sqlite/modules.h"
#include "sqlite/version.h"

namespace foresee {
namespace {

void foresee_version(sqlite3_context* context, int, sqlite3_value**) {
  sqlite3_result_text(context, version(), -1, SQLITE_STATIC);
}

void foresee_debug(sqlite3_context* context, int, sqlite3_value**) {
  try {
    const std::string report = debug_report();
    sqlite3_result_text(context, report.c_str(), static_cast<int>(report.size()), SQLITE_TRANSIENT);
  } catch (const std::exception&) {
    sqlite3_result_error_nomem(context);
  }
}

/// geo_distance(lat1, lon1, lat2, lon2): metres; NULL if an input is NULL.
void geo_distance(sqlite3_context* context, int, sqlite3_value** values) {
  static constexpr const char* names[] = {"lat1", "lon1", "lat2", "lon2"};
  report_by_name(context, "geo_distance", [&] {
    double numbers[4];
    for (int i = 0; i < 4; ++i) {
      const int type = sqlite3_value_numeric_type(values[i]);
      if (type == SQLITE_NULL) return;
      numbers[i] = sqlite3_value_double(values[i]);
      if ((type != SQLITE_INTEGER && type != SQLITE_FLOAT) || !std::isfinite(numbers[i]))
        throw Error(std::string(names[i]) + " must be a number of degrees, not " + shown(values[i]));
      if (i % 2 == 0) require_latitude(numbers[i], names[i]);
    }
    const FloatEnvironment environment;
    const Geodesic line = geodesic_between({numbers[0], numbers[1]}, {numbers[2], numbers[3]});
    sqlite3_result_double(context, line.distance);
  });
}

}  // namespace

int register_scalars(sqlite3* db) {
  constexpr int flags = SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_INNOCUOUS;
  int rc =
      sqlite3_create_function(db, "foresee_version", 0, flags, nullptr, foresee_version, nullptr, nullptr);
  if (rc != SQLITE_OK) return rc;
  rc = sqlite3_create_function(db, "foresee_debug", 0, flags, nullptr, foresee_debug, nullptr, nullptr);
  if (rc != SQLITE_OK) return rc;
  rc = sqlite3_create_function(db, "geo_distance", 4, flags, nullptr, geo_distance, nullptr, nullptr);
  return rc == SQLITE_OK ? register_plan_functions(db) : rc;
}

}  // namespace foresee
