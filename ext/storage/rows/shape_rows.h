// Stored outlines or meshes of a table: each once, by number, in <name>_shape(number, hash, data).
//
//   ShapeRows shapes(tables, Shape::outline);
//   const std::int64_t number = shapes.find(blob).value_or(0);      // equal bytes, equal number
//   shapes.add(8, blob);
//   shapes.read(8)                                                  // throws if there is no such number
//
// Rows may be damaged. SQLITE_CORRUPT_VTAB reports a missing number, a number outside 1 to 2^53 (a record
// holds it in a double), or a blob that is not a form of this shape (format/form_blob.h). `hash` is the
// checksum of the blob, the key of find(). Cost: one look-up per call.
#pragma once

#include <optional>
#include <span>

#include "database/ascending_rows.h"
#include "database/shadow_tables.h"
#include "shape/shared_form.h"

namespace foresee {

class ShapeRows {
 public:
  static ShadowTable table() {
    return {"shape", "(number INTEGER PRIMARY KEY, hash INTEGER, data BLOB, UNIQUE(hash, number))"};
  }

  /// `shape`: of the layout of the table.
  ShapeRows(const ShadowTables& tables, Shape shape);

  /// The number of the form with these bytes.
  std::optional<std::int64_t> find(std::span<const std::byte> blob);
  /// 0: no rows.
  std::int64_t read_largest_number();
  /// Requires: the number is not in use.
  void add(std::int64_t number, std::span<const std::byte> blob);
  std::shared_ptr<const Form> read(std::int64_t number);
  void erase(std::int64_t number);

  /// Calls read(number, fault, form) for every row, numbers ascending; fault: what is wrong with the row, or
  /// null.
  template <class Read>
  void read_all(Read read) {
    read_ascending(all_, {table_, "shape"}, [&](std::int64_t number, Statement::Run& run) {
      std::shared_ptr<const Form> form;
      const char* const fault = row_fault(run, form);
      read(number, fault, form);
    });
  }
  template <class Read>
  void read_numbers(Read read) {
    read_ascending(numbers_, {table_, "shape"}, [&](std::int64_t number, Statement::Run&) { read(number); });
  }

 private:
  /// The number of the current row of `run`. Throws unless it is larger than `last`, the previous one, if
  /// any.
  std::int64_t number_of(std::optional<std::int64_t> last, Statement::Run& run) const;
  /// Returns what is wrong with a row whose columns 1 and 2 are hash and data; null: nothing.
  const char* row_fault(Statement::Run& run, std::shared_ptr<const Form>& form) const;

  std::string table_;
  Shape shape_;
  Statement by_hash_, largest_, add_, read_, erase_, all_, numbers_;
};

}  // namespace foresee
