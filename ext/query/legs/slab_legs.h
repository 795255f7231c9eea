// Legs that exist during a time slab, as a scene of their own: the input of the indexes of a join slab by slab.
//
//   SlabLegs legs(movers, {now, now + h}, SlabLegs::Slabs::several);
//   legs.take({from, until});                             // slabs in order of time
//   use(legs.scene()->bodies(), legs.leg(7));             // the row of the whole scene
//
// A pass over the movers that have legs left; each leg is looked at once, and copied once for each slab in which it
// exists. The memory is reused, so a scene is valid until the next call. Scenes with outlines or meshes, and those of
// which most legs exist throughout, are taken whole.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "query/legs/movers.h"

namespace foresee {

class SlabLegs {
 public:
  enum class Slabs : std::uint8_t {
    whole,  ///< the scene is not cut
    one,
    several
  };

  /// For slabs within `all`. `movers` must outlive this.
  SlabLegs(const Movers& movers, const LegTimes& all, Slabs slabs);

  /// Requires: times.from does not decrease from call to call.
  void take(const LegTimes& times);

  std::shared_ptr<const Scene> scene() const { return is_whole_ ? movers_.scene() : scene_; }
  /// Of the whole scene.
  std::uint32_t leg(std::uint32_t row) const { return is_whole_ ? row : legs_[row]; }
  /// The number of its mover.
  std::uint32_t mover(std::uint32_t row) const { return is_whole_ ? movers_.mover_of(row) : numbers_[row]; }

 private:
  /// The legs of one mover that may exist in later slabs.
  struct Left {
    double t;
    std::uint32_t first, last, mover;
  };

  /// Whether a copy of the legs is not worth its cost.
  bool takes_whole(const LegTimes& all, Slabs slabs) const;
  std::uint32_t last_leg(std::uint32_t mover, std::uint32_t first, double until) const;
  void take_legs(Left& left, const LegTimes& times);

  const Movers& movers_;
  bool is_whole_;
  std::vector<Left> waiting_;  ///< in order of the start of the mover
  std::size_t started_ = 0;    ///< so many of them have started
  std::vector<Left> current_;  ///< those that have legs left
  std::shared_ptr<Scene> scene_;
  std::vector<std::uint32_t> legs_, numbers_;  ///< by row of the slab
};

}  // namespace foresee
