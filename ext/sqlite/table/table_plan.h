// Query plans of a moving_objects table, as xBestIndex chooses them.
//
//   const TablePlan plan = TablePlan::of(number);    // in xFilter, of its idxNum
//
// - A `scan` reads every object, leaf by leaf. It ignores its arguments.
// - `one_object` looks up the id that is its argument.
// - `handle` has one row with the table's number, the key of Connection::find. Its argument is 'foresee-handle'.
// - `ids` has at least the objects whose ids satisfy the bounds, its arguments; with an order, by their ids.
//
// `scan` and `ids` may have only the objects without a plan, for IS NULL: to convert a plan would take as long as to
// read a thousand rows.
//
// Table-valued functions use `handle` to find a table by name: `WHERE "ships" MATCH 'foresee-handle'`.
#pragma once

#include <optional>

#include "sqlite/table/moving_objects_table.h"

namespace foresee {

struct TablePlan {
  enum Kind : int { scan = 0, one_object = 1, handle = 2, ids = 3 };

  Kind kind = scan;
  bool has_first = false, has_last = false;  ///< of ids: a lower bound, an upper one, in this order
  std::optional<IdOrder> order = {};         ///< of ids: the query relies on it
  bool without_plan = false;                 ///< only objects without a plan

  /// SQLite's idxNum.
  int number() const {
    return kind | (has_first ? first_bit : 0) | (has_last ? last_bit : 0) | (order ? order_bit : 0) |
           (order == IdOrder::descending ? descending_bit : 0) | (without_plan ? without_plan_bit : 0);
  }
  static TablePlan of(int number) {
    TablePlan plan{static_cast<Kind>(number & kind_bits), (number & first_bit) != 0,
                   (number & last_bit) != 0};
    if (number & order_bit) plan.order = number & descending_bit ? IdOrder::descending : IdOrder::ascending;
    plan.without_plan = (number & without_plan_bit) != 0;
    return plan;
  }

 private:
  static constexpr int kind_bits = 3, first_bit = 4, last_bit = 8, order_bit = 16, descending_bit = 32,
                       without_plan_bit = 64;
};

constexpr const char* handle_word = "foresee-handle";

/// xBestIndex: `handle` for MATCH, `one_object` if the id is given, `ids` for bounds of the id or if rows are wanted in
/// the order of ids, else `scan`. Costs follow from Store::likely_objects. Returns SQLITE_CONSTRAINT if the operand of
/// MATCH is not available in this plan.
int plan_table(const MovingObjectsTable& table, sqlite3_index_info* info);

}  // namespace foresee
