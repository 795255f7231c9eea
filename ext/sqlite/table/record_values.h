// May this be stored, and as which double? From SQL's values to one object's record.
//
//   Values values(declaration, "ships");
//   store.insert(id, values.record(id, argv + 3, store), auxiliaries);
//
// The rules (docs/sql_reference.md#values): integers and wholly numeric text convert, '' is NULL, a NULL
// velocity, acceleration, extent or heading is 0, a NULL shape is none, a NULL until is for ever. What breaks
// a rule throws Refusal (SQLITE_CONSTRAINT) with a message that names table, column, row id and value, and
// says what to write instead.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sqlite/table/column_vocabulary.h"
#include "storage/format/declaration.h"
#include "storage/rows/sqlite_api.h"
#include "storage/table/store.h"

namespace foresee {

// Which outline or mesh does a row have, and how does it lie? From SQL's value of `shape` and the heading to
// what a record says of them: the form's number and the smallest box around it as it is turned.
//
//   FormValues forms(layout);
//   forms.fill(record, value, old_record, store);
//
// The rules (docs/sql_reference.md#outlines): NULL and '' are none; anything else is well-known text. A
// column that an UPDATE does not name comes without a value and is neither printed nor parsed; where the
// heading stays too, nothing is turned.

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

class Values {
 public:
  Values(const Declaration& declaration, const std::string& table);

  void rename(const std::string& table) { table_ = table; }

  /// `motion`: one value a declared motion column, in their order. `updated`: the row that an UPDATE changes.
  /// Outlines and meshes are stored, by which nothing is changed. Valid until the next call.
  std::span<const double> record(std::int64_t id, sqlite3_value** motion, Store& store,
                                 std::optional<std::int64_t> updated = {});

  /// The id that this value means; none for NULL and ''. Throws Refusal (SQLITE_MISMATCH) for what is no
  /// integer.
  std::optional<std::int64_t> id(sqlite3_value* value) const;

 private:
  struct Column {
    std::string name;
    Quantity quantity;
    int place;
  };

  void fill_form(std::int64_t id, sqlite3_value* shape, Store& store, std::optional<std::int64_t> updated);
  double stored(const Column& column, std::int64_t id, sqlite3_value* value) const;
  void require_motion_to_last(std::int64_t id) const;
  void require_finite_acceleration(std::int64_t id) const;
  [[noreturn]] void refuse(const std::string& column, std::int64_t id, const std::string& value,
                           const std::string& rule) const;

  std::string table_;
  Layout layout_;
  Offsets at_;
  std::vector<Column> columns_;
  FormValues forms_;
  std::vector<double> record_;
};

}  // namespace foresee
