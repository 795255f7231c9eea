// Tracks: positions of all objects at regular times. predictive_track as a library call.
//
//   Tracks tracks(ships, {.t0 = 0, .t1 = 600, .step = 60}, interrupt);
//   while (auto row = tracks.next()) draw(row->at.id, row->t, row->at.x);
//
// Guarantee: the rows of Positions at t0 + i * step, each time rounded once, while that is below t1, and then
// at t1; by time, then by id. Times that round to the same double come once. Cost: one evaluation per object
// and time, when it is pulled; the ids are sorted once.
#pragma once

#include <vector>

#include "query/position/positions.h"

namespace foresee {

struct TrackTimes {
  double t0, t1, step;
};

struct TrackRow {
  double t;
  PositionRow at;
};

class Tracks {
 public:
  /// Throws Error unless t0 <= t1 and step > 0 are finite and make fewer than 2^53 times. Also without a scene, or if
  /// its sizes do not fit its layout.
  Tracks(std::shared_ptr<const Scene> scene, const TrackTimes& instants, Interrupt& interrupt);

  /// The next object at the current time, or the first one at the next time; empty at the end. If it throws, as
  /// `interrupt` may, each later call throws Error.
  std::optional<TrackRow> next();

 private:
  bool to_next_time();

  std::shared_ptr<const Scene> scene_;
  Bodies bodies_;
  TrackTimes instants_;
  Interrupt& interrupt_;
  std::vector<std::size_t> by_id_;  ///< numbers of objects
  double i_ = 0, time_;
  std::size_t next_ = 0;
  UnbrokenCalls unbroken_;
};

}  // namespace foresee
