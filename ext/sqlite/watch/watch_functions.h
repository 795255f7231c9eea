// The table-valued functions about watches, one file each.
#pragma once

#include "sqlite/functions/table_function.h"

namespace foresee {

const TableFunction& predictive_changes();  // predictive_changes.cpp
const TableFunction& predictive_watches();  // predictive_watches.cpp

}  // namespace foresee
