#include "shape/outline/outline.h"

namespace foresee {

void Outline::begin_part() {
  part_starts_.push_back(static_cast<std::uint32_t>(rings()));
  begin_hole();
}

void Outline::begin_hole() {
  ring_ends_.push_back(static_cast<std::uint32_t>(corners_.size()));
}

void Outline::add(const Corner& corner) {
  const bool first = ring(rings() - 1).empty();
  if (!first && corners_.back() == corner) return;
  corners_.push_back({corner.x + 0.0, corner.y + 0.0});  // -0 becomes 0
  ++ring_ends_.back();
}

bool Outline::close_ring() {
  const std::span<const Corner> last = ring(rings() - 1);
  if (last.size() < 2 || last.front() != last.back()) return false;
  corners_.pop_back();
  --ring_ends_.back();
  return true;
}

Extents<2> Outline::extents() const {
  Extents<2> around{{corners_[0].x, corners_[0].y}, {corners_[0].x, corners_[0].y}};
  for (const Corner& corner : corners_) {
    const Vec<2> at{corner.x, corner.y};
    around.lower = around.lower.min(at), around.upper = around.upper.max(at);
  }
  return around;
}

}  // namespace foresee
