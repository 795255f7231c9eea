// Rules of declared motion columns: the layout that they make, and the combinations that are refused.
//
// Throws Error for every combination that no table can have (docs/sql_reference.md#columns); the message
// quotes an argument and says what to add or to leave out.
#pragma once

#include <string>
#include <vector>

#include "shape/layout.h"
#include "sqlite/table/column_vocabulary.h"

namespace foresee {

struct DeclaredWord {
  Word word;
  std::string argument;  ///< as it was written
};

/// Requires: no word twice.
Layout layout_of(const std::vector<DeclaredWord>& words);

/// Where the quantity of `word` stands among a record's doubles.
int offset_of(const Offsets& at, const Word& word);

}  // namespace foresee
