// Predictive join: which pairs of objects come into contact, and when. predictive_join as a library call.
//
//   Join join({.a = ships, .now = 600, .h = 600, .within = 926}, interrupt);
//   for (auto rows = join.next(); !rows.empty(); rows = join.next())
//     for (const JoinRow& row : rows) use(row.a, row.b, row.contact.t);
//
// Guarantee: every pair that touches during [now, now + h] comes exactly once, whatever the method; in a
// self-join a < b. With all_contacts it comes once for each of its contacts that t and t_end tell apart.
// A scene joined with itself as two sides (b == a) gives every such pair in both orders, and
// never an object with itself. An object with a plan touches when one of its legs does, and its closest approach is
// that of its legs (movers/leg_join.h). Columns that `wants` leaves out are not computed.
//
// Rows come in the requested order. The grid answers long horizons in time slabs (time_slabs.h). For an
// ordered result the first slabs are short, so a reader that stops early does not pay for the later rows.
// With helpers (slab_helpers.h) rows and their order are the same. Memory: the scenes at about a hundred
// bytes per object, one batch of pairs, and 24 bytes for each row of a slab that has to be sorted. If few
// rows are likely to be read (likely_rows), only a multiple of that number is kept.
#pragma once

#include <memory>
#include <span>

#include "base/error.h"
#include "query/join/question.h"

namespace foresee {

class LegJoin;

class Join {
 public:
  /// Throws Error where require_valid() does, and for shapes without a distance. `interrupt` must outlive the
  /// join.
  Join(JoinQuestion question, Interrupt& interrupt);
  ~Join();
  Join(const Join&) = delete;
  Join& operator=(const Join&) = delete;

  /// The next rows, a few thousand at most; empty at the end. Valid until the next call. If it throws, as `interrupt`
  /// may, each later call throws Error.
  std::span<const JoinRow> next();

 private:
  struct ObjectJoin;

  std::unique_ptr<ObjectJoin> objects_;
  std::unique_ptr<LegJoin> legs_;  ///< in place of it, for tables with plans
  UnbrokenCalls unbroken_;
};

}  // namespace foresee
