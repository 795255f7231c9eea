// Which outline does a row have, and how does it lie? From SQL's value of `shape` and the heading to what a
// record says of them: the outline's number and the smallest box around it as it is turned.
//
//   OutlineValues outlines(layout);
//   outlines.fill(record, value, old_record, store);
//
// The rules (docs/sql_reference.md#outlines): NULL and '' are no outline; anything else is well-known text. A
// column that an UPDATE does not name comes without a value and is neither printed nor parsed; where the
// heading stays too, nothing is turned.
#pragma once

#include <span>

#include "storage/rows/sqlite_api.h"
#include "storage/table/store.h"

namespace foresee::sqlite {

class OutlineValues {
 public:
  explicit OutlineValues(const Layout& layout) : at_(record_offsets(layout)) {}

  /// Fills the places of outline and bounds; the rest of `record` is there. `before`: the record that an
  /// UPDATE changes, else empty. Throws Error, without table and row, for a text that is no outline and for
  /// an outline that cannot be turned so.
  void fill(std::span<double> record, sqlite3_value* shape, std::span<const double> before,
            Store& store) const;

 private:
  Offsets at_;
};

}  // namespace foresee::sqlite
