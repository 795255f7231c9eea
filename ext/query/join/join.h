// Which pairs will meet, and when? predictive_join as a library call: candidates, contact, rows.
//
//   Join join({.a = ships, .now = 600, .h = 600, .within = 926}, interrupt);
//   for (auto rows = join.next(); !rows.empty(); rows = join.next())
//     for (const JoinRow& row : rows) use(row.a, row.b, row.contact.t);
//
// Guarantee: every pair that touches during [now, now + h] comes exactly once, whatever the method; in a
// self-join a < b. A scene joined with itself as two sides (b == a) gives every such pair in both orders, and
// never an object with itself. Columns that `wants` leaves out are not computed.
//
// Rows come in the order that is asked for. The grid answers long horizons in time slabs (time_slabs.h), and
// questions for an order in slabs that begin short: whoever stops after the first rows does not pay for the
// others. With helpers (slab_helpers.h) rows and their order are the same. Memory: the scenes, about a
// hundred bytes an object, one batch of pairs, and 24 bytes for each row of a slab that has to be sorted, or
// for some times as many as are read of it (likely_rows).
#pragma once

#include <memory>
#include <span>

#include "base/error.h"
#include "query/join/question.h"

namespace foresee {

class Join {
 public:
  /// Throws Error for what require_valid() refuses and for shapes without a distance. `interrupt` must
  /// outlive the join.
  Join(JoinQuestion question, Interrupt& interrupt);
  ~Join();
  Join(const Join&) = delete;
  Join& operator=(const Join&) = delete;

  /// The next rows, some thousands at most; empty once there are none left. Valid until the next call.
  std::span<const JoinRow> next();

 private:
  struct Progress;

  std::unique_ptr<Progress> progress_;
};

}  // namespace foresee
