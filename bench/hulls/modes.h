// The modes of bench_sql_outlines; sql_outlines.cpp describes what they measure.
#pragma once

#include "program.h"

namespace foresee::bench {

/// Every mode prints as it goes.
void measure_hull_writes(bool quick);
void measure_hull_joins(bool quick);
void measure_zones(bool quick);
/// `file`: the database that real_hulls.sh makes.
void measure_real_hulls(const std::string& file, bool quick);

}  // namespace foresee::bench
