// The paper's method as an index: its grid, followed by its tests a to d. The contact module computes exact
// times.
//
//   auto candidates = make_paper_candidates<2>(ships, crates, true, horizon, margin, interrupt);
//
// Guarantee: as in candidates.h. Pairs whose swept boxes meet are omitted if one of the tests rejects them.
#pragma once

#include "index/candidates.h"

namespace foresee {

/// Pairs within `a`, or between `a` and `b` if `between`. The bodies and `interrupt` must outlive the
/// candidates.
template <int D>
std::unique_ptr<Candidates> make_paper_candidates(const Bodies& a, const Bodies& b, bool between,
                                                  const Horizon& horizon, const Vec<D>& margin,
                                                  Interrupt& interrupt);

}  // namespace foresee
