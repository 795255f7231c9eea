#include "storage/rows/shape_rows.h"

#include <algorithm>

#include "database/sqlite_api.h"
#include "format/form_blob.h"

namespace foresee {

ShapeRows::ShapeRows(const ShadowTables& tables, Shape shape)
    : table_(tables.name().table),
      shape_(shape),
      by_hash_(tables.statement("SELECT number, data FROM {shape} WHERE hash = ?1 ORDER BY number")),
      largest_(tables.statement("SELECT number FROM {shape} ORDER BY number DESC LIMIT 1")),
      add_(tables.statement("INSERT INTO {shape} VALUES(?1, ?2, ?3)")),
      read_(tables.statement("SELECT number, hash, data FROM {shape} WHERE number = ?1")),
      erase_(tables.statement("DELETE FROM {shape} WHERE number = ?1")),
      all_(tables.statement("SELECT number, hash, data FROM {shape} ORDER BY number")),
      numbers_(tables.statement("SELECT number FROM {shape} ORDER BY number")) {}

std::int64_t ShapeRows::number_of(std::optional<std::int64_t> last, Statement::Run& run) const {
  const std::int64_t number = number_after(last, run, {table_, "shape"});
  if (number < 1 || number > largest_form_number)
    throw StoreError(SQLITE_CORRUPT_VTAB, table_ + ": " + table_ + "_shape is damaged: row " +
                                              std::to_string(number) + " cannot be the number of " +
                                              (shape_ == Shape::mesh ? "a mesh" : "an outline"));
  return number;
}

std::optional<std::int64_t> ShapeRows::find(std::span<const std::byte> blob) {
  Statement::Run run(by_hash_);
  run.bind(1, std::int64_t{checksum_of_form(blob)});
  for (std::optional<std::int64_t> last; run.step();) {
    last = number_of(last, run);
    const auto stored = run.blob(1);
    if (std::equal(stored.begin(), stored.end(), blob.begin(), blob.end())) return last;
  }
  return std::nullopt;
}

std::int64_t ShapeRows::read_largest_number() {
  Statement::Run run(largest_);
  return run.step() ? number_of(std::nullopt, run) : 0;
}

void ShapeRows::add(std::int64_t number, std::span<const std::byte> blob) {
  if (number > largest_form_number)
    throw StoreError(SQLITE_FULL,
                     table_ + ": no number is left for " + (shape_ == Shape::mesh ? "a mesh" : "an outline"));
  Statement::Run run(add_);
  run.bind(1, number);
  run.bind(2, std::int64_t{checksum_of_form(blob)});
  run.bind(3, blob);
  run.step();
}

std::shared_ptr<const Form> ShapeRows::read(std::int64_t number) {
  const std::string where = table_ + ": " + name_of_form(shape_) + ' ' + std::to_string(number);
  Statement::Run run(read_);
  run.bind(1, number);
  if (!run.step()) throw StoreError(SQLITE_CORRUPT_VTAB, where + " is missing in " + table_ + "_shape");
  std::shared_ptr<const Form> form;
  if (const char* fault = row_fault(run, form))
    throw StoreError(SQLITE_CORRUPT_VTAB, where + " is damaged: " + fault);
  return form;
}

void ShapeRows::erase(std::int64_t number) {
  Statement::Run run(erase_);
  run.bind(1, number);
  run.step();
}

const char* ShapeRows::row_fault(Statement::Run& run, std::shared_ptr<const Form>& form) const {
  if (!run.is_blob(2)) return "it is not a blob";
  const std::span<const std::byte> blob = run.blob(2);
  if (const char* fault = decode_form(blob, shape_, form)) return fault;
  const bool agrees = run.is_integer(1) && run.integer(1) == std::int64_t{checksum_of_form(blob)};
  return agrees ? nullptr : "its hash is not that of its content";
}

}  // namespace foresee
