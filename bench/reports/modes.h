// The modes of bench_sql_reports, one file each; sql_reports.cpp describes what they measure.
#pragma once

#include <string>
#include <vector>

#include "program.h"

namespace foresee::bench {

/// Every mode prints as it goes and throws Error where two sides that must agree do not.
void measure_updates(const Options& options);
void measure_commits(const Options& options);
void measure_loads(const Options& options);
void measure_lookups(const Options& options);
void measure_after(const Options& options);
void measure_lives(const Options& options);
void measure_planner(const Options& options);
void measure_degrees(const Options& options);

}  // namespace foresee::bench
