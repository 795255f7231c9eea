// RowReader: rows of tables with a column `plan` (docs/reference/plan.md#column). The first leg of a plan gives t, x…,
// v… and a… of its row, so a value of these columns is checked and not stored.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/float_environment.h"
#include "base/number_text.h"
#include "database/value_text.h"
#include "motion/plan/plan_legs.h"
#include "shape/chunk_item.h"
#include "sqlite/callback.h"
#include "sqlite/table/degrees_columns.h"
#include "sqlite/table/record_values.h"

namespace foresee {
namespace {

/// Whether a column in degrees shows this number of a first leg. A copy of a row projects its plan again, so the
/// numbers agree within rounding only.
bool is_near(GeoColumn column, double number, double shown) {
  switch (column) {
    case GeoColumn::lat:
      return std::abs(number - shown) <= 1e-9;
    case GeoColumn::lon:
      return std::abs(std::remainder(number - shown, 360)) <= 1e-9;
    case GeoColumn::course:
      return std::abs(std::remainder(number - shown, 360)) <= 1e-4;
    default:
      return std::abs(number - shown) <= 1e-6 * (1 + shown);
  }
}

}  // namespace

void RowReader::start_planned_row(std::int64_t id, sqlite3_value** motion, TableWriter& store,
                                  const std::optional<UpdatedRow>& updated) {
  new_plan_.reset();
  new_origin_.reset();
  leg_.clear();
  before_.clear();
  at_start_ = updated ? updated->at_start : std::span<const double>();
  std::fill(record_.begin(), record_.end(), 0.0);  // what is not declared
  record_[static_cast<std::size_t>(at_.until)] = std::numeric_limits<double>::infinity();
  if (updated) before_ = store.read(updated->id).value_or(before_);
  const auto column = std::find_if(columns_.begin(), columns_.end(),
                                   [](const Column& one) { return one.quantity == Quantity::plan; });
  sqlite3_value* const plan = motion[column - columns_.begin()];
  if (before_.empty() || !sqlite3_value_nochange(plan))
    read_plan(id, plan, store, updated ? std::optional(updated->id) : std::nullopt);
  else if (foresee::has_plan(at_, before_.data()))
    keep_plan();
  if (leg_.empty() && !before_.empty() && foresee::has_plan(at_, before_.data()))
    require_place_without_plan(*updated, motion, store);
  if (updated && new_plan_ && !before_.empty()) require_until_of_new_plan(updated->id, motion, store);
}

/// Whether the value is what the column showed before. `report`: of the row, in a table in degrees.
bool RowReader::shows_before(const Column& column, sqlite3_value* value,
                             const std::optional<Flight>& report) const {
  if (is_null_or_empty(value)) return false;
  const double number = sqlite3_value_double(value);
  return report ? shown_number(column.geo, *report) == number : is_of_before(column.place, number);
}

/// `SET plan = (SELECT …)` of no row would leave the object at the start of its old plan: no query would see where it
/// goes. So the whole position must be set. Where SQLite passes all columns, as SQLite 3.40 in an UPDATE FROM, some of
/// it must differ.
void RowReader::require_place_without_plan(const UpdatedRow& updated, sqlite3_value** motion,
                                           TableWriter& store) const {
  std::optional<Flight> report;
  if (updated.has_all_columns && frame_.in_degrees())
    report = shown_report(store, updated.id, at_start_.empty() ? before_.data() : at_start_.data());
  std::string names;
  bool is_all_set = true;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
    if (column.quantity != Quantity::centre) continue;
    names += (names.empty() ? "" : ", ") + column.name;
    if (!updated.has_all_columns)
      is_all_set &= !sqlite3_value_nochange(motion[i]);
    else if (!shows_before(column, motion[i], report))
      return;
  }
  if (is_all_set && !updated.has_all_columns) return;
  refuse("plan", updated.id, "NULL",
         "without its plan the object needs a position; set " + names + " too, or DELETE the row");
}

/// The `until` of the old plan would cut a new one that ends later: the object would vanish on its way. An UPDATE FROM
/// passes every column in SQLite 3.40, so what is the same as before counts as not set.
void RowReader::require_until_of_new_plan(std::int64_t id, sqlite3_value** motion, TableWriter& store) const {
  const bool has_knots = new_plan_->kind == PlanKind::knots;
  const double until = before_[static_cast<std::size_t>(at_.until)],
               end = has_knots ? new_plan_->knots.back().t : new_plan_->legs.back().until;
  if (!(until < end)) return;
  if (foresee::has_plan(at_, before_.data()) && store.read_plan(id, before_) == *new_plan_) return;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].quantity != Quantity::until) continue;
    const bool is_same = !is_null_or_empty(motion[i]) && sqlite3_value_double(motion[i]) == until;
    if (is_same || sqlite3_value_nochange(motion[i]))
      refuse("until", id, foresee::shown(until),
             "before the end of the new plan, " + foresee::shown(end) +
                 "; set until to NULL too, or cut the plan with plan_cut");
  }
}

void RowReader::keep_plan() {
  leg_.assign(before_.begin(), before_.begin() + static_cast<std::ptrdiff_t>(leg_doubles(layout_)));
  for (const int place : {at_.plan, at_.chunks})
    record_[static_cast<std::size_t>(place)] = before_[static_cast<std::size_t>(place)];
}

void RowReader::read_plan(std::int64_t id, sqlite3_value* value, TableWriter& store,
                          std::optional<std::int64_t> updated) try {
  const FloatEnvironment environment;
  std::optional<Plan> written = plans_.written(value);
  if (!written) return;
  std::optional<LatLon> origin;
  if (frame_.in_degrees()) {
    const Frame& frame = store.frame();
    // UPDATE FROM passes what the column shows: the stored bits are kept.
    if (!before_.empty() && foresee::has_plan(at_, before_.data()) &&
        plans_.shown(store.read_plan(*updated, before_), frame) == *written)
      return keep_plan();
    const std::array<double, 3>& first = written->knots.front().x;
    origin = frame.origin ? *frame.origin : origin_near({first[1], first[0]});
    if (frame.chooses_origin()) new_origin_ = origin;
  }
  new_plan_ = plans_.stored(std::move(*written), origin);
  leg_.resize(leg_doubles(layout_));
  const bool has_knots = new_plan_->kind == PlanKind::knots;
  write_leg(at_, layout_.axes, has_knots ? legs_of(*new_plan_).front() : new_plan_->legs.front(),
            leg_.data());
} catch (const StoreError&) {
  throw;
} catch (const Error& error) {
  throw Refusal(SQLITE_CONSTRAINT, table_ + ".plan of row " + std::to_string(id) + ": " + error.what());
}

bool RowReader::is_of_before(int place, double number) const {
  const auto at = static_cast<std::size_t>(place);
  return (!before_.empty() && before_[at] == number) || (!at_start_.empty() && at_start_[at] == number);
}

double RowReader::number_of_leg(const Column& column, std::int64_t id, sqlite3_value* value) const {
  const auto place = static_cast<std::size_t>(column.place);
  const bool is_unchanged = !before_.empty() && sqlite3_value_nochange(value);
  if (leg_.empty()) return is_unchanged ? before_[place] : number_to_store(column, id, value);
  if (is_unchanged || is_null_or_empty(value)) return leg_[place];
  const double number = number_to_store(column, id, value);
  if (number != leg_[place] && !is_of_before(column.place, number))
    refuse_beside_plan(column, id, value, leg_[place]);
  return leg_[place];
}

void RowReader::check_degrees_of_leg(std::int64_t id, sqlite3_value** motion, TableWriter& store) const {
  const FloatEnvironment environment;
  std::optional<Flight> shows, showed;
  for (const std::size_t i : degrees_) {
    const Column& column = columns_[i];
    if (is_null_or_empty(motion[i])) continue;  // also what an UPDATE leaves alone
    const std::optional<double> number = degrees_number(column, id, motion[i]);
    if (!number) continue;
    if (!shows) {
      Frame frame = store.frame();
      if (new_origin_) frame.origin = new_origin_;
      shows = frame.shown(metres_of(frame, at_, leg_.data()));
      const double* const before = !at_start_.empty() ? at_start_.data() : before_.data();
      if (!before_.empty()) showed = shown_report(store, id, before);
    }
    const std::optional<double> of_plan = shown_number(column.geo, *shows);
    if (showed && shown_number(column.geo, *showed) == number) continue;
    if (!of_plan || !is_near(column.geo, *number, *of_plan))
      refuse_beside_plan(column, id, motion[i], of_plan);
  }
}

void RowReader::refuse_beside_plan(const Column& column, std::int64_t id, sqlite3_value* value,
                                   const std::optional<double>& of_plan) const {
  refuse(column.name, id, shown(value),
         "its plan starts " +
             (of_plan ? "with " + std::string(column.name) + " = " + foresee::shown(*of_plan)
                      : std::string("at rest")) +
             "; leave " + column.name + " out, or set plan to NULL");
}

/// A heading that follows the course is not built yet: NULL stays free for it.
void RowReader::require_heading_beside_plan(std::int64_t id, sqlite3_value** motion) const {
  if (!layout_.has_heading || record_[static_cast<std::size_t>(at_.outline)] == 0) return;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i].quantity == Quantity::heading && is_null_or_empty(motion[i]))
      refuse("heading", id, "NULL", "a row with a plan and a shape needs a heading; write 0 for no rotation");
}

}  // namespace foresee
