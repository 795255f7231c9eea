#include "query/position/positions.h"

#include "base/axes.h"
#include "base/float_environment.h"
#include "motion/position.h"
#include "query/input_checks.h"
#include "query/legs/leg_scene.h"

namespace foresee {
namespace {

template <int D>
bool place_object(const Bodies& bodies, std::size_t i, double time, PositionRow& row) {
  const Motion<D> motion = motion_of<D>(bodies, i);
  if (!exists_at(motion, time)) return false;
  const State<D> state = state_at(motion, time);
  for (int axis = 0; axis < D; ++axis) {
    row.x[static_cast<std::size_t>(axis)] = state.x[axis];
    row.v[static_cast<std::size_t>(axis)] = state.v[axis];
    row.a[static_cast<std::size_t>(axis)] = motion.a[axis];
  }
  return true;
}

}  // namespace

std::optional<PositionRow> position_of(const Scene& scene, const Bodies& bodies, std::size_t i, double time) {
  if (scene.layout.has_plan) {
    const auto leg = row_at(bodies, scene.rows_of(i), time);
    if (!leg) return std::nullopt;
    i = *leg;
  }
  PositionRow row{scene.ids[i], {}, {}, {}};
  const bool exists =
      with_axes(bodies.layout.axes, [&]<int D>(Axes<D>) { return place_object<D>(bodies, i, time, row); });
  return exists ? std::optional(row) : std::nullopt;
}

Positions::Positions(std::shared_ptr<const Scene> scene, double time)
    : scene_(whole(std::move(scene), "positions have no scene", "a scene")),
      bodies_(scene_->bodies()),
      time_(time) {
  require_finite("at", time);
}

std::optional<PositionRow> Positions::next() {
  const FloatEnvironment environment;
  while (next_ < scene_->object_count())
    if (const auto row = position_of(*scene_, bodies_, next_++, time_)) return row;
  return std::nullopt;
}

}  // namespace foresee
