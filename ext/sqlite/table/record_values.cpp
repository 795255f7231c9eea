#include "sqlite/table/record_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/float_environment.h"
#include "base/integer_of.h"
#include "base/number_text.h"
#include "database/value_text.h"
#include "geography/zone.h"
#include "shape/kinds.h"
#include "shape/outline/shared_outline.h"
#include "sqlite/callback.h"

namespace foresee {

namespace {

/// A text as an example in messages.
const char* example_of(Shape shape, bool is_zone) {
  if (is_zone) return "'POLYGON((7.8 53.9, 8 53.9, 7.9 54, 7.8 53.9))'";
  return shape == Shape::mesh ? "'TIN Z(((0 0 0, 4 0 0, 0 3 1, 0 0 0)))'" : "'POLYGON((0 0, 4 0, 0 3, 0 0))'";
}

std::shared_ptr<const Form> zone_form(std::string_view text, const LatLon& origin, Interrupt& interrupt) {
  Zone zone = read_zone(text, origin, interrupt);
  return std::make_shared<const SharedOutline>(std::move(zone.plane), std::move(zone.degrees));
}

}  // namespace

StoredForms::Known FormValues::form_of(sqlite3_value* value, TableWriter& store) const {
  if (sqlite3_value_type(value) != SQLITE_TEXT)
    throw Error(shown(value) + " is no text: write well-known text as in " + example_of(shape_, has_zones_) +
                (has_zones_ ? "" : ", or NULL"));
  if (!has_zones_) return store.find_or_add_form(text_of(value));
  const LatLon origin = *store.frame().origin;
  return store.find_or_add_form(text_of(value),
                                [&](std::string_view text) { return zone_form(text, origin, interrupt_); });
}

void FormValues::fill(std::span<double> record, sqlite3_value* shape, std::span<const double> before,
                      TableWriter& store) const {
  const auto heading_of = [this](std::span<const double> numbers) {
    return value_or(numbers.data(), at_.heading, 0);
  };
  double &number = record[static_cast<std::size_t>(at_.outline)],
         *const bounds = &record[static_cast<std::size_t>(at_.bounds)];
  std::shared_ptr<const Form> form;
  const int axes = bounded_axes(shape_);
  number = 0;
  std::fill_n(bounds, 2 * axes, 0.0);
  // The C library of another machine may project the same corners to other bits: the stored ones are kept.
  const auto is_same_zone = [&] {
    const double stored = before.empty() ? 0 : before[static_cast<std::size_t>(at_.outline)];
    return has_zones_ && stored != 0 && sqlite3_value_type(shape) == SQLITE_TEXT &&
           store.form(static_cast<std::int64_t>(stored))->text() == text_of(shape);
  };
  if (!before.empty() && (sqlite3_value_nochange(shape) || is_same_zone())) {
    number = before[static_cast<std::size_t>(at_.outline)];
    if (heading_of(record) == heading_of(before)) {
      std::copy_n(&before[static_cast<std::size_t>(at_.bounds)], 2 * axes, bounds);
      return;
    }
    if (number != 0) form = store.form(static_cast<std::int64_t>(number));
  } else if (has_zones_ && is_null_or_empty(shape)) {
    throw Error(shown(shape) + " is no place: write well-known text as in " + example_of(shape_, true) +
                ", or leave the row out");
  } else if (!is_null_or_empty(shape)) {
    const StoredForms::Known known = form_of(shape, store);
    number = static_cast<double>(known.number);
    form = known.form;
  }
  if (!form) return;
  const Extents<3> around = form->extents(heading_of(record));
  std::copy_n(around.lower.data(), axes, bounds);
  std::copy_n(around.upper.data(), axes, bounds + axes);
}

namespace {

/// SQLITE_INTEGER or SQLITE_FLOAT for numbers and wholly numeric text, SQLITE_NULL for NULL and '',
/// SQLITE_TEXT or SQLITE_BLOB for the rest.
int type_as_number(sqlite3_value* value) {
  const int type = sqlite3_value_type(value);
  if (type != SQLITE_TEXT) return type;
  return is_null_or_empty(value) ? SQLITE_NULL : sqlite3_value_numeric_type(value);
}

const char* rule_for_null(Quantity quantity, bool has_plan) {
  switch (quantity) {
    case Quantity::reference_time:
      return has_plan ? "a declared reference time or a plan is needed; write one of them"
                      : "a declared reference time is needed; write the time at which the position holds";
    case Quantity::mass:
      return "a force needs a mass; write a number greater than 0";
    default:
      return has_plan ? "a position or a plan is needed; write one of them"
                      : "a position is needed; write a finite number";
  }
}

/// Whether every finite number is a value of such a column.
bool takes_any_number(Quantity quantity) {
  switch (quantity) {
    case Quantity::centre:
    case Quantity::velocity:
    case Quantity::acceleration:
    case Quantity::force:
    case Quantity::reference_time:
    case Quantity::until:
      return true;
    default:
      return false;
  }
}

const char* rule_for_infinity(Quantity quantity) {
  return quantity == Quantity::until ? "not a finite number; write NULL for no end"
                                     : "not a finite number; write a finite one";
}

}  // namespace

RowReader::RowReader(const Declaration& declaration, const std::string& table, Interrupt& interrupt)
    : table_(table),
      layout_(declaration.layout),
      at_(record_offsets(layout_)),
      forms_(declaration, interrupt),
      frame_(declaration.frame),
      plans_(declaration, interrupt) {
  for (const MotionColumn& column : declaration.columns) {
    const Quantity quantity = find_word(column.name)->quantity;
    const bool is_plain = !layout_.has_plan && column.geo == GeoColumn::none && quantity != Quantity::form;
    columns_.push_back(
        {column.name, quantity, column.place, column.geo, is_plain, takes_any_number(quantity)});
  }
  for (std::size_t which = 1; which < geo_columns; ++which)
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i].geo == static_cast<GeoColumn>(which)) degrees_.push_back(i);
  record_.assign(static_cast<std::size_t>(at_.size), 0.0);
}

NewRecord RowReader::read(std::int64_t id, sqlite3_value** motion, TableWriter& store,
                          const std::optional<UpdatedRow>& updated) {
  const std::optional<std::int64_t> old_id = updated ? std::optional(updated->id) : std::nullopt;
  if (layout_.has_plan) start_planned_row(id, motion, store, updated);
  sqlite3_value* shape = nullptr;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    if (column.is_plain)
      record_[static_cast<std::size_t>(column.place)] = number_to_store(column, id, motion[i]);
    else if (column.quantity == Quantity::form)
      shape = motion[i];
    else if (column.geo == GeoColumn::none && column.quantity != Quantity::plan)
      record_[static_cast<std::size_t>(column.place)] = layout_.has_plan && is_of_leg(column.quantity)
                                                            ? number_of_leg(column, id, motion[i])
                                                            : number_to_store(column, id, motion[i]);
  }
  if (!leg_.empty()) {
    check_degrees_of_leg(id, motion, store);
    std::copy(leg_.begin(), leg_.end(), record_.begin());
  } else if (!degrees_.empty()) {
    fill_degrees(id, motion, store, old_id);
  }
  if (layout_.has_until) require_motion_to_last(id);
  if (layout_.law == Law::forced) require_finite_acceleration(id);
  if (shape) fill_form(id, shape, store, old_id);
  if (!leg_.empty()) require_heading_beside_plan(id, motion);
  return {record_, new_plan_ ? &*new_plan_ : nullptr, new_origin_};
}

void RowReader::fill_form(std::int64_t id, sqlite3_value* shape, TableWriter& store,
                          std::optional<std::int64_t> updated) try {
  std::vector<double> before;
  if (updated && (sqlite3_value_nochange(shape) || forms_.has_zones()))
    before = store.read(*updated).value_or(before);
  forms_.fill(record_, shape, before, store);
} catch (const StoreError&) {
  throw;
} catch (const Error& error) {
  throw Refusal(SQLITE_CONSTRAINT,
                table_ + "." + forms_.column() + " of row " + std::to_string(id) + ": " + error.what());
}

double RowReader::number_to_store(const Column& column, std::int64_t id, sqlite3_value* value) const {
  const Quantity quantity = column.quantity;
  const int type = type_as_number(value);
  if (type == SQLITE_FLOAT && column.takes_any_number) {
    const double number = sqlite3_value_double(value);
    if (std::isfinite(number)) return number;
  }
  if (is_kind(quantity)) return kind_to_store(column, id, value);
  if (type == SQLITE_NULL) {
    if (quantity == Quantity::until) return std::numeric_limits<double>::infinity();
    if (quantity == Quantity::reference_time || quantity == Quantity::centre || quantity == Quantity::mass)
      refuse(column.name, id, shown(value), rule_for_null(quantity, layout_.has_plan));
    return 0;
  }
  if (type != SQLITE_INTEGER && type != SQLITE_FLOAT) {
    const bool time = quantity == Quantity::reference_time || quantity == Quantity::until;
    const auto seconds = time ? as_unixepoch(value) : std::nullopt;
    refuse(column.name, id, shown(value),
           seconds ? "a date, where seconds are stored; write " + *seconds
                   : "not a number; write a finite number");
  }
  const double number = sqlite3_value_double(value);
  if (type == SQLITE_INTEGER && is_inexact(value))
    refuse(column.name, id, shown(value),
           "no double holds this integer; write " + shown(number) + " for the nearest that one does");
  if (!std::isfinite(number)) refuse(column.name, id, shown(value), rule_for_infinity(quantity));
  if (column.takes_any_number) return number;
  if (number < 0 && quantity == Quantity::half_extent)
    refuse(column.name, id, shown(value), "a half extent is never negative; write 0 or more");
  if (number < 0 && quantity == Quantity::radius)
    refuse(column.name, id, shown(value), "a radius is never negative; write 0 or more");
  if (number < 0 && quantity == Quantity::growth)
    refuse(column.name, id, shown(value), "a growth is never negative; write 0 or more");
  if (std::abs(number) > 360 && quantity == Quantity::heading)
    refuse(column.name, id, shown(value),
           number == 511
               ? "write -360 to 360 (511 is \"not available\" in AIS: write the course, or NULL for "
                 "shape and half the length as r)"
               : "beyond a full turn; write degrees from -360 to 360");
  if (number <= 0 && quantity == Quantity::mass)
    refuse(column.name, id, shown(value), "a mass is never 0 or negative; write a number greater than 0");
  return number;
}

/// The bits of a category or a mask; NULL and '' are the default.
double RowReader::kind_to_store(const Column& column, std::int64_t id, sqlite3_value* value) const {
  const int type = type_as_number(value);
  if (type == SQLITE_NULL) return column.quantity == Quantity::category ? Kinds{}.category : Kinds{}.mask;
  const double number = sqlite3_value_double(value);
  const bool is_number = type == SQLITE_INTEGER || type == SQLITE_FLOAT;
  if (!is_number || !(0 <= number && number <= every_kind && number == std::floor(number)))
    refuse(column.name, id, shown(value), "not 32 bits; write a whole number from 0 to 4294967295, or NULL");
  return static_cast<std::uint32_t>(number);  // and so never -0
}

void RowReader::require_motion_to_last(std::int64_t id) const {
  const double t = value_or(record_.data(), at_.t, 0);
  const double until = record_[static_cast<std::size_t>(at_.until)];
  if (until < t)
    refuse("until", id, shown(until),
           "before the reference time " + shown(t) + "; write " + shown(t) + " or more, or NULL for no end");
}

void RowReader::require_finite_acceleration(std::int64_t id) const {
  const FloatEnvironment environment;
  const double mass = record_[static_cast<std::size_t>(at_.mass)];
  for (int axis = 0; axis < layout_.axes; ++axis) {
    const double force = record_[static_cast<std::size_t>(at_.force + axis)];
    if (!std::isfinite(force / mass))
      refuse(std::string(word_for(Quantity::force, axis)), id, shown(force),
             "divided by the mass " + shown(mass) + " it overflows; write a smaller force or a greater mass");
  }
}

void RowReader::refuse(const std::string& column, std::int64_t id, const std::string& value,
                       const std::string& rule) const {
  throw Refusal(SQLITE_CONSTRAINT,
                table_ + "." + column + " of row " + std::to_string(id) + " is " + value + ": " + rule);
}

std::optional<std::int64_t> RowReader::id(sqlite3_value* value, std::optional<std::int64_t> updated) const {
  switch (type_as_number(value)) {
    case SQLITE_NULL:
      return std::nullopt;
    case SQLITE_INTEGER:
      return sqlite3_value_int64(value);
    case SQLITE_FLOAT:
      if (const auto integer = integer_of(sqlite3_value_double(value))) return integer;
      break;
    default:
      break;
  }
  // Only a new row has an id assigned.
  throw Refusal(SQLITE_MISMATCH, table_ + ".id" + (updated ? " of row " + std::to_string(*updated) : "") +
                                     " is " + shown(value) + ": not an integer; write an INTEGER, " +
                                     (updated ? "not NULL" : "or NULL to have one assigned"));
}

}  // namespace foresee
