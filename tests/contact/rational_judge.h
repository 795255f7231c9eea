// What the judges of outlines and meshes have in common: times in rational numbers, and how an answer is held
// against them; for contact whose times are no rational numbers, against single moments beside the answer.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contact/pair_by_hand.h"

namespace foresee::oracle {

using Rational = boost::multiprecision::cpp_rational;

/// Closed.
struct SlopeSign {
  Rational begin, end;
};

/// Of all together: those that touch each other are one.
std::optional<SlopeSign> first_of(std::vector<SlopeSign> contacts);

/// What `contacts` leave of `queried`. A gap that ends where another begins is none.
std::vector<SlopeSign> gaps_between(std::vector<SlopeSign> contacts, const SlopeSign& queried);

/// Is `value` the double nearest to `exact`, ties to even?
bool is_rounded(double value, const Rational& exact);

/// Two objects as they move, all times measured from now.
struct Encounter {
  const testing_by_hand::Object &a, &b;
  const ContactQuestion& question;

  /// While both exist; none if it ends before it begins.
  SlopeSign queried() const;
  /// Where b is seen from a, and how fast it goes there.
  Rational place(int axis, const Rational& time) const;
  Rational velocity(int axis) const;
  Rational radius(const Rational& time) const;
};

/// Empty if these are the times of `exact`, correctly rounded, else what is wrong.
std::string compared(const std::optional<SlopeSign>& exact, const std::optional<ContactTimes>& answer,
                     double now);

/// Judges contact of any radius and motion by single moments: just beside the times that were answered, and
/// many others. `touch` says whether they do at a moment. Requires: both exist all the time. Empty if nothing
/// is wrong.
std::string judged_by_times(const std::function<bool(const Rational&)>& touch, double h,
                            const std::optional<ContactTimes>& answer);

}  // namespace foresee::oracle
