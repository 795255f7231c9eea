// Stored chunks of plans: the legs of all objects with a plan, in <name>_leg(number, data).
//
//   LegRows rows(tables);
//   rows.write(8, blob);                                   // format/chunk_blob.h
//   rows.read(8, 10, [&](std::int64_t number, std::span<const std::byte> blob) { … });
//
// The chunks of one plan have consecutive numbers. Blobs are not checked; a value of another type reads as an empty
// one. Row numbers are integers that ascend strictly, else the call fails with SQLITE_CORRUPT_VTAB.
// Cost: one look-up per call, and some 100 ns per row of a range.
#pragma once

#include <limits>
#include <span>
#include <string>

#include "storage/rows/ascending_rows.h"
#include "storage/rows/shadow_tables.h"

namespace foresee {

class LegRows {
 public:
  static ShadowTable table() { return {"leg", "(number INTEGER PRIMARY KEY, data BLOB)"}; }

  explicit LegRows(const ShadowTables& tables)
      : table_(tables.name().table),
        largest_(tables.statement("SELECT number FROM {leg} ORDER BY number DESC LIMIT 1")),
        between_(tables.statement(
            "SELECT number, data FROM {leg} WHERE number BETWEEN ?1 AND ?2 ORDER BY number")),
        one_(tables.statement("SELECT data FROM {leg} WHERE number = ?1")),
        write_(tables.statement("INSERT OR REPLACE INTO {leg} VALUES(?1, ?2)")),
        erase_(tables.statement("DELETE FROM {leg} WHERE number BETWEEN ?1 AND ?2")) {}

  /// 0: no rows.
  std::int64_t read_largest_number() {
    Statement::Run run(largest_);
    return run.step() ? number_after(std::nullopt, run, {table_, "leg"}) : 0;
  }

  /// Calls read(number, blob) for every row from `first` to `last`, numbers ascending.
  template <class Read>
  void read(std::int64_t first, std::int64_t last, Read read) {
    Statement::Run run(between_);
    run.bind(1, first);
    run.bind(2, last);
    for (std::optional<std::int64_t> before; run.step(); read(*before, run.blob(1)))
      before = number_after(before, run, {table_, "leg"});
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
  template <class Read>
  void read_all(Read each) {
    read(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(), each);
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
  std::string table_;
  Statement largest_, between_, one_, write_, erase_;
};

}  // namespace foresee
