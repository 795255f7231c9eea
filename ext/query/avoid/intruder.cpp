#include "query/avoid/intruder.h"

#include <algorithm>

#include "contact/clearance/departure.h"
#include "contact/clearance/separation.h"

namespace foresee {

template <int D>
Intruder<D>::Intruder(const Encounter<D>& encounter, AtStart at_start,
                      std::shared_ptr<const OutlinePair> outlines, std::size_t leg)
    : encounter_(encounter),
      at_start_(at_start),
      stage_(outlines ? Stage::whole : Stage::simple),
      outlines_(std::move(outlines)),
      leg_(leg),
      round_(encounter.extents.radius) {
  if (outlines_)
    encounter_.extents.radius += outlines_->reach() * (1 + 0x1p-50);
  else
    encounter_.nearly_touches = at_start == AtStart::apart && starts_nearly_touching(encounter_);
}

template <int D>
CountedVerdict Intruder<D>::verdict_on(const TrajectoryFamily<D>& family) const {
  const auto counted = [&](CountedVerdict one) {
    if (touches_at_start()) ++one.evaluations;
    return one;
  };
  if (stage_ == Stage::simple)
    return counted(touches_at_start() ? certify_separation_increases<D>(encounter_, family)
                                      : certify_clearance<D>(encounter_, family));
  const Encounter<D> turned = turning_ ? turned_encounter(family.known_turns()) : encounter_;
  if (has_parts()) return counted(certify_only_clearance<D>(turned, family));
  if (!touches_at_start()) return certify_clearance<D>(turned, family);
  const bool surely_touches = outlines_->is_sole() && !outlines_->rotates();
  return counted(surely_touches ? certify_separation_increases<D>(turned, family)
                                : certify_piece_separation_increases<D>(turned, family));
}

template <int D>
Encounter<D> Intruder<D>::turned_encounter(const RangeOfTurns& turns) const {
  // Wider ranges have no two ends that bound them.
  constexpr double widest_chord = 1;
  Encounter<D> encounter = encounter_;
  if (stage_ == Stage::boxes && turns.chord > 0.5) return encounter;
  turning_->turn(turns.middle);
  encounter.extents.sum = turning_.get();
  encounter.extents.radius = round_;
  encounter.rotation_chord = turns.chord;
  encounter.inflation = turning_->own_reach() * turns.chord;
  if (turns.chord <= widest_chord) encounter.turning = turning_.get();
  return encounter;
}

template <int D>
bool Intruder<D>::is_worth_splitting(const TrajectoryFamily<D>& family) const {
  if (!has_parts()) return false;
  const double end = std::min(encounter_.end, family.all.end);
  const Vec<D> apart =
      (family.upper[0] - family.lower[0]) +
      end * ((family.upper[1] - family.lower[1]) + (0.5 * end) * (family.upper[2] - family.lower[2]));
  const double size = stage_ == Stage::boxes ? outlines_->box_size(part_) : 0;
  return touches_at_start() || 4 * (size + 2 * encounter_.extents.after(end).radius) >= apart.largest();
}

template <int D>
std::vector<Intruder<D>> Intruder<D>::parts() const {
  std::vector<Intruder> parts;
  for (const OutlinePair::Part& part :
       stage_ == Stage::whole ? outlines_->parts() : outlines_->parts(part_)) {
    Intruder one = *this;
    one.stage_ = part.pieces ? Stage::pieces : Stage::boxes;
    one.part_ = part;
    one.sum_ = outlines_->sum_of(part);
    if (outlines_->rotates()) one.turning_ = part.pieces ? one.sum_ : outlines_->turning_sum_of(part);
    one.encounter_.extents.sum = one.sum_.get();
    one.encounter_.extents.radius = round_ + outlines_->more_round(part) * (1 + 0x1p-50);
    one.encounter_.nearly_touches = part.pieces && !outlines_->rotates() && at_start_ == AtStart::apart &&
                                    starts_nearly_touching(one.encounter_);
    parts.push_back(std::move(one));
  }
  return parts;
}

template <int D>
typename IntruderParts<D>::NumberRange IntruderParts<D>::parts_of(std::uint32_t number) {
  if (is_divided(number)) return numbers_[number];
  std::vector<Intruder<D>> made = (*this)[number].parts();
  const auto begin = static_cast<std::uint32_t>(numbers_.size());
  const std::uint32_t whole = whole_of(number);
  for (std::size_t i = 0; i < made.size(); ++i) parts_.push_back({nullptr, whole, number});
  numbers_.resize(numbers_.size() + made.size());
  ++divided_;
  make(std::move(made), begin);
  return numbers_[number] = {begin, static_cast<std::uint32_t>(numbers_.size())};
}

template <int D>
const Intruder<D>& IntruderParts<D>::part(std::uint32_t number) {
  const Part& found = parts_[number - wholes_.size()];
  if (!found.intruder) make((*this)[found.divided].parts(), numbers_[found.divided].begin);
  return *found.intruder;
}

template <int D>
void IntruderParts<D>::make(std::vector<Intruder<D>> made, std::uint32_t begin) {
  if (in_memory_ + made.size() > max_in_memory) {
    for (Part& old : parts_) old.intruder.reset();
    in_memory_ = 0;
  }
  in_memory_ += made.size();
  Part* place = parts_.data() + (begin - wholes_.size());
  for (Intruder<D>& one : made) {
    steps_.costly(static_cast<unsigned>(one.corners()));
    place->intruder = std::make_unique<const Intruder<D>>(std::move(one));
    ++place;
  }
}

template <int D>
bool is_clear_of(const Intruder<D>& intruder, const TrajectoryFamily<D>& family) {
  const ClearanceVerdict verdict = intruder.verdict_on(family).verdict;
  if (verdict != ClearanceVerdict::undecided || !intruder.has_parts())
    return verdict == ClearanceVerdict::clear;
  const std::vector<Intruder<D>> parts = intruder.parts();
  return std::all_of(parts.begin(), parts.end(),
                     [&](const Intruder<D>& part) { return is_clear_of<D>(part, family); });
}

template class IntruderParts<1>;
template class IntruderParts<2>;
template class IntruderParts<3>;
template class Intruder<1>;
template class Intruder<2>;
template class Intruder<3>;
template bool is_clear_of<1>(const Intruder<1>&, const TrajectoryFamily<1>&);
template bool is_clear_of<2>(const Intruder<2>&, const TrajectoryFamily<2>&);
template bool is_clear_of<3>(const Intruder<3>&, const TrajectoryFamily<3>&);

}  // namespace foresee
