#include "query/input_checks.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/number_text.h"
#include "shape/kinds.h"

namespace foresee {
namespace {

constexpr std::size_t max_rows = std::numeric_limits<std::uint32_t>::max();  // pairs hold numbers of rows

[[noreturn]] void reject(const char* name, const char* kind, double value) {
  throw Error(std::string(name) + " must be " + kind + ", not " + shown(value));
}

std::string axes_in_words(const SearchTarget& objects) {
  const char* axes[] = {"1 axis (x)", "2 axes (x, y)", "3 axes (x, y, z)"};
  return objects.name + " has " + axes[objects.layout().axes - 1];
}

}  // namespace

// --- scenes

void require_set(bool is_set, const char* what, const char* member) {
  if (!is_set) throw Error(std::string(what) + "; set " + member);
}

void require_layout(const std::string& name, const Layout& layout) {
  const auto reject = [&](const std::string& what) { throw Error(name + ": " + what); };
  if (layout.axes < 1 || layout.axes > 3)
    reject("a layout has 1, 2 or 3 axes, not " + std::to_string(layout.axes));
  const int needed = layout.shape == Shape::cylinder || layout.shape == Shape::mesh ? 3
                     : layout.shape == Shape::outline                               ? 2
                                                                                    : 1;
  if (layout.axes < needed)
    reject("the shape of the layout needs " + std::to_string(needed) + " axes, not " +
           std::to_string(layout.axes));
  const bool may_have_plan = layout.has_t && layout.has_until && !grows(layout) &&
                             (layout.law == Law::uniform || layout.law == Law::accelerated);
  if (layout.has_plan && !may_have_plan)
    reject("a layout with plans needs has_t, has_until and Law::uniform or Law::accelerated, and no growth");
}

void require_whole(const Scene& scene) {
  require_layout(scene.name, scene.layout);
  const std::size_t row_size = static_cast<std::size_t>(row_offsets(scene.layout).size);
  if (scene.ids.size() > max_rows)
    throw Error(scene.name + ": " + std::to_string(scene.ids.size()) + " rows; a scene has at most " +
                std::to_string(max_rows));
  const std::size_t needed = scene.ids.size() * row_size;
  if (scene.rows.size() != needed)
    throw Error(scene.name + ": " + std::to_string(scene.ids.size()) + " ids need " + std::to_string(needed) +
                " numbers in rows, not " + std::to_string(scene.rows.size()) + "; a row has " +
                std::to_string(row_size));
  const auto is_whole = [&](const std::vector<std::uint32_t>& starts) {
    return starts.empty() ? scene.ids.empty() : starts.back() == scene.ids.size();
  };
  if (scene.layout.has_plan && !is_whole(scene.first_rows))
    throw Error(scene.name + ": first_rows does not fit the ids; call find_movers() after the last row");
  if (scene.levels && !(scene.levels->starts.empty() ? scene.ids.empty() : is_whole(scene.levels->starts[0])))
    throw Error(scene.name + ": levels do not fit the ids; a scene that is changed has none");
}

void require_forms(const Scene& scene) {
  if (is_stored_apart(scene.layout.shape) && !scene.forms && !scene.ids.empty())
    throw Error(scene.name + ": the scene has no outlines or meshes; call take_forms()");
}

std::shared_ptr<const Scene> whole(std::shared_ptr<const Scene> scene, const char* what, const char* member) {
  require_set(scene != nullptr, what, member);
  require_whole(*scene);
  return scene;
}

void require_target(const SearchTarget& objects, const char* what, const char* member) {
  require_set(objects.scene || objects.tree, what, member);
  if (objects.scene) return require_whole(*objects.scene);
  require_layout(objects.name, objects.tree->layout());
  if (objects.tree->layout().has_plan && !objects.chunks)
    throw Error(objects.name + ": the tree has plans; set SearchTarget::chunks");
}

// --- numbers of a record or a row

std::vector<NumberColumn> number_columns(const Layout& layout, const Offsets& at) {
  std::vector<NumberColumn> columns;
  const auto number = [&](const char* name, int place, NumberRule rule) {
    if (place != Offsets::absent) columns.push_back({name, place, rule});
  };
  const auto vector = [&](const std::array<const char*, 3>& names, int place, NumberRule rule) {
    for (int axis = 0; axis < layout.axes && place != Offsets::absent; ++axis)
      number(names[static_cast<std::size_t>(axis)], place + axis, rule);
  };
  number("t", at.t, NumberRule::finite);
  vector({"x", "y", "z"}, at.x, NumberRule::finite);
  vector({"vx", "vy", "vz"}, at.v, NumberRule::finite);
  vector({"ax", "ay", "az"}, at.a, NumberRule::finite);
  vector({"fx", "fy", "fz"}, at.force, NumberRule::finite);
  number("m", at.mass, NumberRule::positive);
  vector({"hx", "hy", "hz"}, at.half, NumberRule::size);
  number("r", at.r, NumberRule::size);
  number("hz", at.hz, NumberRule::size);
  number("growth", at.growth, NumberRule::size);
  number("growth_z", at.growth_z, NumberRule::size);
  number("heading", at.heading, NumberRule::finite);
  for (int i = 0; i < 2 * bounded_axes(layout.shape); ++i)
    number("a bound of its shape", at.bounds + i, NumberRule::finite);
  number("until", at.until, NumberRule::end);
  number("category", at.category, NumberRule::kind);
  number("mask", at.mask, NumberRule::kind);
  return columns;
}

namespace {

bool keeps(NumberRule rule, double number) {
  switch (rule) {
    case NumberRule::finite:
      return std::isfinite(number);
    case NumberRule::positive:
      return std::isfinite(number) && number > 0;
    case NumberRule::size:
      return std::isfinite(number) && number >= 0;
    case NumberRule::end:
      return number > -HUGE_VAL;
    case NumberRule::kind:
      return number >= 0 && number <= every_kind && number == std::floor(number);
  }
  return false;
}

const char* in_words(NumberRule rule) {
  const char* words[] = {"a finite number", "a finite number > 0", "a finite number >= 0",
                         "a time, or +infinity", "a whole number from 0 to 4294967295"};
  return words[static_cast<std::size_t>(rule)];
}

}  // namespace

void require_numbers(const std::string& name, std::int64_t id, std::span<const NumberColumn> columns,
                     const Offsets& at, const double* numbers) {
  const auto reject = [&](const std::string& what) {
    throw Error(name + ": row " + std::to_string(id) + ": " + what);
  };
  for (const NumberColumn& column : columns)
    if (const double number = numbers[column.place]; !keeps(column.rule, number))
      reject(std::string(column.name) + " is " + shown(number) + "; write " + in_words(column.rule));
  if (const double t = value_or(numbers, at.t, 0); at.until != Offsets::absent && numbers[at.until] < t)
    reject("until is " + shown(numbers[at.until]) + ", before t, which is " + shown(t) +
           "; write a later time");
  for (int place = at.force; place < at.mass; ++place)
    if (!std::isfinite(numbers[place] / numbers[at.mass]))
      reject("the acceleration is infinite: a force is " + shown(numbers[place]) + ", m is " +
             shown(numbers[at.mass]) + "; write a larger m");
}

void check_numbers(const Scene& scene) {
  require_whole(scene);
  const Offsets at = row_offsets(scene.layout);
  const std::vector<NumberColumn> columns = number_columns(scene.layout, at);
  const double* row = scene.rows.data();
  for (const std::int64_t id : scene.ids) {
    require_numbers(scene.name, id, columns, at, row);
    row += at.size;
  }
}

// --- inputs

void require_not_negative(const char* name, double value) {
  if (!(std::isfinite(value) && value >= 0)) reject(name, "a finite number >= 0", value);
}

void require_positive(const char* name, double value) {
  if (!(std::isfinite(value) && value > 0)) reject(name, "a finite number > 0", value);
}

void require_finite(const char* name, double value) {
  if (!std::isfinite(value)) reject(name, "a finite number", value);
}

void require_lower_bound(const char* name, double value) {
  if (!(value < HUGE_VAL)) reject(name, "a finite number, or left out for no bound", value);
}

void require_upper_bound(const char* name, double value) {
  if (!(value > -HUGE_VAL)) reject(name, "a finite number, or left out for no bound", value);
}

void require_order(const char* lower_name, double lower, const char* upper_name, double upper) {
  if (lower <= upper) return;
  throw Error(std::string(lower_name) + " must not be greater than " + upper_name + ": " + lower_name +
              " is " + shown(lower) + ", " + upper_name + " is " + shown(upper));
}

bool wants_all_contacts(std::string_view text) {
  if (text == "all") return true;
  if (text == "first") return false;
  throw Error("contacts must be 'first' or 'all', not '" + std::string(text) + "'");
}

void refuse_all_contacts_of_forms(const Layout& layout) {
  if (is_stored_apart(layout.shape))
    throw Error("contacts = 'all' is not for outlines and meshes: leave it out");
}

void reject_axis(const SearchTarget& objects, const std::string& given) {
  throw Error(axes_in_words(objects) + ": leave out " + given);
}

void reject_missing(const SearchTarget& objects, const std::string& coordinate) {
  throw Error(axes_in_words(objects) + ": " + coordinate + " is missing; give one number for each axis");
}

}  // namespace foresee
