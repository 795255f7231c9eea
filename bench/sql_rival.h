// Plain-SQL join that a user would write without foresee: a base table, SQLite's own R*Tree of swept boxes
// beside it, and the exact test as an SQL function.
//
// The exact test is foresee's own contact, so both give the same rows and only the search for pairs differs.
#pragma once

#include <memory>
#include <vector>

#include "contact/contact.h"
#include "shape/swept_boxes.h"
#include "sql.h"
#include "workloads.h"

namespace foresee::bench {

/// Objects of two axes (the workloads S, K, L, M and D).
class Rival {
 public:
  enum Tables { makes_tables, stands_ready };

  /// Makes the two tables in `db`, unless they exist, and the function first_contact().
  Rival(Database& db, const Workload& workload, Tables tables = makes_tables);

  /// Single-row INSERTs into both tables, in one transaction. The swept boxes are ready.
  void load();

  /// The swept box of the object of this row.
  static void store_box(Statement& box, std::size_t row, const Box<2>& swept);
  /// The object of this row in both tables, moved on by (dx, dy) from where the workload has it.
  void move(Statement& object, Statement& box, std::size_t row, double dx, double dy);
  static constexpr const char* move_object_sql = "UPDATE base SET x = ?, y = ? WHERE id = ?";
  static constexpr const char* move_box_sql = "UPDATE boxes SET x0 = ?, x1 = ?, y0 = ?, y1 = ? WHERE id = ?";

  /// Rows (a, b, t) of the self-join over the workload's horizon.
  std::string join_sql() const;

 private:
  static void first_contact(sqlite3_context* context, int count, sqlite3_value** values);

  Database& db_;
  const Workload& workload_;
  std::vector<Box<2>> boxes_;
  std::vector<double> pair_rows_;  // the two objects of first_contact()
  std::unique_ptr<Contact> contact_;
};

}  // namespace foresee::bench
