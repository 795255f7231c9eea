// The oracle of contact: Sturm sequences over exact numbers, slow and simple, which shares no code with the
// engine.
//
// Contact is a distance here. On every axis the pair is below, inside or above the box around the origin, and
// the sum of the squared excesses is compared with R^2. The times at which an axis changes between the three
// split the lifetime into intervals, each with one polynomial that decides contact. The roots of that
// polynomial within the interval are isolated and separated exactly from its ends. Then the intervals are
// visited in order of time.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "contact/pair_by_hand.h"
#include "contact/sturm.h"

namespace foresee::oracle {

/// Centre of b minus centre of a on one axis, as a polynomial in the time since `now`.
Coefficients relative_axis(const testing_by_hand::Object& a, const testing_by_hand::Object& b, int axis,
                           double now);

/// The definition of contact: |x_j| <= half_j on the axes that are not round, and on the round axes a
/// Euclidean distance of at most `radius` from the box of these halves. All are polynomials in the time since
/// `now`.
struct Rule {
  std::vector<Coefficients> axes;
  std::vector<Coefficients> half;  ///< one per axis
  std::vector<int> round;
  Coefficients radius;
};

/// The common lifetime within the horizon, measured from now; empty if begin > end.
struct QueriedInterval {
  Exact begin, end;
};
QueriedInterval queried_interval(const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                                 const Horizon& horizon);

/// Compares the answer of the engine with the exact one. Returns "" if they agree, else a description of the
/// difference.
std::string judge(const Rule& rule, const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                  const Horizon& horizon, const std::optional<ContactTimes>& answer);

/// The same for every contact, in order of time.
std::string judge_all(const Rule& rule, const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                      const Horizon& horizon, std::span<const ContactTimes> answers);

}  // namespace foresee::oracle
