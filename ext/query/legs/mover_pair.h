// Exact answers about two movers: their contacts and their closest approach, from the legs that exist together.
//
//   MoverPair pair(ships, ships, *contact, {now, h}, interrupt);
//   pair.add_ends(hits);                                  // of first contacts, followed from leg to leg
//   pair.contacts_within({7, 9}, 0, 60, found);           // all that start from 0 to 60
//
// A contact may last over many legs; contacts of legs are joined by mover_contacts.h. Only legs that exist together are
// compared. Cost: a step per leg and an exact test per pair of legs in the interval; for an end mostly one test.
// Has scratch space: used by one thread at a time.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "query/legs/mover_contacts.h"
#include "query/legs/movers.h"

namespace foresee {

/// Two legs that touch, by row number, and the times of the contact of their movers.
struct MoverHit {
  Pair legs;
  ContactTimes times;
};

class MoverPair {
 public:
  /// `contact`: of the scenes of both, during the horizon. All arguments must outlive this.
  MoverPair(const Movers& a, const Movers& b, Contact& contact, const Horizon& horizon, Interrupt& interrupt);

  /// Sets the end of contacts whose t and dt are known. Requires: each is the first contact of its movers.
  void add_ends(std::span<MoverHit> hits);
  /// add_ends() for hits that have the end of the contact of their legs, which may continue on other legs.
  void follow(std::span<MoverHit> hits);
  /// Sets the ends of contacts of two legs, each the first one of these legs.
  void add_leg_ends(std::span<MoverHit> hits);
  /// Whether a contact of two legs cannot be part of a longer contact of their movers: neither starts nor ends with a
  /// leg. Requires: the end is known.
  bool is_complete(const MoverHit& hit) const;
  /// Whether the movers of a hit touch before.
  bool touch_before(const MoverHit& hit);
  /// Replaces `found` by the contacts of two movers that start from `from` to `until`, in order, and perhaps others
  /// whose t is outside.
  void contacts_within(const Pair& movers, double from, double until, std::vector<ContactTimes>& found);
  /// The smallest distance of all pairs of legs, each rounded once; the earliest of equal ones.
  ClosestApproach closest_approach(const Pair& legs);

 private:
  /// Appends the contacts of all pairs of legs that exist together at some time of [from, until]. With `follow`, also
  /// of those afterwards, while contacts that start by `until` go on.
  void gather(const Pair& movers, double from, double until, bool follow);
  /// Appends the contacts of the pairs of `legs_`, which it clears.
  void test_legs();
  /// A contact that lasts to the end of a leg, and the pairs of legs that are tested next.
  struct Followed {
    MoverHit* hit;
    LegPairs legs;
    std::vector<ContactTimes> later;  ///< of pairs of legs, after a gap as yet
  };
  void follow_a_leg();
  double start_of(const Pair& legs) const { return std::max(a_.t(legs.a), b_.t(legs.b)); }
  double end_of(const Pair& legs) const { return std::min(a_.until(legs.a), b_.until(legs.b)); }
  bool is_clearly_farther(const Pair& legs, double distance) const;

  const Movers &a_, &b_;
  Contact& contact_;
  Horizon horizon_;
  Interrupt& interrupt_;
  bool tests_all_contacts_;  ///< of two legs: on bent paths there may be several
  std::vector<Pair> legs_, touching_;
  std::vector<ContactTimes> times_;
  std::vector<LegContact> gathered_;
  std::vector<Followed> followed_;
  std::vector<ClosestApproach> approaches_;
};

}  // namespace foresee
