// Real ships as a workload: the newest AIS report of each ship in a file of NOAA's layout.
//
//   const Workload ships = real_ships("sql/data/new_york_20220103.csv", 463, 600);
#pragma once

#include <string>

#include "workloads.h"

namespace foresee::bench {

/// Discs of this radius in metres, on the plane about the middle of the harbour, moved on to the time of the
/// newest report; joined over h seconds. Discs of half a distance touch where two ships come within it. A
/// ship without a course lies still. Throws Error for a file that is not there or has other columns.
Workload real_ships(const std::string& path, double radius, double h);

}  // namespace foresee::bench
