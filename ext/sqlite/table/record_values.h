// Conversion of SQL values into an object's record, with validation of every column.
//
//   RowReader reader(declaration, "ships", interrupt);
//   const NewRecord row = reader.read(id, argv + 3, store);
//   store.insert(id, row.record, auxiliaries, row.origin, row.plan);
//
// The rules (docs/reference/moving_objects.md#values): integers and wholly numeric text convert, and '' is NULL. A NULL
// velocity, acceleration, extent or heading is 0, a NULL shape means no shape, a NULL until means no end. A
// value that breaks a rule throws Refusal (SQLITE_CONSTRAINT) with a message that names table, column, row id
// and value, and says what to write instead.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "database/sqlite_api.h"
#include "format/declaration.h"
#include "sqlite/plan_values.h"
#include "sqlite/table/column_vocabulary.h"
#include "storage/table/table_writer.h"

namespace foresee {

// Conversion of the columns `shape` or `zone` and `heading` into a record's fields: the number of the outline or mesh,
// and the bounding box of its rotated pose.
//
//   FormValues forms(declaration, interrupt);
//   forms.fill(record, value, old_record, store);
//
// The rules (docs/reference/shape.md#outlines): NULL and '' mean no shape; anything else is well-known text. A
// column that an UPDATE does not name arrives without a value and is neither printed nor parsed. If the
// heading is unchanged as well, the stored bounds are copied.
class FormValues {
 public:
  FormValues(const Declaration& declaration, Interrupt& interrupt)
      : shape_(declaration.layout.shape),
        has_zones_(declaration.has_zones()),
        at_(record_offsets(declaration.layout)),
        interrupt_(interrupt) {}

  bool has_zones() const { return has_zones_; }
  const char* column() const { return has_zones_ ? "zone" : "shape"; }

  /// Fills the fields of form number and bounds; the other fields of `record` are set already. `before`: the
  /// record that an UPDATE changes, else empty. Throws Error, without table and row, for a value that is not
  /// well-known text and for a form that cannot be rotated by the heading.
  void fill(std::span<double> record, sqlite3_value* shape, std::span<const double> before,
            TableWriter& store) const;

 private:
  StoredForms::Known form_of(sqlite3_value* value, TableWriter& store) const;

  Shape shape_;
  bool has_zones_;
  Offsets at_;
  Interrupt& interrupt_;
};

/// A row that an UPDATE changes.
struct UpdatedRow {
  std::int64_t id;
  std::span<const double> at_start = {};  ///< its record when the statement started, if it is known
  bool has_all_columns = false;           ///< SQLite passes also those that the statement leaves alone
};

/// What the values of a row become.
struct NewRecord {
  std::span<const double> record;
  const Plan* plan;  ///< for the store to keep; null: the row has none, or an UPDATE leaves it alone
  std::optional<LatLon> origin;  ///< chosen by the first position of a table that has none yet
};

/// The columns of one table: reads their values as the record of a row, as the start of this file shows.
class RowReader {
 public:
  /// `interrupt` must outlive the reader.
  RowReader(const Declaration& declaration, const std::string& table, Interrupt& interrupt);

  void rename(const std::string& table) { table_ = table; }

  /// `motion`: one value per declared motion column, in declared order. `updated`: for an UPDATE. Adds new
  /// outlines and meshes to the store; objects stay unchanged. The result is valid until the next call.
  NewRecord read(std::int64_t id, sqlite3_value** motion, TableWriter& store,
                 const std::optional<UpdatedRow>& updated = {});

  /// The id in this value; nothing for NULL and ''. `updated`: the row that an UPDATE changes. Throws Refusal
  /// (SQLITE_MISMATCH) for a value that is not an integer.
  std::optional<std::int64_t> id(sqlite3_value* value, std::optional<std::int64_t> updated = {}) const;

 private:
  struct Column {
    std::string name;
    Quantity quantity;
    int place;
    GeoColumn geo;
    bool is_plain;          ///< its number is that of its value alone
    bool takes_any_number;  ///< every finite one
  };

  /// The report of a row as far as it is written or known, by GeoColumn.
  using Numbers = std::array<std::optional<double>, geo_columns>;

  // tables in degrees (degrees_values.cpp)
  void fill_degrees(std::int64_t id, sqlite3_value** motion, TableWriter& store,
                    std::optional<std::int64_t> updated);
  std::optional<double> degrees_number(const Column& column, std::int64_t id, sqlite3_value* value) const;
  double latitude_or_longitude(const Column& column, std::int64_t id, sqlite3_value* value) const;
  double height_or_climb(const Column& column, std::int64_t id, sqlite3_value* value) const;
  std::optional<double> speed_or_course(const Column& column, std::int64_t id, sqlite3_value* value) const;
  std::optional<Course> course_of_row(std::int64_t id, const std::optional<double>& speed,
                                      const std::optional<double>& course, sqlite3_value* given) const;
  Flight report_of(std::int64_t id, const Numbers& numbers, sqlite3_value* course) const;
  Metres metres_of_row(std::int64_t id, const Flight& report, const LatLon& origin, bool same_place) const;
  void require_near(std::int64_t id, const LatLon& place, const Metres& point, const LatLon& origin) const;
  void store_degrees(const Metres& point);
  void copy_place(const std::vector<double>& before);
  void copy_motion(const std::vector<double>& before);

  // tables with plans (planned_rows.cpp)
  void start_planned_row(std::int64_t id, sqlite3_value** motion, TableWriter& store,
                         const std::optional<UpdatedRow>& updated);
  void keep_plan();
  void read_plan(std::int64_t id, sqlite3_value* value, TableWriter& store,
                 std::optional<std::int64_t> updated);
  void require_place_without_plan(const UpdatedRow& updated, sqlite3_value** motion,
                                  TableWriter& store) const;
  void require_until_of_new_plan(std::int64_t id, sqlite3_value** motion, TableWriter& store) const;
  bool shows_before(const Column& column, sqlite3_value* value, const std::optional<Flight>& report) const;
  bool is_of_before(int place, double number) const;
  double number_of_leg(const Column& column, std::int64_t id, sqlite3_value* value) const;
  void check_degrees_of_leg(std::int64_t id, sqlite3_value** motion, TableWriter& store) const;
  [[noreturn]] void refuse_beside_plan(const Column& column, std::int64_t id, sqlite3_value* value,
                                       const std::optional<double>& of_plan) const;
  void require_heading_beside_plan(std::int64_t id, sqlite3_value** motion) const;

  void fill_form(std::int64_t id, sqlite3_value* shape, TableWriter& store,
                 std::optional<std::int64_t> updated);
  /// Reads and checks the SQL value of a column.
  double number_to_store(const Column& column, std::int64_t id, sqlite3_value* value) const;
  double kind_to_store(const Column& column, std::int64_t id, sqlite3_value* value) const;
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
  std::vector<std::size_t> degrees_;  ///< the columns with a GeoColumn, in its order; empty: a plain table
  Frame frame_;                       ///< as declared
  std::optional<LatLon> new_origin_;
  PlanValues plans_;
  std::optional<Plan> new_plan_;
  std::vector<double> leg_;           ///< the first leg of the row's plan, as in a record; empty: it has none
  std::vector<double> before_;        ///< of a table with plans: the record that an UPDATE changes
  std::span<const double> at_start_;  ///< … and how it was when the statement started, if known
};

}  // namespace foresee
