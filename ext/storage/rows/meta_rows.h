// What does a virtual table say about itself? Keys and values in <name>_meta.
//
//   MetaRows meta(tables);                      // MetaRows::table() is one of them
//   meta.write("format", std::int64_t{2});
//   meta.read("format") == "2"
//
// Cost: a look-up each; reading and writing are compiled once. No statement has more variables than a write
// needs: a connection may allow two only.
#pragma once

#include <algorithm>

#include "storage/rows/shadow_tables.h"

namespace foresee::storage {

class MetaRows {
 public:
  static ShadowTable table() { return {"meta", "(key TEXT PRIMARY KEY, value) WITHOUT ROWID"}; }

  explicit MetaRows(const ShadowTables& tables)
      : read_(tables.statement("SELECT substr(value, 1, 4000) FROM {meta} WHERE key = ?1")),
        write_(tables.statement("INSERT OR REPLACE INTO {meta} VALUES(?1, ?2)")) {}

  /// What stands under a key, as text; "" where there is nothing. Of a text that is longer than `most` bytes
  /// (at most 4000) only the beginning: who reads it compares it with what is shorter.
  std::string read(const std::string& key, std::size_t most = 100) {
    Statement::Run run(read_);
    run.bind(1, key);
    if (!run.step()) return "";
    std::string text = run.text(0);
    const auto continues = [&text](std::size_t i) { return (text[i] & 0xC0) == 0x80; };  // a UTF-8 character
    while (most > 0 && most < text.size() && continues(most)) --most;
    text.resize(std::min(text.size(), most));
    return text;
  }

  template <class Value>
  void write(const std::string& key, const Value& value) {
    Statement::Run run(write_);
    run.bind(1, key);
    run.bind(2, value);
    run.step();
  }

 private:
  Statement read_, write_;
};

}  // namespace foresee::storage
