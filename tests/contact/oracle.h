// The judge of contact: Sturm sequences over exact numbers, slow and plain, sharing no code with what it
// judges.
//
// It knows contact as a distance: for every axis whether the pair is below, inside or above the box around
// the origin, and then the sum of the squared excesses against R^2. The moments at which an axis changes
// sides divide time into stretches, each with one polynomial that tells contact; its roots within the stretch
// are isolated, told apart exactly from the stretch's ends, and all is walked through in order of time.
#pragma once

#include <string>
#include <vector>

#include "contact/pair_by_hand.h"
#include "contact/sturm.h"

namespace foresee::oracle {

/// Centre of b minus centre of a on one axis, as a polynomial in the time since `now`.
Coefficients relative_axis(const testing_by_hand::Object& a, const testing_by_hand::Object& b, int axis,
                           double now);

/// What counts as contact: |x_j| <= half_j on the axes that are not round, and over the round ones a
/// Euclidean distance of at most `radius` from the box of these halves. All are polynomials in the time since
/// `now`.
struct Rule {
  std::vector<Coefficients> axes;
  std::vector<Coefficients> half;  ///< one for each axis
  std::vector<int> round;
  Coefficients radius;
};

/// The moments asked about, measured from now; none if begin > end.
struct ExactInterval {
  Exact begin, end;
};
ExactInterval queried_interval(const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                               const Horizon& horizon);

/// Compares the engine's answer with the exact one; empty if they agree, else what is wrong.
std::string judge(const Rule& rule, const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                  const Horizon& horizon, const std::optional<ContactTimes>& answer);

}  // namespace foresee::oracle
