// Cost estimates of calls, from which SQLite's planner chooses the order in which tables are joined.
//
//   estimate_join({.objects = 1e6}).cost == 1.4e7             // a whole join
//   estimate_pairs_of_one({.objects = 1e6}, true).cost        // a = ?: about 1100
//
// Costs are in the planner's unit, in which a look-up in an ordinary table costs about 20. They were measured
// on scenes where an object touches a few others; the number of rows that a horizon gives is not known in
// advance. An estimate depends on table sizes alone, and takes those from memory: nothing is read.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "sqlite/connection.h"

namespace foresee {

struct TableFunction;

struct CallSizes {
  double objects = 0;                 ///< of tbl
  std::optional<double> others = {};  ///< of other; nothing if that is left out
  std::optional<double> k = {};       ///< if it is a literal
};

struct CallEstimate {
  double cost, rows;
};

/// All objects, decoded: one row per object.
CallEstimate estimate_positions(const CallSizes& sizes);
/// The object of one id, by a look-up.
CallEstimate estimate_object(const CallSizes& sizes, bool by_first);
/// Positions at several instants: of all objects, and of the object of one id.
CallEstimate estimate_tracks(const CallSizes& sizes);
CallEstimate estimate_track(const CallSizes& sizes, bool by_first);
/// A search that reads a few nodes of the tree, and some objects.
CallEstimate estimate_window(const CallSizes& sizes);
/// A window about the object of one id.
CallEstimate estimate_window_of_one(const CallSizes& sizes, bool by_first);
CallEstimate estimate_nearest(const CallSizes& sizes);
/// The objects near one object, each tested for every range of manoeuvres.
CallEstimate estimate_avoid(const CallSizes& sizes);
/// The whole join: of its pairs, and of the stages that explain it.
CallEstimate estimate_join(const CallSizes& sizes);
CallEstimate estimate_stages(const CallSizes& sizes);
/// The pairs of one object: of tbl (a = ?), or of other (b = ?).
CallEstimate estimate_pairs_of_one(const CallSizes& sizes, bool by_a);

/// The sizes of the tables that a call names. `written`: the inputs that are literals in the statement, null
/// for all others. Bit set in `given`: the input is given, as a literal, bound later or computed. If a
/// table's name is bound later, its size is that of the largest connected table.
CallSizes call_sizes(const TableFunction& function, const Connection& connection,
                     std::span<sqlite3_value* const> written, std::uint32_t given);

}  // namespace foresee
