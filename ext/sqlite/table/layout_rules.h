// Layout rules of declared motion columns: the layout that a set of columns yields, and the invalid sets.
//
// Throws Error for every combination that no table can have (docs/reference/moving_objects.md#columns). The message
// quotes an argument and says what to add or to leave out.
#pragma once

#include <string>
#include <vector>

#include "shape/row_layout.h"
#include "sqlite/table/column_vocabulary.h"

namespace foresee {

struct DeclaredWord {
  Word word;
  std::string argument;  ///< as the user wrote it
};

/// Requires: no word occurs twice.
Layout layout_of(const std::vector<DeclaredWord>& words);

/// Index of the quantity of `word` among a record's doubles.
int offset_of(const Offsets& at, const Word& word);

}  // namespace foresee
