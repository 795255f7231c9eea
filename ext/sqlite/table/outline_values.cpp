#include "sqlite/table/outline_values.h"

#include <algorithm>

#include "storage/rows/text.h"

namespace foresee::sqlite {
namespace {

StoredOutlines::Known outline_of(sqlite3_value* shape, Store& store) {
  if (sqlite3_value_type(shape) != SQLITE_TEXT)
    throw Error(shown(shape) +
                " is no text: write well-known text as in 'POLYGON((0 0, 4 0, 0 3, 0 0))', or NULL");
  return store.find_or_add_outline(text_of(shape));
}

}  // namespace

void OutlineValues::fill(std::span<double> record, sqlite3_value* shape, std::span<const double> before,
                         Store& store) const {
  const auto heading_of = [this](std::span<const double> numbers) {
    return value_or(numbers.data(), at_.heading, 0);
  };
  double &number = record[static_cast<std::size_t>(at_.outline)],
         *const bounds = &record[static_cast<std::size_t>(at_.bounds)];
  std::shared_ptr<const CutOutline> outline;
  number = 0;
  std::fill_n(bounds, 4, 0.0);
  if (!before.empty() && sqlite3_value_nochange(shape)) {
    number = before[static_cast<std::size_t>(at_.outline)];
    if (heading_of(record) == heading_of(before)) {
      std::copy_n(&before[static_cast<std::size_t>(at_.bounds)], 4, bounds);
      return;
    }
    if (number != 0) outline = store.outline(static_cast<std::int64_t>(number));
  } else if (!is_null_or_empty(shape)) {
    const StoredOutlines::Known known = outline_of(shape, store);
    number = static_cast<double>(known.number), outline = known.outline;
  }
  if (!outline) return;
  const Extents<2> around = outline->as_it_lies(heading_of(record)).extents();
  std::copy_n(around.lower.data(), 2, bounds);
  std::copy_n(around.upper.data(), 2, bounds + 2);
}

}  // namespace foresee::sqlite
