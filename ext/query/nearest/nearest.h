// Predictive k nearest neighbours: the objects that come closest to a moving point, with distance and time.
// predictive_nearest as a library call.
//
//   const NearestQuestion question{
//       .objects = {"ships", scene, nullptr}, .now = 600, .h = 300, .k = 10, .point = {5, 5}};
//   for (const NearestRow& row : nearest(question, interrupt)) use(row.id, row.distance);
//
// Guarantee: the k objects whose centre comes closest to the point during [now, now + h] while they exist, by
// distance and then by id; fewer if fewer exist then. A distance is the real one rounded to the nearest
// double, so the order never contradicts the real distances, and objects at equal distances come by id.
// The distance of an object with a plan is the smallest rounded distance of its legs; of equal ones the smallest t.
// Cost: a tree reads nodes best first until no other can hold a nearer object; a scene is scanned.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/error.h"
#include "contact/contact.h"
#include "query/scene.h"

namespace foresee {

struct NearestQuestion {
  SearchTarget objects = {};  ///< must be set
  double now = 0;
  double h = 0;
  std::int64_t k = 1;
  std::array<std::optional<double>, 3> point = {};  ///< the place of the point at `now`, one number per axis
  std::array<double, 3> velocity = {};
  std::optional<std::uint32_t> mask = {};  ///< only objects whose category has a bit of it
};

struct NearestRow {
  std::int64_t id;
  double distance;
  double t, dt;  ///< the time at which it is that close, the earliest on ties; dt counts from now
};

/// Rows by rank. Throws Error if h is negative or not finite, if now, a coordinate or a velocity is not
/// finite, or if k < 1. Also if a coordinate is missing, or given for an axis that the objects do not have, without
/// objects, or if a scene's sizes do not fit its layout.
std::vector<NearestRow> nearest(const NearestQuestion& question, Interrupt& interrupt);

}  // namespace foresee
