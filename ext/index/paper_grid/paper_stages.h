// The paper's filter stages, GPCD step 5: they reduce candidates before exact contact times are computed.
//
//   auto stages = make_paper_stages<2>(ships, ships, true, horizon, margin, interrupt);
//   stages->prune(pairs);                                 // keeps the pairs that may touch
//   stages->counts()[static_cast<int>(PaperStage::time_interval)].after;
//
//   a  projection overlap       the swept boxes meet on every axis
//   b  centre point             the centres coincide at some time while both exist: an immediate hit, which
//                               skips the other tests; decided exactly
//   c  time interval            trajectory.h
//   d  trajectory intersection  trajectory.h
//
// Guarantee: no pair that touches within the margins of both is lost. Hits of the centre point test count as
// passing c and d. Times are processor time of the calling thread, measured once per stage and batch. Stage a
// includes the time for the swept boxes, stage c that for the trajectories of the remaining pairs.
#pragma once

#include <array>
#include <cstdint>
#include <ctime>
#include <memory>
#include <vector>

#include "base/error.h"
#include "shape/swept_boxes.h"

namespace foresee {

enum class PaperStage : std::uint8_t {
  projection_overlap,
  centre_point,
  time_interval,
  trajectory_intersection
};
inline constexpr std::size_t paper_stage_count = 4;

/// Processor time of the calling thread, by which stages are measured. One reading costs some hundred nanoseconds.
inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

struct StageCount {
  std::uint64_t before = 0, after = 0;
  double seconds = 0;
};

class PaperStages {
 public:
  virtual ~PaperStages() = default;

  /// Removes pairs that cannot touch; the order of the others may change.
  virtual void prune(std::vector<Pair>& pairs) = 0;

  const std::array<StageCount, paper_stage_count>& counts() const { return counts_; }
  /// Pairs whose centres coincide.
  std::size_t hits_at_once() const { return hits_at_once_; }

 protected:
  std::array<StageCount, paper_stage_count> counts_;
  std::size_t hits_at_once_ = 0;
};

/// Pairs within `a`, or between `a` and `b` if `between`. The bodies and `interrupt` must outlive the stages.
template <int D>
std::unique_ptr<PaperStages> make_paper_stages(const Bodies& a, const Bodies& b, bool between,
                                               const Horizon& horizon, const Vec<D>& margin,
                                               Interrupt& interrupt);

}  // namespace foresee
