// Modes of bench_sql_plans; sql_plans.cpp describes them.
#pragma once

#include "program.h"

namespace foresee::bench {

void measure_values(const Options& options);
void measure_movers(const Options& options);
void measure_satellites(const Options& options);
void measure_waits(const Options& options);

}  // namespace foresee::bench
