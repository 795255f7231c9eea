// The judge of contact: rationals and Sturm sequences, slow and plain, sharing no code with what it judges.
//
// It knows contact as a distance: for every axis whether the pair is below, inside or above the box around
// the origin, and then the sum of the squared excesses against R^2. All moments at which any of these signs
// can change are isolated, told apart exactly and walked through in order of time.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <functional>
#include <string>
#include <vector>

#include "contact/pairs.h"

namespace foresee::oracle {

using Whole = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;
using Coefficients = std::vector<Rational>;  ///< of tau^0, tau^1, …

/// Centre of b minus centre of a on one axis, as a polynomial in the time since `now`.
Coefficients relative_axis(const testing_pairs::Object& a, const testing_pairs::Object& b, int axis,
                           double now);

/// What counts as contact, as polynomials and a rule over their signs.
struct Rule {
  std::vector<Coefficients> polynomials;
  std::function<bool(const std::vector<int>& signs)> holds;
};

/// |x_j| <= half_j on the axes of `box`; Euclidean distance at most R from that box over the axes of `round`.
/// half has one entry per axis. Axes not in `round` are judged alone.
Rule distance_rule(const std::vector<Coefficients>& axes, const std::vector<Rational>& half,
                   const std::vector<int>& round, const Rational& radius);

/// Compares the engine's answer with the exact one; empty if they agree, else what is wrong.
std::string judge(const Rule& rule, const testing_pairs::Object& a, const testing_pairs::Object& b,
                  const Horizon& horizon, const std::optional<ContactTimes>& answer);

}  // namespace foresee::oracle
