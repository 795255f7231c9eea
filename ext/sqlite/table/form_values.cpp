#include "sqlite/table/form_values.h"

#include <algorithm>

#include "storage/rows/text.h"

namespace foresee {
namespace {

StoredForms::Known form_of(Shape kind, sqlite3_value* shape, Store& store) {
  if (sqlite3_value_type(shape) != SQLITE_TEXT)
    throw Error(shown(shape) + " is no text: write well-known text as in " +
                (kind == Shape::mesh ? "'TIN Z(((0 0 0, 4 0 0, 0 3 1, 0 0 0)))'"
                                     : "'POLYGON((0 0, 4 0, 0 3, 0 0))'") +
                ", or NULL");
  return store.find_or_add_form(text_of(shape));
}

}  // namespace

void FormValues::fill(std::span<double> record, sqlite3_value* shape, std::span<const double> before,
                      Store& store) const {
  const auto heading_of = [this](std::span<const double> numbers) {
    return value_or(numbers.data(), at_.heading, 0);
  };
  double &number = record[static_cast<std::size_t>(at_.outline)],
         *const bounds = &record[static_cast<std::size_t>(at_.bounds)];
  std::shared_ptr<const Form> form;
  const int axes = bounded_axes(shape_);
  number = 0;
  std::fill_n(bounds, 2 * axes, 0.0);
  if (!before.empty() && sqlite3_value_nochange(shape)) {
    number = before[static_cast<std::size_t>(at_.outline)];
    if (heading_of(record) == heading_of(before)) {
      std::copy_n(&before[static_cast<std::size_t>(at_.bounds)], 2 * axes, bounds);
      return;
    }
    if (number != 0) form = store.form(static_cast<std::int64_t>(number));
  } else if (!is_null_or_empty(shape)) {
    const StoredForms::Known known = form_of(shape_, shape, store);
    number = static_cast<double>(known.number), form = known.form;
  }
  if (!form) return;
  const Extents<3> around = form->extents(heading_of(record));
  std::copy_n(around.lower.data(), axes, bounds);
  std::copy_n(around.upper.data(), axes, bounds + axes);
}

}  // namespace foresee
