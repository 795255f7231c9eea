// Join of scenes with plans: contacts of legs slab by slab, joined to contacts of movers.
//
//   LegJoin join(question, interrupt);                    // as Join (join.h), which calls it
//   for (auto rows = join.next(); !rows.empty(); rows = join.next()) …
//
// Each slab joins the legs that exist in it as if they were objects, by any method, with or without helper threads.
// An object without a plan is a mover of one leg, so both kinds of objects and all pairs of them are one join. A mover
// never meets itself. Rows of a slab come once all its legs are compared.
// Memory: the legs of a slab, its hits, and 32 to 64 bytes per row found.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "query/join/join_plan.h"
#include "query/join/movers/found_movers.h"
#include "query/join/slab_helpers.h"

namespace foresee {

class LegJoin {
 public:
  /// `question`: as Join prepares it, with its kinds, its tile and a grid space. `interrupt` must outlive this.
  LegJoin(JoinQuestion question, Interrupt& interrupt);
  ~LegJoin();
  LegJoin(const LegJoin&) = delete;
  LegJoin& operator=(const LegJoin&) = delete;

  std::span<const JoinRow> next();

 private:
  /// Joins the legs of the next slab; false after the last.
  bool join_slab();
  /// The query about the legs of a slab, whose rows are hits.
  JoinQuestion question_of_legs() const;
  void add(Hits& hits);
  void write(std::span<const MoverHit> hits);

  JoinQuestion question_;
  Interrupt& interrupt_;
  Movers a_;
  std::optional<Movers> other_;  ///< of side b, if that is another scene
  const Movers& b_;
  std::shared_ptr<Contact> contact_;  ///< of whole scenes
  MoverPair pair_;
  JoinPlan plan_;
  TimeSlabs slabs_;
  SlabLegs legs_a_;
  std::optional<SlabLegs> legs_b_;
  FoundMovers found_;
  std::vector<Pair> pairs_;
  Hits hits_;
  std::vector<MoverHit> taken_;
  std::vector<JoinRow> rows_;
};

}  // namespace foresee
