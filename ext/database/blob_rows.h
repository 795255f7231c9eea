// Shadow tables of numbered blobs: the nodes of a tree, and the chunks of plans.
//
//   BlobRows rows(tables, "leg", "number");                // ships_leg(number INTEGER PRIMARY KEY, data BLOB)
//   rows.write(8, blob);
//   rows.read(8, 10, [&](std::int64_t number, std::span<const std::byte> blob) { … });
//
// Nothing is cached: each call sees the database as this connection sees it now. Blobs are not checked; a value of
// another type reads as an empty one. Numbers are integers that ascend strictly, else the call fails with
// SQLITE_CORRUPT_VTAB (ascending_rows.h).
// Cost: one look-up per call, and some 100 ns per row of a range.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <type_traits>

#include "database/ascending_rows.h"
#include "database/shadow_tables.h"

namespace foresee {

class BlobRows {
 public:
  static ShadowTable table(const std::string& suffix, const std::string& key) {
    return {suffix, "(" + key + " INTEGER PRIMARY KEY, data BLOB)"};
  }

  /// `key`: the column of the numbers.
  BlobRows(const ShadowTables& tables, const std::string& suffix, const std::string& key)
      : table_(tables.name().table),
        suffix_(suffix),
        largest_(tables.statement("SELECT " + key + " FROM {" + suffix + "} ORDER BY 1 DESC LIMIT 1")),
        one_(tables.statement("SELECT data FROM {" + suffix + "} WHERE " + key + " = ?1")),
        from_(tables.statement("SELECT " + key + ", data FROM {" + suffix + "} WHERE " + key +
                               " >= ?1 ORDER BY 1")),
        numbers_(tables.statement("SELECT " + key + " FROM {" + suffix + "} ORDER BY 1")),
        write_(tables.statement("INSERT OR REPLACE INTO {" + suffix + "} VALUES(?1, ?2)")),
        erase_(tables.statement("DELETE FROM {" + suffix + "} WHERE " + key + " BETWEEN ?1 AND ?2")) {}

  /// 0: no rows.
  std::int64_t read_largest() {
    Statement::Run run(largest_);
    return run.step() ? number_after(std::nullopt, run, rows()) : 0;
  }
  /// Calls read(blob) if the row exists; returns whether it does.
  template <class Read>
  bool read_one(std::int64_t number, Read read) {
    Statement::Run run(one_);
    run.bind(1, number);
    if (!run.step()) return false;
    read(run.blob(0));
    return true;
  }
  /// Calls read(number, blob) for every row from `first` to `last`, numbers ascending; one that returns false ends it.
  template <class Read>
  void read(std::int64_t first, std::int64_t last, Read read) {
    Statement::Run run(from_);
    run.bind(1, first);
    for (std::optional<std::int64_t> number; number != last && run.step();) {
      if (number = number_after(number, run, rows()); *number > last) return;
      if constexpr (std::is_void_v<decltype(read(*number, run.blob(1)))>)
        read(*number, run.blob(1));
      else if (!read(*number, run.blob(1)))
        return;
    }
  }
  template <class Read>
  void read_all(Read each) {
    read(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(), each);
  }
  /// Calls read(number) for every row, by ascending number, without a copy of the blob.
  template <class Read>
  void read_numbers(Read read) {
    read_ascending(numbers_, rows(), [&](std::int64_t number, Statement::Run&) { read(number); });
  }
  /// Calls read(number, blob) for the first row after number `after`; returns whether there is one.
  template <class Read>
  bool read_after(std::int64_t after, Read read) {
    if (after == std::numeric_limits<std::int64_t>::max()) return false;
    Statement::Run run(from_);
    run.bind(1, after + 1);
    if (!run.step()) return false;
    read(number_after(after, run, rows()), run.blob(1));
    return true;
  }

  /// Replaces the stored blob, if there is one.
  void write(std::int64_t number, std::span<const std::byte> blob) {
    Statement::Run run(write_);
    run.bind(1, number);
    run.bind(2, blob);
    run.step();
  }
  void erase(std::int64_t first, std::int64_t last) {
    Statement::Run run(erase_);
    run.bind(1, first);
    run.bind(2, last);
    run.step();
  }

 private:
  RowsOf rows() const { return {table_, suffix_.c_str()}; }

  std::string table_, suffix_;
  Statement largest_, one_, from_, numbers_, write_, erase_;
};

}  // namespace foresee
