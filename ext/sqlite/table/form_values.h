// Which outline or mesh does a row have, and how does it lie? From SQL's value of `shape` and the heading to
// what a record says of them: the form's number and the smallest box around it as it is turned.
//
//   FormValues forms(layout);
//   forms.fill(record, value, old_record, store);
//
// The rules (docs/sql_reference.md#outlines): NULL and '' are none; anything else is well-known text. A
// column that an UPDATE does not name comes without a value and is neither printed nor parsed; where the
// heading stays too, nothing is turned.
#pragma once

#include <span>

#include "storage/rows/sqlite_api.h"
#include "storage/table/store.h"

namespace foresee {

class FormValues {
 public:
  explicit FormValues(const Layout& layout) : shape_(layout.shape), at_(record_offsets(layout)) {}

  /// Fills the places of number and bounds; the rest of `record` is there. `before`: the record that an
  /// UPDATE changes, else empty. Throws Error, without table and row, for a text that is none and for a
  /// form that cannot be turned so.
  void fill(std::span<double> record, sqlite3_value* shape, std::span<const double> before,
            Store& store) const;

 private:
  Shape shape_;
  Offsets at_;
};

}  // namespace foresee
