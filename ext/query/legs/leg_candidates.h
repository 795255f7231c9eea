// Pairs of legs without an index: all pairs of movers, with the legs of each pair merged by time. The plain answer of a
// join with plans, and the candidates of a query of one object.
//
//   LegCandidatesOf sides{.a = Movers(ships), .b = Movers(ships), .each_once = true};
//   auto candidates = make_leg_candidates(std::move(sides), {now, h}, interrupt);
//
// Guarantee: every pair of legs of different movers that exist together at some time of the horizon, once; within one
// scene the two rows of a pair have no order. Cost: a step per leg and pair of movers.
#pragma once

#include <memory>
#include <optional>

#include "index/candidates.h"
#include "query/legs/movers.h"

namespace foresee {

struct LegCandidatesOf {
  Movers a, b;
  bool each_once = false;  ///< pairs within a scene, each once; b is then the same scene
  bool are_one = false;    ///< the sides are one scene: a mover does not meet itself
  std::optional<std::int64_t> only_a = {}, only_b = {};  ///< only movers with this id, on their side
};

std::unique_ptr<Candidates> make_leg_candidates(LegCandidatesOf sides, const Horizon& horizon,
                                                Interrupt& interrupt);

}  // namespace foresee
