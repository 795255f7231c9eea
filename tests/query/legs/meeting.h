// Two movers, and the contacts of all pairs of their legs by the engine: legs are rows of a table.
#pragma once

#include <ostream>
#include <vector>

#include "motion/plan/plan.h"
#include "query/legs/mover_contacts.h"

namespace foresee::leg_oracle {

/// Two movers, a horizon, and the distance per axis that counts as touching.
struct Meeting {
  std::vector<Leg> a, b;
  double now = 0, h = 0, reach = 1;
};

inline std::ostream& operator<<(std::ostream& out, const Meeting& meeting) {
  out << std::hexfloat << "now " << meeting.now << " h " << meeting.h << " reach " << meeting.reach;
  for (const auto* legs : {&meeting.a, &meeting.b}) {
    out << "\nmover";
    for (const Leg& leg : *legs)
      out << "\n  " << leg.t << " to " << leg.until << ": " << leg.x[0] << ' ' << leg.x[1] << ", v "
          << leg.v[0] << ' ' << leg.v[1] << ", a " << leg.a[0] << ' ' << leg.a[1];
  }
  return out;
}

/// The contacts of all pairs of legs by the engine: legs are rows of a table.
inline std::vector<LegContact> contacts_of_legs(const Meeting& meeting) {
  const Layout layout{
      .axes = 2, .law = Law::accelerated, .shape = Shape::point, .has_t = true, .has_until = true};
  const auto rows_of = [&](const std::vector<Leg>& legs) {
    std::vector<double> rows;
    for (const Leg& leg : legs)
      rows.insert(rows.end(), {leg.t, leg.x[0], leg.x[1], leg.v[0], leg.v[1], leg.a[0], leg.a[1], leg.until});
    return rows;
  };
  // A box of this half extent and a point: the distance per axis.
  Layout boxes = layout;
  boxes.shape = Shape::box;
  const Offsets at = row_offsets(boxes);
  const std::vector<double> rows_a = rows_of(meeting.a);
  std::vector<double> rows_b(meeting.b.size() * static_cast<std::size_t>(at.size));
  for (std::size_t i = 0; i < meeting.b.size(); ++i) {
    double* row = &rows_b[i * static_cast<std::size_t>(at.size)];
    const Leg& leg = meeting.b[i];
    row[at.t] = leg.t, row[at.until] = leg.until;
    for (int j = 0; j < 2; ++j) {
      const auto axis = static_cast<std::size_t>(j);
      row[at.x + j] = leg.x[axis], row[at.v + j] = leg.v[axis], row[at.a + j] = leg.a[axis];
      row[at.half + j] = meeting.reach;
    }
  }
  const Bodies a(layout, rows_a.data(), meeting.a.size()), b(boxes, rows_b.data(), meeting.b.size());
  const auto contact = make_contact(a, b, {.horizon = {meeting.now, meeting.h}}, "a", "b");
  std::vector<Pair> pairs, hits;
  for (std::uint32_t i = 0; i < meeting.a.size(); ++i)
    for (std::uint32_t k = 0; k < meeting.b.size(); ++k) pairs.push_back({i, k});
  std::vector<ContactTimes> times;
  contact->all_contacts(pairs, hits, times);
  std::vector<LegContact> found;
  for (std::size_t i = 0; i < hits.size(); ++i) found.push_back({hits[i].a, hits[i].b, times[i]});
  return found;
}

}  // namespace foresee::leg_oracle
