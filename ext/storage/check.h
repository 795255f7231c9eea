// Is what the shadow tables say consistent? 'integrity-check' and its SQLite 3.44 counterpart.
//
// Looks at every byte: each leaf's checksum and contents, no id twice, map and leaves agree both ways, one
// auxiliary row an object. Cost: one pass over the tables and 16 bytes an object.
#pragma once

#include <string>
#include <vector>

#include "motion/error.h"
#include "storage/shadow_rows.h"

namespace foresee {

/// What is wrong, a sentence each, at most some hundred; empty: nothing. Requires: nothing is pending.
std::vector<std::string> check_tables(ShadowRows& rows, const NodeFormat& format, const QualifiedName& name,
                                      bool has_auxiliaries, Interrupt& interrupt);

}  // namespace foresee
