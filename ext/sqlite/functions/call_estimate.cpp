#include "sqlite/functions/call_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "database/value_text.h"
#include "sqlite/functions/table_function.h"

namespace foresee {
namespace {

// Costs in the planner's unit.
constexpr double decoded_object = 6;  // read, decoded, returned
constexpr double looked_up_object = 80;
constexpr double joined_object = 12, joined_row = 2;
constexpr double search = 500, found_object = 50, nearest_object = 300;
constexpr double search_of_one = 600;  // above `search`: even in a tiny table the whole search comes first
constexpr double probe = 100, probed_level = 50;  // of one object, per binary logarithm of all objects

constexpr double instants = 60, moved_object = 2;                        // per track
constexpr double window_rows = 100, nearest_rows = 10, avoid_rows = 10;  // assumed numbers of rows

/// A function's inputs as far as the text of the statement determines them.
class WrittenInputs {
 public:
  WrittenInputs(const TableFunction& function, std::span<sqlite3_value* const> written, std::uint32_t given)
      : function_(function), written_(written), given_(given) {}

  sqlite3_value* value(const char* name) const {
    const std::size_t place = place_of(name);
    return place < written_.size() ? written_[place] : nullptr;
  }
  bool is_bound_later(const char* name) const {
    const std::size_t place = place_of(name);
    return place < written_.size() && (given_ >> place & 1) && !written_[place];
  }
  /// The input's text literal; nothing if it is left out or bound later.
  std::optional<std::string> text(const char* name) const {
    sqlite3_value* written = value(name);
    if (!written || sqlite3_value_type(written) != SQLITE_TEXT) return std::nullopt;
    return text_of(written);
  }

 private:
  std::size_t place_of(const char* name) const {
    const auto& inputs = function_.inputs;
    return static_cast<std::size_t>(
        std::find_if(inputs.begin(), inputs.end(),
                     [&](const char* input) { return std::strcmp(input, name) == 0; }) -
        inputs.begin());
  }

  const TableFunction& function_;
  std::span<sqlite3_value* const> written_;
  std::uint32_t given_;
};

/// The binary logarithm of x > 0, linear between powers of two. A plan must not depend on a C library's log2.
double about_log2(double x) {
  int exponent;
  const double mantissa = std::frexp(x, &exponent);
  return exponent - 2 + 2 * mantissa;
}

}  // namespace

CallEstimate estimate_positions(const CallSizes& sizes) {
  return {decoded_object * sizes.objects, sizes.objects};
}

CallEstimate estimate_object(const CallSizes&, bool /*of its one id*/) {
  return {looked_up_object, 1};
}

CallEstimate estimate_tracks(const CallSizes& sizes) {
  return {(decoded_object + instants * moved_object) * sizes.objects, instants * sizes.objects};
}

CallEstimate estimate_track(const CallSizes&, bool /*of its one id*/) {
  return {looked_up_object + instants * moved_object, instants};
}

CallEstimate estimate_window(const CallSizes& sizes) {
  const double rows = std::min(window_rows, sizes.objects);
  return {search + found_object * rows, rows};
}

CallEstimate estimate_window_of_one(const CallSizes&, bool /*of its one id*/) {
  return {search_of_one, 1};
}

CallEstimate estimate_nearest(const CallSizes& sizes) {
  const double rows = std::clamp(sizes.k.value_or(nearest_rows), 0.0, sizes.objects);
  return {search + nearest_object * rows, rows};
}

CallEstimate estimate_avoid(const CallSizes& sizes) {
  const CallEstimate one = estimate_pairs_of_one(sizes, true);
  return {4 * one.cost, avoid_rows};
}

CallEstimate estimate_join(const CallSizes& sizes) {
  const double others = sizes.others.value_or(0), rows = std::max(sizes.objects, others);
  return {joined_object * (sizes.objects + others) + joined_row * rows, rows};
}

CallEstimate estimate_pairs_of_one(const CallSizes& sizes, bool by_a) {
  const CallEstimate whole = estimate_join(sizes);
  const double others = sizes.others.value_or(sizes.objects), one_side = by_a ? sizes.objects : others,
               searched = by_a ? others : sizes.objects;
  return {probe + probed_level * about_log2(1 + searched), whole.rows / std::max(1.0, one_side)};
}

CallEstimate estimate_stages(const CallSizes& sizes) {
  return {estimate_join(sizes).cost, 10};
}

CallSizes call_sizes(const TableFunction& function, const Connection& connection,
                     std::span<sqlite3_value* const> written, std::uint32_t given) {
  const WrittenInputs inputs(function, written, given);
  const TableName tbl{inputs.text("tbl"), inputs.text("schema")};
  CallSizes sizes{.objects = connection.likely_objects(tbl)};
  const TableName other{inputs.text("other"), tbl.schema};
  if (other.table || inputs.is_bound_later("other")) sizes.others = connection.likely_objects(other);
  if (sqlite3_value* k = inputs.value("k")) sizes.k = sqlite3_value_double(k);
  return sizes;
}

}  // namespace foresee
