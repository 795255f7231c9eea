// Two objects with given numbers, and the answers of contact about them.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "contact/contact.h"

namespace foresee::testing_by_hand {

/// One object with every number spelled out; only those of its layout are used.
struct Object {
  Layout layout{.axes = 2, .law = Law::accelerated, .has_t = true, .has_until = true};
  double t = 0;
  double x[3] = {}, v[3] = {}, a[3] = {};
  double half[3] = {};
  double r = 0, hz = 0;
  double growth = 0, growth_z = 0;
  double until = std::numeric_limits<double>::infinity();

  std::vector<double> row() const {
    const Offsets at = row_offsets(layout);
    std::vector<double> row(at.size);
    if (at.t >= 0) row[at.t] = t;
    for (int j = 0; j < layout.axes; ++j) {
      row[at.x + j] = x[j];
      if (at.v >= 0) row[at.v + j] = v[j];
      if (at.a >= 0) row[at.a + j] = a[j];
      if (at.half >= 0) row[at.half + j] = half[j];
    }
    if (at.r >= 0) row[at.r] = r;
    if (at.hz >= 0) row[at.hz] = hz;
    if (at.growth >= 0) row[at.growth] = growth;
    if (at.growth_z >= 0) row[at.growth_z] = growth_z;
    if (at.until >= 0) row[at.until] = until;
    return row;
  }
};

inline Object object(int axes, Shape shape) {
  Object o;
  o.layout.axes = axes;
  o.layout.shape = shape;
  return o;
}

/// The answer for the only pair. Throws if decide() and first_contacts() do not agree.
inline std::optional<ContactTimes> answer_of(Contact& contact) {
  const auto require = [](bool agrees, const char* what) {
    if (!agrees) throw std::logic_error(std::string("two functions of Contact do not agree: ") + what);
  };
  const Pair pair{0, 0};
  std::vector<Pair> hits, decided;
  std::vector<ContactTimes> times, starts;
  contact.first_contacts({&pair, 1}, TimesWanted::both, hits, times);
  require(times.size() == hits.size(), "pairs and times");
  contact.decide({&pair, 1}, decided);
  require(hits == decided, "with times, and whether");
  decided.clear();
  contact.first_contacts({&pair, 1}, TimesWanted::starts, decided, starts);
  require(hits == decided, "with both times, and with starts");
  if (hits.empty()) return std::nullopt;
  require(times[0].t == starts[0].t && times[0].dt == starts[0].dt, "starts");
  return times[0];
}

inline std::optional<ContactTimes> contact(const Object& a, const Object& b,
                                           const ContactQuestion& question) {
  const std::vector<double> row_a = a.row(), row_b = b.row();
  const Bodies bodies_a(a.layout, row_a.data(), 1), bodies_b(b.layout, row_b.data(), 1);
  return answer_of(*make_contact(bodies_a, bodies_b, question, "a", "b"));
}

inline ClosestApproach closest(const Object& a, const Object& b, const ContactQuestion& question) {
  const std::vector<double> row_a = a.row(), row_b = b.row();
  const Bodies bodies_a(a.layout, row_a.data(), 1), bodies_b(b.layout, row_b.data(), 1);
  const Pair pair{0, 0};
  ClosestApproach approach;
  make_contact(bodies_a, bodies_b, question, "a", "b")->closest_approach({&pair, 1}, {&approach, 1});
  return approach;
}

}  // namespace foresee::testing_by_hand
