#include "query/position/tracks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/steps.h"
#include "query/require.h"

namespace foresee {
namespace {

constexpr double most_moments = 9007199254740992;  // 2^53: up to there a double counts

void require_valid(const TrackMoments& moments) {
  require_finite("t0", moments.t0);
  require_finite("t1", moments.t1);
  require_order("t0", moments.t0, "t1", moments.t1);
  require_positive("step", moments.step);
  if (!(moments.t1 / moments.step - moments.t0 / moments.step < most_moments))
    throw Error("step is too small: from t0 to t1 there may be fewer than 2^53 moments");
}

std::vector<std::size_t> rows_by_id(const std::vector<std::int64_t>& ids, Interrupt& interrupt) {
  std::vector<std::size_t> rows(ids.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  Steps steps(interrupt);
  std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) { return steps(), ids[a] < ids[b]; });
  return rows;
}

}  // namespace

Tracks::Tracks(std::shared_ptr<const Scene> scene, const TrackMoments& moments, Interrupt& interrupt)
    : scene_(std::move(scene)),
      bodies_(scene_->bodies()),
      moments_(moments),
      interrupt_(interrupt),
      moment_(moments.t0) {
  const FloatEnvironment environment;
  require_valid(moments_);
  by_id_ = rows_by_id(scene_->ids, interrupt);
}

bool Tracks::to_next_moment() {
  const double last = moment_;
  while (moment_ == last && last < moments_.t1) {
    interrupt_.check();
    moment_ = std::min(std::fma(++i_, moments_.step, moments_.t0), moments_.t1);
  }
  return moment_ != last;
}

std::optional<TrackRow> Tracks::next() {
  const FloatEnvironment environment;
  if (by_id_.empty()) return std::nullopt;
  do {
    while (next_ < by_id_.size()) {
      interrupt_.check();
      if (const auto row = position_of(*scene_, bodies_, by_id_[next_++], moment_))
        return TrackRow{moment_, *row};
    }
    next_ = 0;
  } while (to_next_moment());
  by_id_.clear();
  return std::nullopt;
}

}  // namespace foresee
