#include "query/position/tracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "query/input_checks.h"

namespace foresee {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double max_times = 9007199254740992;  // 2^53: a double counts exactly up to it

/// Rounded; by halves, because the difference of two times may overflow.
double steps_between(double from, double to, double step) {
  return 2 * ((to / 2 - from / 2) / step);
}

void require_valid(const TrackTimes& instants) {
  require_finite("t0", instants.t0);
  require_finite("t1", instants.t1);
  require_order("t0", instants.t0, "t1", instants.t1);
  require_positive("step", instants.step);
  if (!(steps_between(instants.t0, instants.t1, instants.step) < max_times))
    throw Error("step is too small: a track has fewer than 2^53 times");
}

std::vector<std::size_t> objects_by_id(const Scene& scene, Interrupt& interrupt) {
  std::vector<std::size_t> objects(scene.object_count());
  std::iota(objects.begin(), objects.end(), std::size_t{0});
  const auto id = [&](std::size_t object) { return scene.ids[scene.rows_of(object).first]; };
  Steps steps(interrupt);
  std::sort(objects.begin(), objects.end(), [&](std::size_t a, std::size_t b) {
    steps();
    return id(a) < id(b);
  });
  return objects;
}

}  // namespace

Tracks::Tracks(std::shared_ptr<const Scene> scene, const TrackTimes& instants, Interrupt& interrupt)
    : scene_(whole(std::move(scene), "tracks have no scene", "a scene")),
      bodies_(scene_->bodies()),
      instants_(instants),
      interrupt_(interrupt),
      time_(instants.t0) {
  const FloatEnvironment environment;
  require_valid(instants_);
  by_id_ = objects_by_id(*scene_, interrupt);
}

// Steps that are shorter than the distance of two doubles give many equal times. The first step beyond half of that
// distance gives the next double. The slack of eight steps is more than the rounding of their number.
bool Tracks::to_next_time() {
  const double last = time_;
  const double half = (std::nextafter(last, infinity) - last) / 2;
  const double equal_times = steps_between(instants_.t0, last, instants_.step) + half / instants_.step - 8;
  if (last < instants_.t1 && equal_times < max_times) i_ = std::max(i_, std::floor(equal_times));
  while (time_ == last && last < instants_.t1) {
    interrupt_.check();
    time_ = std::min(std::fma(++i_, instants_.step, instants_.t0), instants_.t1);
  }
  return time_ != last;
}

std::optional<TrackRow> Tracks::next() {
  const FloatEnvironment environment;
  return unbroken_.run("the track", [this]() -> std::optional<TrackRow> {
    if (by_id_.empty()) return std::nullopt;
    do {
      while (next_ < by_id_.size()) {
        interrupt_.check();
        if (const auto row = position_of(*scene_, bodies_, by_id_[next_++], time_))
          return TrackRow{time_, *row};
      }
      next_ = 0;
    } while (to_next_time());
    by_id_.clear();
    return std::nullopt;
  });
}

}  // namespace foresee
