// Which objects come nearest to a moving point, how near, and when? predictive_nearest as a library call.
//
//   const NearestQuestion question{
//       .objects = {"ships", scene, nullptr}, .now = 600, .h = 300, .k = 10, .point = {5, 5}};
//   for (const NearestRow& row : nearest(question, interrupt)) use(row.id, row.distance);
//
// Guarantee: the k objects whose centre comes closest to the point during [now, now + h] while they exist, by
// distance and then by id; fewer if fewer exist then. A distance is the real one rounded to the nearest
// double, so the order never contradicts the real distances, and objects at equal distances come by id.
// Cost: a tree reads nodes best first until no other can hold a nearer object; a scene is looked at whole.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/error.h"
#include "contact/contact.h"
#include "query/search_target.h"

namespace foresee {

struct NearestQuestion {
  SearchTarget objects;
  double now = 0;
  double h = 0;
  std::int64_t k = 1;
  std::array<std::optional<double>, 3> point = {};  ///< where the point is at `now`: one number an axis
  std::array<double, 3> velocity = {};
};

struct NearestRow {
  std::int64_t id;
  double distance;
  double t, dt;  ///< the moment at which it is that near, the earliest on ties; and measured from now
};

/// By rank. Throws Error for a wrong question: h negative or not finite; now, a coordinate or a velocity not
/// finite; k < 1; a coordinate missing, or given for an axis that the objects do not have.
std::vector<NearestRow> nearest(const NearestQuestion& question, Interrupt& interrupt);

}  // namespace foresee
