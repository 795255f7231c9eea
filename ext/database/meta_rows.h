// Keys and values that a virtual table stores about itself in <name>_meta.
//
//   MetaRows meta(tables);                      // MetaRows::table() is one of `tables`
//   meta.write("format", std::int64_t{2});
//   meta.read("format") == "2"
//
// Cost: a look-up each, less than a microsecond; both statements are compiled at their first use. Reading
// uses one SQL variable and writing two: a connection may limit their number.
#pragma once

#include <optional>
#include <string_view>

#include "database/shadow_tables.h"

namespace foresee {

class MetaRows {
 public:
  static ShadowTable table() { return {"meta", "(key TEXT PRIMARY KEY, value) WITHOUT ROWID"}; }

  explicit MetaRows(const ShadowTables& tables)
      : read_(tables.statement("SELECT value FROM {meta} WHERE key = ?1")),
        write_(tables.statement("INSERT OR REPLACE INTO {meta} VALUES(?1, ?2)")) {}

  /// The value of a key as text; "" if there is no value. A text longer than `limit` bytes is cut off, which
  /// is enough to compare it with shorter ones.
  std::string read(std::string_view key, std::size_t limit = 100) {
    Statement::Run run(read_);
    run.bind(1, key);
    return run.step() ? run.text(0, limit) : "";
  }

  /// Nothing if the key is missing or its value is not an integer.
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
