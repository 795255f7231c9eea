// An intruder as it is seen from the change: does it stay clear of all changes of a range? Of outlines first
// as the disc around both, then box by box, down to their convex pieces, where what is around them is in
// doubt.
//
//   IntruderCertificate<2> ship(encounter, IntruderCertificate<2>::AtFirst::apart);
//   ship.certify_clearance(trajectory_family<2>(base, change, 10, 20), 10, 20, evaluations)
//
// Guarantee: what is judged clear is so for every change of the range (contact/clearance/separation.h). What
// has parts is clear if all of them are. Cost: that of a certificate; where an outline turns, its sum is made
// anew for each range.
#pragma once

#include <memory>
#include <vector>

#include "contact/clearance/outline_pair.h"
#include "contact/clearance/separation.h"

namespace foresee {

template <int D>
class IntruderCertificate {
 public:
  /// What is known of the moment of the change, by exact contact.
  enum class AtFirst : std::uint8_t {
    touches,  ///< must part
    apart,
    unknown
  };
  /// `outlines`: null where sizes alone tell what touches.
  IntruderCertificate(const Encounter<D>& encounter, AtFirst at_first,
                      std::shared_ptr<const OutlinePair> outlines = {});

  const Encounter<D>& encounter() const { return encounter_; }
  bool touches_first() const { return at_first_ == AtFirst::touches; }
  ClearanceVerdict certify(const TrajectoryFamily<D>& family, double p, double q,
                           std::uint64_t& evaluations) const;

  /// That of one change, for guesses.
  Encounter<D> encounter_at(double k) const { return encounter_between(k, k); }

  /// Whether it stands for more than one convex set, and those are worth a look: where it is not larger than
  /// what the changes of a range lie apart, none of them can touch for all.
  bool has_parts() const { return stage_ == Stage::whole || stage_ == Stage::boxes; }
  bool is_worth_splitting(const TrajectoryFamily<D>& family) const;
  std::vector<IntruderCertificate> parts() const;

 private:
  enum class Stage : std::uint8_t { simple, whole, boxes, pieces };

  /// What is turned with the change: as in the middle of the range, and as much rounder as the others are
  /// away from there. Of boxes the disc around, where that is less.
  Encounter<D> encounter_between(double p, double q) const;

  Encounter<D> encounter_;
  AtFirst at_first_;
  Stage stage_;
  std::shared_ptr<const OutlinePair> outlines_;
  OutlinePair::Part part_;
  std::shared_ptr<PieceSum> sum_, turning_;  ///< the latter where it turns
  double round_ = 0;  ///< the radius, and how fast it grows, without boxes around what turns
};

/// Clear, or not proven: one change alone.
template <int D>
bool is_clear_of(const IntruderCertificate<D>& intruder, const TrajectoryFamily<D>& family, double k);

}  // namespace foresee
