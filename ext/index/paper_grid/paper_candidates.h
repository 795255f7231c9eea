// The paper's method as an index: its grid, followed by its tests a to d. Exact times are for contact.
//
//   auto candidates = make_paper_candidates<2>(ships, crates, true, horizon, margin, interrupt);
//
// Guarantee: as candidates.h says, but fewer than all pairs whose swept boxes meet: those that the tests
// leave.
#pragma once

#include "index/candidates.h"

namespace foresee {

/// Pairs within `a`, or with `between` of `a` and `b`. The bodies and `interrupt` must outlive the
/// candidates.
template <int D>
std::unique_ptr<Candidates> make_paper_candidates(const Bodies& a, const Bodies& b, bool between,
                                                  const Horizon& horizon, const Vec<D>& margin,
                                                  Interrupt& interrupt);

}  // namespace foresee
