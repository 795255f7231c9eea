// Refinement stage of the paper (step 22) on soldiers: its objects as meshes of 240 triangles, made by a
// seed, in place of boxes of 5 x 5 x 5.
//
//   const std::vector<ExplainRow> rows = explain_soldiers({.count = 5000}, never);  // the last is refinement
#pragma once

#include <vector>

#include "query/join/explain.h"
#include "workloads.h"

namespace foresee::bench {

/// The stages of the join of the paper's scene with itself, its objects turned by headings of their own.
std::vector<ExplainRow> explain_soldiers(const PaperScene& paper, Interrupt& interrupt);

}  // namespace foresee::bench
