// Positions and velocities of all objects at one time. predictive_position as a library call.
//
//   Positions positions(ships, 700);
//   while (auto row = positions.next()) use(row->id, row->x[0]);
//
// Guarantee: every object that exists at that time comes exactly once, in the scene's order; the others do
// not come. An object with a plan is where its leg is, at a joint where the later leg is. Cost: one evaluation per
// object, when it is pulled; a binary search among the legs of a plan.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "query/scene.h"

namespace foresee {

struct PositionRow {
  std::int64_t id;
  std::array<double, 3> x, v, a;  ///< as many as the scene has axes
};

/// The scene's object number i (Scene::rows_of) at `time`; empty if it does not exist then.
/// Requires: `bodies` are the scene's, and the floating-point environment is a FloatEnvironment.
std::optional<PositionRow> position_of(const Scene& scene, const Bodies& bodies, std::size_t i, double time);

class Positions {
 public:
  /// Throws Error unless `time` is finite. Also without a scene, or if its sizes do not fit its layout.
  Positions(std::shared_ptr<const Scene> scene, double time);

  /// The next object; empty at the end.
  std::optional<PositionRow> next();

 private:
  std::shared_ptr<const Scene> scene_;
  Bodies bodies_;
  double time_;
  std::size_t next_ = 0;
};

}  // namespace foresee
