#include "shape/turned_forms.h"

#include "base/integer_of.h"
#include "base/steps.h"
#include "shape/mesh/cut_mesh.h"
#include "shape/outline/cut_outline.h"

namespace foresee::shape {

template <class KindOfForm>
void TurnedForms<KindOfForm>::assign(const Bodies& bodies, FormSource& source, Interrupt& interrupt) {
  clear();
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
void TurnedForms<KindOfForm>::clear() noexcept {
  for (std::size_t i = 0; turned_ && i < forms_.size(); ++i) delete turned_[i].load();
  turned_.reset();
  turned_corners_ = 0;
  known_.clear();
}

template <class KindOfForm>
const typename KindOfForm::Pieces* TurnedForms<KindOfForm>::pieces(std::size_t row) const {
  const KindOfForm* const form = forms_[row];
  if (!form || heading(row) == 0) return form ? &form->pieces() : nullptr;
  if (const Pieces* const known = turned_[row].load(std::memory_order_acquire)) return known;
  auto made = std::make_unique<const Pieces>(form->pieces_as_it_lies(heading(row)));
  const Pieces* first = nullptr;
  // Another thread may have been quicker: then both use its pieces.
  if (!turned_[row].compare_exchange_strong(first, made.get(), std::memory_order_acq_rel)) return first;
  turned_corners_ += form->corners();
  return made.release();
}

template <class KindOfForm>
std::size_t TurnedForms<KindOfForm>::memory() const {
  constexpr std::size_t bytes_per_corner = 64;  // of pieces: corners, and boxes of the tree
  return forms_.size() * sizeof(forms_[0]) + (turned_ ? forms_.size() * sizeof(turned_[0]) : 0) +
         turned_corners_ * bytes_per_corner;
}

template class TurnedForms<CutOutline>;
template class TurnedForms<CutMesh>;

}  // namespace foresee::shape
