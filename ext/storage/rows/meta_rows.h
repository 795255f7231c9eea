// What does a virtual table say about itself? Keys and values in <name>_meta.
//
//   MetaRows meta(tables);                      // MetaRows::table() is one of them
//   meta.write("format", std::int64_t{2});
//   meta.read("format") == "2"
//
// Cost: a look-up each, and compiling it. No statement has more variables than a write needs: a connection
// may allow two only.
#pragma once

#include "storage/rows/shadow_tables.h"

namespace foresee::storage {

class MetaRows {
 public:
  static ShadowTable table() { return {"meta", "(key TEXT PRIMARY KEY, value) WITHOUT ROWID"}; }

  /// `tables` must live as long.
  explicit MetaRows(const ShadowTables& tables)
      : tables_(tables), write_(tables.statement("INSERT OR REPLACE INTO {meta} VALUES(?1, ?2)")) {}

  /// What stands under a key, as text; "" where there is nothing. Of a text that is longer than `most` only
  /// the beginning: who reads it compares it with what is shorter.
  std::string read(const std::string& key, std::size_t most = 100) {
    Statement reads =
        tables_.statement("SELECT substr(value, 1, " + std::to_string(most) + ") FROM {meta} WHERE key = ?1");
    Statement::Run run(reads);
    run.bind(1, key);
    return run.step() ? run.text(0) : "";
  }

  template <class Value>
  void write(const std::string& key, const Value& value) {
    Statement::Run run(write_);
    run.bind(1, key);
    run.bind(2, value);
    run.step();
  }

 private:
  const ShadowTables& tables_;
  Statement write_;
};

}  // namespace foresee::storage
