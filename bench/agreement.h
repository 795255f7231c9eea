// Agreement of a rival with foresee: missed pairs, invented pairs, and the error of contact times.
//
//   const Agreement steps = agreement_of(our_times, times_of_steps);
//   steps.missed, steps.invented, steps.off
//
// One time per pair, in seconds from the start; below 0: they never touch.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "contact/contact.h"

namespace foresee::bench {

constexpr double never = -1;

struct Agreement {
  std::size_t missed = 0, invented = 0;
  double off = 0;  ///< at most, in seconds
};

/// The rival may have answered for the first pairs only.
inline Agreement agreement_of(std::span<const double> ours, std::span<const double> rivals) {
  Agreement agreement;
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    if (ours[i] >= 0 && rivals[i] < 0) ++agreement.missed;
    if (ours[i] < 0 && rivals[i] >= 0) ++agreement.invented;
    if (ours[i] >= 0 && rivals[i] >= 0)
      agreement.off = std::max(agreement.off, std::abs(rivals[i] - ours[i]));
  }
  return agreement;
}

/// The times of all pairs, from the hits among them, which are in the same order.
inline std::vector<double> times_of(std::span<const Pair> pairs, std::span<const Pair> hits,
                                    std::span<const ContactTimes> times) {
  std::vector<double> instants(pairs.size(), never);
  for (std::size_t i = 0, hit = 0; i < pairs.size() && hit < hits.size(); ++i)
    if (pairs[i] == hits[hit]) instants[i] = times[hit++].dt;
  return instants;
}

}  // namespace foresee::bench
