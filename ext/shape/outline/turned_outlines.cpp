#include "shape/outline/turned_outlines.h"

#include "base/integer_of.h"
#include "base/steps.h"

namespace foresee::shape {

void TurnedOutlines::assign(const Bodies& bodies, OutlineSource& source, Interrupt& interrupt) {
  clear();
  bodies_ = bodies;
  outlines_.assign(bodies.count, nullptr);
  if (bodies.at.heading != Offsets::absent) turned_ = std::make_unique<Turned[]>(bodies.count);
  Steps step(interrupt);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    step();
    const std::int64_t number = integer_of(bodies.row(i)[bodies.at.outline]).value_or(0);
    if (number == 0) continue;
    std::shared_ptr<const CutOutline>& outline = known_[number];
    if (!outline) outline = source.outline(number);
    outlines_[i] = outline.get();
  }
}

void TurnedOutlines::clear() noexcept {
  for (std::size_t i = 0; turned_ && i < outlines_.size(); ++i) delete turned_[i].load();
  turned_.reset();
  turned_corners_ = 0;
  known_.clear();
}

const ConvexPieces* TurnedOutlines::pieces(std::size_t row) const {
  const CutOutline* const outline = outlines_[row];
  if (!outline || heading(row) == 0) return outline ? &outline->pieces() : nullptr;
  if (const ConvexPieces* const known = turned_[row].load(std::memory_order_acquire)) return known;
  const Outline as_it_lies = outline->as_it_lies(heading(row));
  auto made = std::make_unique<const ConvexPieces>(turned_pieces(outline->pieces(), as_it_lies));
  const ConvexPieces* first = nullptr;
  // Another thread may have been quicker: then both use its pieces.
  if (!turned_[row].compare_exchange_strong(first, made.get(), std::memory_order_acq_rel)) return first;
  turned_corners_ += as_it_lies.corners().size();
  return made.release();
}

std::size_t TurnedOutlines::memory() const {
  constexpr std::size_t bytes_per_corner = 64;  // of pieces: corners, and boxes of the tree
  return outlines_.size() * sizeof(outlines_[0]) + (turned_ ? outlines_.size() * sizeof(turned_[0]) : 0) +
         turned_corners_ * bytes_per_corner;
}

}  // namespace foresee::shape
