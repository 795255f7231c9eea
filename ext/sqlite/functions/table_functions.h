// List of the table-valued functions; the file that defines each is named beside it.
#pragma once

#include "sqlite/functions/table_function.h"

namespace foresee {

const TableFunction& foresee_tables();  // foresee_tables.cpp
const TableFunction& geo_to_plane();    // geo_plane.cpp
const TableFunction& plane_to_geo();
const TableFunction& geo_to_globe();  // geo_globe.cpp
const TableFunction& globe_to_geo();
const TableFunction& plan_rows();            // plan/plan_rows.cpp
const TableFunction& predictive_avoid();     // predictive_avoid.cpp
const TableFunction& predictive_join();      // predictive_join.cpp
const TableFunction& predictive_explain();   // predictive_explain.cpp
const TableFunction& predictive_nearest();   // predictive_nearest.cpp
const TableFunction& predictive_position();  // predictive_position.cpp
const TableFunction& predictive_sweep();     // predictive_sweep.cpp
const TableFunction& predictive_track();     // predictive_track.cpp
const TableFunction& predictive_window();    // predictive_window.cpp

// The table-valued functions about watches, one file each.

const TableFunction& predictive_changes();  // predictive_changes.cpp
const TableFunction& predictive_watches();  // predictive_watches.cpp

}  // namespace foresee
