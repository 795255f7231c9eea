// Shared parts of the oracles of outlines and meshes: times in rational numbers, and the comparison of an
// answer with them. Contact whose times are not rational is compared at single times near the answer.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contact/pair_by_hand.h"

namespace foresee::oracle {

using Rational = boost::multiprecision::cpp_rational;

/// A closed interval of time.
struct RationalInterval {
  Rational begin, end;
};

/// The first of the union; intervals that touch each other are one.
std::optional<RationalInterval> first_of(std::vector<RationalInterval> contacts);

/// `queried` without `contacts`. Adjacent gaps are joined.
std::vector<RationalInterval> gaps_between(std::vector<RationalInterval> contacts,
                                           const RationalInterval& queried);

/// Whether `value` is the double nearest to `exact`, ties to even.
bool is_rounded(double value, const Rational& exact);

/// Two moving objects, with all times measured from now.
struct Encounter {
  const testing_by_hand::Object &a, &b;
  const ContactQuestion& question;

  /// While both exist; empty if it ends before it starts.
  RationalInterval queried() const;
  /// Position and velocity of b relative to a.
  Rational place(int axis, const Rational& time) const;
  Rational velocity(int axis) const;
  Rational radius(const Rational& time) const;
};

/// Returns "" if these are the times of `exact`, correctly rounded, else a description of the difference.
std::string compared(const std::optional<RationalInterval>& exact, const std::optional<ContactTimes>& answer,
                     double now);

/// Checks contact of any radius and motion at single times: just beside the times of the answer, and many
/// others. `touch` returns whether the objects touch at a time. Requires: both exist all the time. Returns ""
/// if all agree.
std::string judged_by_times(const std::function<bool(const Rational&)>& touch, double h,
                            const std::optional<ContactTimes>& answer);

}  // namespace foresee::oracle
