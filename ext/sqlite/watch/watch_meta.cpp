// WatchRows: reads and writes the `_meta` table of a watch as WatchState.
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "base/float_environment.h"
#include "base/number_text.h"
#include "database/sqlite_api.h"
#include "database/value_text.h"
#include "sqlite/watch/watch_rows.h"

namespace foresee {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct MetaValue {
  int type = SQLITE_NULL;
  std::string text = {};
  std::int64_t integer = 0;
  double number = 0;
};

/// The rows of _meta. Each value has one type and a range; any other value is damage and never replaced by a
/// default.
class MetaValues {
 public:
  MetaValues(Statement& rows, const std::string& watch) : watch_(watch) {
    for (Statement::Run run(rows); run.step();) {
      MetaValue& value = values_[run.text(0, 100)];
      value.type = sqlite3_value_type(run.value(1));
      if (value.type == SQLITE_TEXT) value.text = run.text(1, 1000);
      if (value.type == SQLITE_INTEGER) value.integer = run.integer(1);
      value.number = sqlite3_value_double(run.value(1));
    }
  }

  bool has(const char* key) const { return values_.contains(key); }

  /// The first words of a text in brackets; "" for another value.
  std::string reason(const char* key) const {
    constexpr std::size_t limit = 50;
    const MetaValue& value = found(key);
    if (value.type != SQLITE_TEXT || value.text.empty()) return "";
    return " (" + without_nul(std::string(cut_off(value.text, limit))) + ")";
  }
  std::optional<std::string> text(const char* key) const {
    const MetaValue& value = declared(key);
    if (value.type == SQLITE_NULL) return std::nullopt;
    if (value.type != SQLITE_TEXT || value.text.empty()) refuse(key);
    return value.text;
  }
  /// Nothing if it is missing or NULL: the value was never written.
  std::optional<double> number(const char* key, double min,
                               double max = std::numeric_limits<double>::max()) const {
    const MetaValue& value = found(key);
    if (value.type == SQLITE_NULL) return std::nullopt;
    const bool is_number = value.type == SQLITE_INTEGER || value.type == SQLITE_FLOAT;
    if (!is_number || !(value.number >= min && value.number <= max)) refuse(key);
    return value.number;
  }
  std::optional<std::int64_t> whole(const char* key, std::int64_t min, std::int64_t max = max_integer) const {
    const MetaValue& value = found(key);
    if (value.type == SQLITE_NULL) return std::nullopt;
    if (value.type != SQLITE_INTEGER || value.integer < min || value.integer > max) refuse(key);
    return value.integer;
  }
  std::optional<double> declared_number(const char* key) const {
    declared(key);
    return number(key, 0);
  }
  double required_number(const char* key) const {
    if (const auto found = number(key, 0)) return *found;
    refuse(key);
  }
  std::int64_t required_whole(const char* key, std::int64_t min, std::int64_t max = max_integer) const {
    if (const auto found = whole(key, min, max)) return *found;
    refuse(key);
  }

  [[noreturn]] void refuse(const char* key) const {
    throw StoreError(SQLITE_CORRUPT_VTAB, watch_ + ": " + watch_ + "_meta is damaged: " + key + " is " +
                                              shown(key) + "; DROP TABLE " + watch_ + " and CREATE it again");
  }

 private:
  static constexpr std::int64_t max_integer = std::numeric_limits<std::int64_t>::max();

  const MetaValue& found(const char* key) const {
    static const MetaValue null;
    const auto at = values_.find(key);
    return at == values_.end() ? null : at->second;
  }
  /// Throws if the key is missing.
  const MetaValue& declared(const char* key) const {
    if (!has(key)) refuse(key);
    return found(key);
  }
  std::string shown(const char* key) const {
    if (!has(key)) return "missing";
    const MetaValue& value = found(key);
    if (value.type == SQLITE_INTEGER) return std::to_string(value.integer);
    if (value.type == SQLITE_FLOAT) return foresee::shown(value.number);
    if (value.type == SQLITE_TEXT) return std::string("'").append(without_nul(value.text)).append("'");
    return value.type == SQLITE_BLOB ? "a blob" : "NULL";
  }

  std::string watch_;
  std::map<std::string, MetaValue, std::less<>> values_;
};

// Format 2 has rows that are not due, which readers of format 1 would never examine. Those readers do not
// check `format`, but report a file without "early" as damaged: so format 2 has it under another name. Format 3 has
// waiting pairs that are due before they start, and a new watch has `key_tables` (pair_keys.h).
constexpr std::int64_t newest_format = 3;

/// No watch counts as far; from a damaged file a larger count would overflow.
constexpr std::int64_t max_count = std::int64_t{1} << 53;

const char* early_key(std::int64_t format) {
  return format == 1 ? "early" : "early_reports";
}

void read_declaration(const MetaValues& values, WatchDeclaration& declared) {
  if (const auto tbl = values.text("tbl")) declared.tbl = *tbl;
  if (declared.tbl.empty()) values.refuse("tbl");
  declared.other = values.text("other");
  declared.horizon = values.required_number("horizon");
  declared.within = values.required_number("within");
  declared.within_z = values.declared_number("within_z");
  const auto clock = values.text("clock");
  if (clock != "manual" && clock != "newest") values.refuse("clock");
  declared.manual = clock == "manual";
  declared.tolerance = values.required_number("tolerance");
  declared.keep = values.required_whole("keep", 1);
  declared.ahead = values.declared_number("ahead");
  if (declared.ahead && declared.manual) values.refuse("ahead");
}

/// Checks `now` against `known_to`: a search sets it to the largest double below clock + (horizon + look_ahead_length).
/// Since then the clock has advanced, at most until clock + horizon reaches it. Rounding is monotone, so the
/// check is exact.
template <class HasPairs>
void require_clock_in_range(const MetaValues& values, const WatchState& state, HasPairs has_pairs) {
  const bool was_updated = values.has("known_to");
  if (state.clock) {
    const FloatEnvironment environment;
    const double reach = state.horizon + state.look_ahead_length,
                 end = std::nextafter(state.known_to, infinity);
    const double known_end = *state.clock + (std::isfinite(reach) ? reach : state.horizon);
    if (!was_updated) values.refuse("known_to");
    if (!(state.look_ahead_length > 0)) values.refuse("further");
    if (!(*state.clock + state.horizon <= end && end <= known_end)) values.refuse("now");
  } else if (was_updated && (state.manual || state.seq > 0 || state.last_advance > 0 || has_pairs())) {
    values.refuse("now");
  }
}

}  // namespace

WatchState WatchRows::read_state() {
  const MetaValues values(meta_, name_.table);
  if (values.has("damaged"))
    throw StoreError(SQLITE_CORRUPT_VTAB, name_.table + ": a commit could not write all of its changes" +
                                              values.reason("damaged") + ": DROP TABLE " + name_.table +
                                              " and CREATE it again");
  WatchState state;
  state.format = values.required_whole("format", 1);
  if (state.format > newest_format)
    throw StoreError(SQLITE_ERROR, name_.table + ": stored in format " + std::to_string(state.format) +
                                       "; this version of foresee reads formats up to " +
                                       std::to_string(newest_format) +
                                       ": open it with the version that wrote it");
  read_declaration(values, state);
  constexpr double lowest = std::numeric_limits<double>::lowest();
  state.clock = values.number("now", lowest);
  state.requested_clock = values.number("asked", lowest);
  state.must_rebuild = values.whole("anew", 0, 1).value_or(0) != 0;
  state.known_to = values.number("known_to", -infinity).value_or(-infinity);
  state.last_advance = values.number("step", 0, infinity).value_or(0);
  state.look_ahead_length = values.number("further", 0, infinity).value_or(0);
  state.found_waiting = values.whole("waited", 0, max_count).value_or(0);
  state.dropped_waiting = values.whole("dropped", 0, max_count).value_or(0);
  state.seq = values.required_whole("seq", 0, max_count);
  state.early_reports = values.required_whole(early_key(state.format), 0, max_count);
  constexpr auto min_integer = std::numeric_limits<std::int64_t>::min();
  state.stamp = values.whole("stamp", min_integer);
  state.other_stamp = values.whole("other_stamp", min_integer);
  state.early_score = values.whole("early_score", 0, max_count).value_or(0);
  state.created = values.whole("created", min_integer);
  use_pairs(values.whole("key_tables", 0, 1).value_or(0) != 0);
  keys_.forget();
  require_clock_in_range(values, state, [&] { return has_pairs(); });
  return state;
}

template <class Value>
void WatchRows::write_meta(std::string_view key, const std::optional<Value>& value) {
  Statement::Run run(write_meta_);
  run.bind(1, key);
  if (value) run.bind(2, *value);
  run.step();
}

template <class Value>
void WatchRows::write_changed(std::string_view key, const Value& value, const Value& before) {
  if (value == before) return;
  if constexpr (requires { value.has_value(); })
    write_meta(key, value);
  else
    write_meta(key, std::optional(value));
}

void WatchRows::write_tables(const WatchDeclaration& declaration) {
  write_meta("tbl", std::optional<std::string_view>(declaration.tbl));
  write_meta("other", std::optional<std::string_view>(declaration.other));
}

void WatchRows::write_declaration(const WatchDeclaration& declaration) {
  write_tables(declaration);
  write_meta("format", std::optional(newest_format));
  write_meta("horizon", std::optional(declaration.horizon));
  write_meta("within", std::optional(declaration.within));
  write_meta("within_z", declaration.within_z);
  write_meta("clock", std::optional<std::string_view>(declaration.manual ? "manual" : "newest"));
  write_meta("tolerance", std::optional(declaration.tolerance));
  write_meta("keep", std::optional(declaration.keep));
  write_meta("ahead", declaration.ahead);
  write_meta("seq", std::optional(std::int64_t{0}));
  write_meta(early_key(newest_format), std::optional(std::int64_t{0}));
  write_meta("key_tables", std::optional(std::int64_t{1}));
  std::int64_t created;
  sqlite3_randomness(sizeof created, &created);
  write_meta("created", std::optional(created));
}

void WatchRows::write_state(const WatchState& state, const WatchState& before) {
  write_changed("now", state.clock, before.clock);
  write_changed("asked", state.requested_clock, before.requested_clock);
  if (state.must_rebuild != before.must_rebuild) write_must_rebuild(state.must_rebuild);
  write_changed("known_to", state.known_to, before.known_to);
  write_changed("step", state.last_advance, before.last_advance);
  write_changed("further", state.look_ahead_length, before.look_ahead_length);
  write_changed("early_score", state.early_score, before.early_score);
  write_changed("waited", state.found_waiting, before.found_waiting);
  write_changed("dropped", state.dropped_waiting, before.dropped_waiting);
  write_changed("seq", state.seq, before.seq);
  if (before.format == newest_format) {
    write_changed(early_key(newest_format), state.early_reports, before.early_reports);
  } else {
    write_meta("format", std::optional(newest_format));
    write_meta(early_key(newest_format), std::optional(state.early_reports));
    if (before.format == 1) write_meta(early_key(1), std::optional<std::int64_t>());
  }
  write_changed("stamp", state.stamp, before.stamp);
  write_changed("other_stamp", state.other_stamp, before.other_stamp);
}

void WatchRows::write_requested_clock(std::optional<double> time) {
  write_meta("asked", time);
}

void WatchRows::write_must_rebuild(bool must_rebuild) {
  write_meta("anew", std::optional(std::int64_t{must_rebuild}));
}

void WatchRows::write_damaged(std::string_view reason) {
  write_meta("damaged", std::optional(reason));
}

}  // namespace foresee
