// Which outlines or meshes does a table have, for good? Each once, by number, in <name>_shape(number, hash,
// data).
//
//   ShapeRows shapes(tables, Shape::outline);
//   const std::int64_t number = shapes.find(blob).value_or(0);      // equal bytes, equal number
//   shapes.add(8, blob);
//   shapes.read(8)                                                  // throws where there is no such number
//
// Rows are hostile: SQLITE_CORRUPT_VTAB for a number that is missing, or not from 1 to 2^53, as records hold
// it in a double, and for a blob that is none of this shape (format/form_blob.h). `hash` is the blob's
// checksum, by which find() looks. Cost: a look-up each.
#pragma once

#include <optional>
#include <span>

#include "shape/form.h"
#include "storage/rows/ascending_rows.h"
#include "storage/rows/shadow_tables.h"

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
  /// 0: there is none.
  std::int64_t read_largest_number();
  /// Requires: there is no such number.
  void add(std::int64_t number, std::span<const std::byte> blob);
  std::shared_ptr<const Form> read(std::int64_t number);
  void erase(std::int64_t number);

  /// Calls read(number, fault, form) with every row, numbers ascending; fault: what is wrong with the row,
  /// or null.
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
  /// The number of the row on which `run` stands, behind the row `last` if there was one.
  std::int64_t number_of(std::optional<std::int64_t> last, Statement::Run& run) const;
  /// Of a row whose columns 1 and 2 are hash and data.
  const char* row_fault(Statement::Run& run, std::shared_ptr<const Form>& form) const;

  std::string table_;
  Shape shape_;
  Statement by_hash_, largest_, add_, read_, erase_, all_, numbers_;
};

}  // namespace foresee
