#include "shape/turned_forms.h"

#include "base/integer_of.h"
#include "base/interrupt_steps.h"
#include "shape/mesh/mesh_text.h"
#include "shape/outline/wkt.h"

namespace foresee {

std::shared_ptr<const Form> read_form(Shape shape, std::string_view text) {
  if (shape == Shape::mesh) {
    Mesh mesh = read_mesh(text);
    check_mesh(mesh);
    return std::make_shared<const SharedMesh>(std::move(mesh));
  }
  Outline outline = read_outline(text);
  check_outline(outline);
  return std::make_shared<const SharedOutline>(std::move(outline));
}

template <class KindOfForm>
void TurnedForms<KindOfForm>::assign(const Bodies& bodies, FormSource& source, Interrupt& interrupt) {
  turned_.reset();
  kept_.clear();
  kept_bytes_ = 0;
  known_.clear();
  bodies_ = bodies;
  forms_.assign(bodies.count, nullptr);
  if (bodies.at.heading != Offsets::absent) turned_ = std::make_unique<Turned[]>(bodies.count);
  Steps step(interrupt);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    step();
    const std::int64_t number = integer_of(bodies.row(i)[bodies.at.outline]).value_or(0);
    if (number == 0) continue;
    std::shared_ptr<const KindOfForm>& form = known_[number];
    if (!form) form = std::static_pointer_cast<const KindOfForm>(source.form(number));
    forms_[i] = form.get();
  }
}

template <class KindOfForm>
const typename KindOfForm::Pieces* TurnedForms<KindOfForm>::pieces(std::size_t row,
                                                                   ScratchPieces<Pieces>& own) const {
  const KindOfForm* const form = forms_[row];
  const Pose pose{form, heading(row)};
  if (!form || pose.heading == 0) return form ? &form->pieces() : nullptr;
  if (const Pieces* const known = turned_[row].load(std::memory_order_acquire)) return known;
  const Pieces* const pieces = kept_or_made(row, pose, own);
  if (pieces != own.pieces.get()) turned_[row].store(pieces, std::memory_order_release);
  return pieces;
}

template <class KindOfForm>
const typename KindOfForm::Pieces* TurnedForms<KindOfForm>::kept_or_made(std::size_t row, const Pose& pose,
                                                                         ScratchPieces<Pieces>& own) const {
  {
    const std::lock_guard lock(mutex_);
    const auto found = kept_.find(pose);
    if (found != kept_.end()) return found->second.get();
  }
  if (own.are_of(pose.form, pose.heading)) return own.pieces.get();
  auto made = std::make_unique<const Pieces>(pose.form->rotated_pieces(pose.heading));
  if (const Pieces* const shared = keep(pose, made)) return shared;
  own = {known_.at(*integer_of(bodies_.row(row)[bodies_.at.outline])), pose.heading, std::move(made)};
  return own.pieces.get();
}

template <class KindOfForm>
const typename KindOfForm::Pieces* TurnedForms<KindOfForm>::keep(const Pose& pose,
                                                                 std::unique_ptr<const Pieces>& made) const {
  const std::lock_guard lock(mutex_);
  const std::size_t more = made->memory() + sizeof(typename decltype(kept_)::value_type);
  const auto found = kept_.find(pose);
  if (found != kept_.end()) return found->second.get();  // another thread was quicker
  if (kept_bytes_ + more > budget_) return nullptr;
  kept_bytes_ += more;
  return kept_.emplace(pose, std::move(made)).first->second.get();
}

template <class KindOfForm>
std::size_t TurnedForms<KindOfForm>::memory() const {
  const std::lock_guard lock(mutex_);
  return forms_.size() * sizeof(forms_[0]) + (turned_ ? forms_.size() * sizeof(turned_[0]) : 0) + kept_bytes_;
}

template class TurnedForms<SharedOutline>;
template class TurnedForms<SharedMesh>;

}  // namespace foresee
