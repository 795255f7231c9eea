// The table-valued functions, one file each.
#pragma once

#include "sqlite/functions/table_function.h"

namespace foresee::sqlite {

const TableFunction& predictive_join();      // predictive_join.cpp
const TableFunction& predictive_explain();   // predictive_explain.cpp
const TableFunction& predictive_nearest();   // predictive_nearest.cpp
const TableFunction& predictive_position();  // predictive_position.cpp
const TableFunction& predictive_window();    // predictive_window.cpp

}  // namespace foresee::sqlite
