// What does a virtual table say about itself? Keys and values in <name>_meta.
//
//   MetaRows meta(tables);                      // MetaRows::table() is one of them
//   meta.write("format", std::int64_t{2});
//   meta.read("format") == "2"
//
// Cost: a look-up each, under a microsecond; reading and writing are compiled once, at their first use.
// Reading takes one variable, writing two: a connection may allow no more.
#pragma once

#include <optional>
#include <string_view>

#include "storage/rows/shadow_tables.h"

namespace foresee {

class MetaRows {
 public:
  static ShadowTable table() { return {"meta", "(key TEXT PRIMARY KEY, value) WITHOUT ROWID"}; }

  explicit MetaRows(const ShadowTables& tables)
      : read_(tables.statement("SELECT value FROM {meta} WHERE key = ?1")),
        write_(tables.statement("INSERT OR REPLACE INTO {meta} VALUES(?1, ?2)")) {}

  /// What stands under a key, as text; "" where there is nothing. Of a text that is longer than `limit` bytes
  /// only the beginning: who reads it compares it with what is shorter.
  std::string read(std::string_view key, std::size_t limit = 100) {
    Statement::Run run(read_);
    run.bind(1, key);
    return run.step() ? run.text(0, limit) : "";
  }

  /// Nothing if the key is missing or its value is no integer.
  std::optional<std::int64_t> read_integer(std::string_view key) {
    Statement::Run run(read_);
    run.bind(1, key);
    return run.step() && run.is_integer(0) ? std::optional(run.integer(0)) : std::nullopt;
  }

  template <class Value>
  void write(std::string_view key, const Value& value) {
    Statement::Run run(write_);
    run.bind(1, key);
    run.bind(2, value);
    run.step();
  }

 private:
  Statement read_, write_;
};

}  // namespace foresee
