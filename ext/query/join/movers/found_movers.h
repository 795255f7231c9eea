// Contacts of movers from contacts of legs, one slab after another: one per pair of movers, or all.
//
//   FoundMovers found(question, a, b, pair, false);
//   found.add(hits, legs_a, legs_b);                      // of all candidates of a slab
//   found.finish(slab, interrupt);                        // joined and in the requested order
//   while (found.any()) found.take(rows, interrupt);
//
// First contacts: a table has the pairs that have a row, 32 to 64 bytes each. A leg that touches in a slab is the first
// to do so unless its movers are in the table. Where t or dt is bounded from below, legs before the first slab are
// tested.
// All contacts: a contact belongs to the slab in which it starts. Hits that neither start nor end with a leg are such
// contacts; for the others the legs of the slab are compared, and the contact is followed to its end.
// Memory: 48 bytes per hit of a slab.
#pragma once

#include <algorithm>
#include <vector>

#include "base/repeatable_choice.h"
#include "query/join/contact_stage.h"
#include "query/legs/mover_pair.h"
#include "query/legs/slab_legs.h"

namespace foresee {

/// A set of pairs of movers with a number for each. Open addressing, because it is read once per hit.
class PairTable {
 public:
  /// The number of a pair; `number` if the pair is new.
  std::uint64_t find_or_add(const Pair& pair, std::uint64_t number);
  /// Whether a pair has a number less than `number`.
  bool holds_before(const Pair& pair, std::uint64_t number) const {
    for (std::size_t i = place_of(pair);; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].number_plus_one == 0) return false;
      if (slots_[i].pair == key_of(pair)) return slots_[i].number_plus_one <= number;
    }
  }
  /// Fetches the place of a pair that is looked up soon.
  void prefetch(const Pair& pair) const { __builtin_prefetch(&slots_[place_of(pair)]); }

 private:
  static std::uint64_t key_of(const Pair& pair) { return std::uint64_t{pair.a} << 32 | pair.b; }
  std::size_t place_of(const Pair& pair) const { return key_of(pair) * by_golden_ratio >> shift_; }

  struct Slot {
    std::uint64_t pair, number_plus_one;  ///< 0: empty
  };
  void grow();

  std::vector<Slot> slots_ = std::vector<Slot>(64);  // few: a join about one object has them, too
  std::size_t size_ = 0;
  int shift_ = 58;
};

class FoundMovers {
 public:
  /// All arguments must outlive this.
  /// `in_one_slab`: the join has no other.
  FoundMovers(const JoinQuestion& question, const Movers& a, const Movers& b, MoverPair& pair,
              bool in_one_slab)
      : question_(question),
        a_(a),
        b_(b),
        pair_(pair),
        keeps_all_(question.all_contacts ||
                   (in_one_slab && a.count() == a.scene()->size() && b.count() == b.scene()->size())) {}

  /// Whether pairs have rows of earlier slabs.
  bool knows_pairs() const { return pairs_before_ > 0 && !keeps_all_; }
  /// Drops candidates of legs whose movers have one, or are one, before their contact is computed.
  void drop_found(std::vector<Pair>& candidates, const SlabLegs& legs_a, const SlabLegs& legs_b);

  /// Adds hits of the open slab; their row numbers are those of the slab's legs.
  void add(const Hits& hits, const SlabLegs& legs_a, const SlabLegs& legs_b);
  /// Requires: all hits of the slab were added.
  void finish(const TimeSlab& slab, Interrupt& interrupt);

  /// After finish(): whether contacts are left, and the next few of them with all times that are wanted.
  bool any() const { return given_ < found_.size(); }
  void take(std::vector<MoverHit>& hits, Interrupt& interrupt);

 private:
  /// The movers of two rows of the slab; within one table in the order of their numbers.
  Pair movers_of(const Pair& rows, const SlabLegs& legs_a, const SlabLegs& legs_b) const {
    const std::uint32_t a = legs_a.mover(rows.a), b = legs_b.mover(rows.b);
    return question_.b ? Pair{a, b} : Pair{std::min(a, b), std::max(a, b)};
  }
  /// Drops first contacts outside the queried times, and those whose movers touch before.
  void keep_first_contacts(Interrupt& interrupt);
  /// Replaces hits by the contacts of their movers that start in the slab.
  void join_contacts(const TimeSlab& slab, Interrupt& interrupt);
  /// Appends the contacts of one pair of movers, whose hits are [first, last).
  void join_contacts_of(std::size_t first, std::size_t last, const TimeSlab& slab);
  bool are_queried(const ContactTimes& times) const {
    return question_.queried_t.holds(times.t) && question_.queried_dt.holds(times.dt);
  }
  /// In the requested order. Ids and ends break ties, so no two contacts are equal.
  bool precedes(const MoverHit& l, const MoverHit& r) const;
  void sort_some(Interrupt& interrupt);

  const JoinQuestion& question_;
  const Movers &a_, &b_;
  MoverPair& pair_;
  bool keeps_all_;  ///< all contacts, or movers of one leg: no hit is of a pair that is found before
  PairTable pairs_;
  std::uint64_t pairs_before_ = 0;  ///< those found in earlier slabs
  bool with_ends_ = false;          ///< of the hits
  std::vector<MoverHit> found_, joined_;
  std::vector<Pair> keys_;
  std::vector<ContactTimes> contacts_;
  std::size_t sorted_ = 0, given_ = 0, room_ = 0;
};

}  // namespace foresee
