// An intruder as it is seen from the change: does it stay clear of all changes of a range? Of outlines first
// as the disc around both, then box by box, down to their convex pieces, where what is around them is in
// doubt.
//
//   IntruderCertificate<2> ship(met, false);
//   ship.judge(changed_ways<2>(base, change, 10, 20), 10, 20, looks)
//
// Guarantee: what is judged clear is so for every change of the range (contact/growing/separation.h). What
// has parts is clear if all of them are. Cost: that of a certificate; where an outline turns, its sum is made
// anew for each range.
#pragma once

#include <memory>
#include <vector>

#include "contact/growing/outline_pair.h"
#include "contact/growing/separation.h"

namespace foresee {

template <int D>
class IntruderCertificate {
 public:
  /// `touches_first`: must part. `outlines`: null where sizes alone tell what touches.
  IntruderCertificate(const Encounter<D>& met, bool touches_first,
                      std::shared_ptr<const OutlinePair> outlines = {});

  const Encounter<D>& met() const { return met_; }
  bool touches_first() const { return touches_first_; }
  Judgement certify(const ChangedWays<D>& ways, double p, double q, std::uint64_t& looks) const;

  /// That of one change, for guesses.
  Encounter<D> encounter_at(double k) const { return encounter_between(k, k); }

  /// Whether it stands for more than one convex set, and those are worth a look: where it is not larger than
  /// what the changes of a range lie apart, none of them can touch for all.
  bool has_parts() const { return stage_ == Stage::whole || stage_ == Stage::boxes; }
  bool is_worth_splitting(const ChangedWays<D>& ways) const;
  std::vector<IntruderCertificate> parts() const;

 private:
  enum class Stage : std::uint8_t { simple, whole, boxes, pieces };

  /// What is turned with the change: as in the middle of the range, and as much rounder as the others are
  /// away from there. Of boxes the disc around, where that is less.
  Encounter<D> encounter_between(double p, double q) const;

  Encounter<D> met_;
  bool touches_first_;
  Stage stage_;
  std::shared_ptr<const OutlinePair> outlines_;
  OutlinePair::Part part_;
  std::shared_ptr<PieceSum> sum_, turning_;  ///< the latter where it turns
  double round_ = 0;  ///< the radius, and how fast it grows, without boxes around what turns
};

/// Clear, or not proven: one change alone.
template <int D>
bool is_clear_of(const IntruderCertificate<D>& intruder, const ChangedWays<D>& ways, double k);

}  // namespace foresee
