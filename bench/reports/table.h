// One table of a comparison: ours, an ordinary table with SQLite's R*Tree of swept boxes beside it, or the
// ordinary table alone. The same rows in, the same rows out, whatever the kind.
//
//   Table ours(Table::foresee, feed.objects(), Medium::wal, files.ours);
//   ours.insert_all(writes_of(feed.objects()));
//   ours.update_all(writes_of(feed.random_reports(1000), feed.objects()));
#pragma once

#include <memory>

#include "program.h"
#include "reports/feed.h"
#include "sql.h"

namespace foresee::bench {

/// Where a table is, and how its commits are made safe. No commit waits for the disk (synchronous = OFF).
enum class Medium { memory, journal, wal };
const char* name_of(Medium medium);
/// The media that the command names, --memory, --journal or --wal; without any, `otherwise`.
std::vector<Medium> mediums_of(const Options& options, std::vector<Medium> otherwise);

/// Rows to write with the boxes that they sweep, ready before the clock starts.
struct Writes {
  std::vector<std::int64_t> ids;
  std::vector<double> rows;
  std::vector<double> boxes;  ///< lower and upper of every axis: over [t, t + h] of the workload

  std::size_t size() const { return ids.size(); }
};

/// All objects of a workload in the order of their ids, as rows to load.
Writes writes_of(const Workload& w);
/// `w` has the layout of the rows.
Writes writes_of(const Reports& reports, const Workload& w);

class Table {
 public:
  enum Kind { foresee, rtree, ordinary };

  /// Makes an empty table "ships"; `path` counts where the medium is a file.
  Table(Kind kind, const Workload& w, Medium medium, const std::string& path);

  Database& db() { return db_; }

  /// A prepared single-row INSERT, or UPDATE of all columns of position and motion by id; for an R*Tree the
  /// box as well. No transaction of its own.
  void insert(const Writes& writes, std::size_t i);
  /// Not of an R*Tree.
  void insert(std::int64_t id, const double* row);
  void update(const Writes& writes, std::size_t i);

  /// All of `writes` in one transaction.
  void insert_all(const Writes& writes);
  void update_all(const Writes& writes);

  /// update() in a transaction of its own.
  void update_alone(const Writes& writes, std::size_t i);

 private:
  int columns_, moving_columns_, box_columns_;
  Database db_;
  std::unique_ptr<Statement> insert_, update_, insert_box_, update_box_;
  Statement begin_{db_, "BEGIN"}, commit_{db_, "COMMIT"};
};

/// Whether the two tables hold the same rows, bit for bit.
bool same_rows(Table& a, Table& b);

}  // namespace foresee::bench
