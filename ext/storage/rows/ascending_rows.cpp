#include "storage/rows/ascending_rows.h"

#include "storage/rows/store_error.h"

namespace foresee {

std::int64_t number_after(std::optional<std::int64_t> last, Statement::Run& run, const RowsOf& rows) {
  const auto damaged = [&](const std::string& what) {
    throw StoreError(SQLITE_CORRUPT_VTAB,
                     rows.table + ": " + rows.table + "_" + rows.suffix + " is damaged: " + what);
  };
  if (!run.is_integer(0)) damaged("the number of a row is not an integer");
  const std::int64_t number = run.integer(0);
  if (last && number <= *last)
    damaged("row " + std::to_string(number) + " comes after row " + std::to_string(*last));
  return number;
}

}  // namespace foresee
