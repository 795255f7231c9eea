// Contacts of two movers from the contacts of their legs: those that meet in time are one.
//
//   std::vector<LegContact> found = …;             // of all pairs of legs, each by Contact::all_contacts()
//   const std::vector<ContactTimes> all = mover_contacts(found);
//
// A mover is the union of its legs (motion/plan/plan.h), and a leg ends within rounding of the start of the next one.
// So contacts of different pairs of legs whose [t, t_end] meet, as doubles, are one contact: from the smallest t to the
// largest t_end, and the same for dt. Contacts of one pair of legs are never joined directly, only by a third contact
// that meets both. The result is in order of t, and of equal ones in order of t_end.
// Cost: n log n, and a test for each of the contacts that last at one time.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/contact.h"

namespace foresee {

/// One contact of a pair of legs, which the numbers of the legs identify.
struct LegContact {
  std::uint32_t leg_a, leg_b;
  ContactTimes times;
};

/// All contacts of the two movers. `contacts`: in any order; it is sorted.
std::vector<ContactTimes> mover_contacts(std::vector<LegContact>& contacts);

}  // namespace foresee
