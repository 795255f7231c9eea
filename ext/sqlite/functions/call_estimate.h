// What will a call probably take? For SQLite's planner, which chooses the order in which tables are joined.
//
//   estimate_join({.objects = 1e6}).cost == 1.4e7             // a whole join
//   estimate_pairs_of_one({.objects = 1e6}, true).cost        // a = ?: about 1100
//
// Costs are in the unit of the planner, to which a look-up in an ordinary table is about 20. They are as
// measured on scenes where an object touches a few others; nobody knows before how many rows a horizon gives.
// Only the sizes of tables make them large or small, and these are those that memory knows: nothing is read.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "sqlite/connection.h"

namespace foresee {

struct TableFunction;

struct CallSizes {
  double objects = 0;                 ///< of tbl
  std::optional<double> others = {};  ///< of other; none: it is left out
  std::optional<double> k = {};       ///< where it is written out
};

struct CallEstimate {
  double cost, rows;
};

/// Every object and its pairs.
CallEstimate estimate_positions(const CallSizes& sizes);
/// The object of one id, looked up.
CallEstimate estimate_object(const CallSizes& sizes, bool by_first);
/// The same at some moments one after another.
CallEstimate estimate_tracks(const CallSizes& sizes);
CallEstimate estimate_track(const CallSizes& sizes, bool by_first);
/// A few nodes of the tree, and some objects.
CallEstimate estimate_window(const CallSizes& sizes);
CallEstimate estimate_nearest(const CallSizes& sizes);
/// The objects near one, each looked at for every range of changes.
CallEstimate estimate_avoid(const CallSizes& sizes);
/// The whole join: its pairs, or the stages that explain it.
CallEstimate estimate_join(const CallSizes& sizes);
CallEstimate estimate_stages(const CallSizes& sizes);
/// The pairs of one object: of tbl (a = ?), or of other (b = ?).
CallEstimate estimate_pairs_of_one(const CallSizes& sizes, bool by_a);

/// Of the tables that a call names. `written`: its inputs as the statement writes them out, null where it
/// does not; bit set in `given`: the input is given, be it bound later or computed. A table whose name is
/// bound later counts as the largest that is connected.
CallSizes call_sizes(const TableFunction& function, const Connection& connection,
                     std::span<sqlite3_value* const> written, std::uint32_t given);

}  // namespace foresee
