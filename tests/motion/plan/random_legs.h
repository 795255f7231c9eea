// Legs of random plans, with stops, jumps, gaps and numbers of every size; texts of plans without an interrupt.
#pragma once

#include <cmath>
#include <vector>

#include "base/error.h"
#include "motion/plan/plan_text.h"
#include "numbers/rationals.h"

namespace foresee::testing {

/// Straight or bent legs on up to three axes; `wild`: numbers of any size. The last leg may have no end.
inline std::vector<Leg> random_legs(judge::Inputs& inputs, int count, bool bent, bool wild) {
  std::vector<Leg> legs;
  double t = wild ? inputs.number(-30, 40) : inputs.number(-3, 6);
  for (int i = 0; i < count; ++i) {
    Leg leg{.t = t};
    const double step = wild               ? std::abs(inputs.number(-60, 40))
                        : inputs.one_in(9) ? 0
                                           : std::abs(inputs.number(-3, 3));
    leg.until = i + 1 == count && inputs.one_in(4) ? no_end : t + step;
    for (std::size_t j = 0; j < 3; ++j) {
      leg.x[j] = i > 0 && !inputs.one_in(6) ? legs.back().x[j] + inputs.number(-6, 6) : inputs.number(-9, 9);
      if (wild) leg.x[j] = inputs.one_in(20) ? inputs.any_double() : inputs.number(-60, 60);
      if (!inputs.one_in(5)) leg.v[j] = wild ? inputs.number(-60, 60) : inputs.number(-4, 4);
      if (bent && !inputs.one_in(3)) leg.a[j] = wild ? inputs.number(-60, 60) : inputs.number(-4, 3);
    }
    legs.push_back(leg);
    t = std::isfinite(leg.until) ? leg.until : t;
    if (inputs.one_in(8)) t += std::abs(inputs.number(-2, 5));
  }
  return legs;
}

inline Plan read_plan(std::string_view text, WktUnit unit = WktUnit::metres) {
  NeverInterrupt never;
  return foresee::read_plan(text, never, unit);
}

inline std::string write_plan(const Plan& plan) {
  NeverInterrupt never;
  return foresee::write_plan(plan, never);
}

}  // namespace foresee::testing
