// An intruder: one near object, or one leg of its plan, relative to one leg of the changed object. It gives the verdict
// on a range of changes, refined from bounds to convex pieces.
//
//   Intruder<2> ship(encounter, Intruder<2>::AtStart::apart);
//   ship.verdict_on(trajectory_family<2>(*changes, 10, 20)).verdict            // clear: certified
//
// Guarantee: a range whose verdict is clear is so for every change of it (contact/clearance/separation.h). An
// intruder of several parts is clear if all of them are. An outline starts as the disc around both objects.
// Where that is undecided, boxes follow, and finally the pairs of convex pieces.
// Cost: that of a certificate. The sum of an outline that rotates is recomputed per range.
#pragma once

#include <memory>
#include <vector>

#include "base/interrupt_steps.h"
#include "contact/clearance/outline_pair.h"
#include "contact/clearance/separation.h"

namespace foresee {

template <int D>
class Intruder {
 public:
  /// The state at the start of the manoeuvre, by exact contact.
  enum class AtStart : std::uint8_t {
    touches,  ///< must separate
    apart,
    unknown
  };
  /// `outlines`: null for shapes without outlines. `leg`: of the object that changes, to which the encounter refers.
  Intruder(const Encounter<D>& encounter, AtStart at_start, std::shared_ptr<const OutlinePair> outlines = {},
           std::size_t leg = 0);

  const Encounter<D>& encounter() const { return encounter_; }
  std::size_t leg() const { return leg_; }
  bool touches_at_start() const { return at_start_ == AtStart::touches; }
  CountedVerdict verdict_on(const TrajectoryFamily<D>& family) const;

  /// Whether a convex set rotates with k: then ranges at a known end are proven up to large widths.
  bool rotates() const { return turning_ && !has_parts(); }

  /// The encounter of one change, for guesses.
  Encounter<D> encounter_at(double k) const {
    return turning_ ? turned_encounter(range_of_turns(k, k)) : encounter_;
  }

  /// Whether this is the disc around two outlines of which the own one turns, on its first leg: then touching_turns()
  /// of its parts are worth their cost.
  bool is_around_turns() const {
    return !touches_at_start() && leg_ == 0 && stage_ == Stage::whole && outlines_->rotates();
  }
  /// Whether both outlines are convex. Requires: they are outlines.
  bool is_sole() const { return outlines_->is_sole(); }

  /// Of the sum that an evaluation reads; 0 without outlines.
  std::size_t corners() const { return sum_ ? sum_->corners() : 0; }
  /// Whether it bounds several convex sets.
  bool has_parts() const { return stage_ == Stage::whole || stage_ == Stage::boxes; }
  /// Whether a test of the parts can succeed. It cannot if the whole is smaller than the distance between the
  /// changes of the range: then no set touches for all of them.
  bool is_worth_splitting(const TrajectoryFamily<D>& family) const;
  std::vector<Intruder> parts() const;

 private:
  enum class Stage : std::uint8_t { simple, whole, boxes, pieces };

  /// If the outline rotates with k: its pose in the middle of the range, inflated by the rotation to
  /// the ends. For boxes and a wide range the disc around them instead.
  Encounter<D> turned_encounter(const RangeOfTurns& turns) const;

  Encounter<D> encounter_;
  AtStart at_start_;
  Stage stage_;
  std::shared_ptr<const OutlinePair> outlines_;
  OutlinePair::Part part_;
  std::shared_ptr<PieceSum> sum_, turning_;  ///< turning_: if the own part rotates
  std::size_t leg_ = 0;
  double round_ = 0;  ///< the radius without discs around rotating boxes
};

/// The intruders of a search by number, and the parts of those that have several, by further numbers. Parts are made at
/// their first use. Only some thousand of them are in memory; the others are made again, so that destruction, during
/// which no interrupt is polled, takes some ten milliseconds.
template <int D>
class IntruderParts {
 public:
  struct NumberRange {
    std::uint32_t begin, end;
  };

  IntruderParts(std::vector<Intruder<D>> wholes, Steps& steps)
      : wholes_(std::move(wholes)), numbers_(wholes_.size()), steps_(steps) {}

  std::size_t count_of_wholes() const { return wholes_.size(); }
  /// Valid until a part is read, or made.
  const Intruder<D>& operator[](std::uint32_t number) {
    return number < wholes_.size() ? wholes_[number] : part(number);
  }
  /// The intruder of which it may be a part.
  std::uint32_t whole_of(std::uint32_t number) const {
    return number < wholes_.size() ? number : parts_[number - wholes_.size()].whole;
  }
  /// Whether its parts have numbers.
  bool is_divided(std::uint32_t number) const { return numbers_[number].begin < numbers_[number].end; }
  /// Whether as many intruders and parts have been divided as there may be.
  bool is_full() const { return divided_ >= max_divided; }
  /// The numbers of its parts; it is divided if it is not yet.
  NumberRange parts_of(std::uint32_t number);

 private:
  static constexpr std::size_t max_divided = 1 << 15, max_in_memory = 1 << 12;

  struct Part {
    std::unique_ptr<const Intruder<D>> intruder;  ///< null: not in memory
    std::uint32_t whole, divided;                 ///< of which it is a part, at the top and directly
  };
  const Intruder<D>& part(std::uint32_t number);
  /// Makes the parts from `begin` on.
  void make(std::vector<Intruder<D>> made, std::uint32_t begin);

  std::vector<Intruder<D>> wholes_;
  std::vector<Part> parts_;
  std::vector<NumberRange> numbers_;  ///< of the parts of each intruder and part
  std::size_t divided_ = 0, in_memory_ = 0;
  Steps& steps_;
};

/// Whether one single change is proven clear. `family`: of this change alone.
template <int D>
bool is_clear_of(const Intruder<D>& intruder, const TrajectoryFamily<D>& family);

}  // namespace foresee
