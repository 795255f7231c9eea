// What a watch's _meta says, as WatchState; and back.
#include <cmath>
#include <limits>
#include <map>

#include "storage/rows/store_error.h"
#include "storage/watch/watch_rows.h"

namespace foresee::storage {
namespace {

/// What one row of _meta holds, as a number.
struct MetaValue {
  std::string text;
  std::optional<std::int64_t> integer;
  std::optional<double> number;
};

// 2 knows rows that are not due. Readers of 1 would never ask about those; they do not look at `format`, but
// hold a file without "early" for damaged: 2 has it under another name.
constexpr std::int64_t newest_format = 2;

const char* early_key(std::int64_t format) {
  return format == 1 ? "early" : "early_reports";
}

}  // namespace

WatchState WatchRows::read_state() {
  std::map<std::string, MetaValue> values;
  for (Statement::Run run(meta_); run.step();) {
    MetaValue value{.text = run.text(1, 1000), .integer = {}, .number = {}};
    if (run.is_integer(1)) value.integer = run.integer(1);
    const int type = sqlite3_value_type(run.value(1));
    if (type == SQLITE_INTEGER || type == SQLITE_FLOAT) value.number = sqlite3_value_double(run.value(1));
    values[run.text(0, 100)] = std::move(value);
  }
  const auto number = [&](const char* key) { return values[key].number; };
  const auto required = [&](const char* key, double least) {
    if (const auto found = number(key); found && *found >= least) return *found;
    damaged("meta");
  };
  const auto integer = [&](const char* key) {
    if (const auto found = values[key].integer; found && *found >= 0) return *found;
    damaged("meta");
  };
  if (values.contains("damaged"))
    throw StoreError(SQLITE_CORRUPT_VTAB, name_.table +
                                              ": a commit could not write all of its changes: DROP TABLE " +
                                              name_.table + " and CREATE it again");
  WatchState state;
  state.format = integer("format");
  if (state.format < 1 || state.format > newest_format)
    throw StoreError(SQLITE_ERROR, name_.table + ": stored in format " + std::to_string(state.format) +
                                       "; this version of foresee reads formats up to " +
                                       std::to_string(newest_format) +
                                       ": open it with the version that wrote it");
  state.tbl = values["tbl"].text;
  if (state.tbl.empty()) damaged("meta");
  if (!values["other"].text.empty()) state.other = values["other"].text;
  state.horizon = required("horizon", 0), state.within = required("within", 0);
  state.within_z = number("within_z");
  state.manual = values["clock"].text == "manual";
  state.tolerance = required("tolerance", 0), state.keep = integer("keep");
  state.ahead = number("ahead");
  state.clock = number("now"), state.asked = number("asked");
  state.anew = number("anew").value_or(0) != 0;
  state.known_to = number("known_to").value_or(-std::numeric_limits<double>::infinity());
  state.step = number("step").value_or(0);
  state.further = number("further").value_or(0);
  state.waited = values["waited"].integer.value_or(0), state.dropped = values["dropped"].integer.value_or(0);
  state.seq = integer("seq"), state.early = integer(early_key(state.format));
  state.stamp = values["stamp"].integer, state.other_stamp = values["other_stamp"].integer;
  for (const auto& moment : {state.clock, state.asked})
    if (moment && !std::isfinite(*moment)) damaged("meta");
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
}

void WatchRows::write_state(const WatchState& state, const WatchState& before) {
  write_changed("now", state.clock, before.clock);
  write_changed("asked", state.asked, before.asked);
  if (state.anew != before.anew) write_anew(state.anew);
  write_changed("known_to", state.known_to, before.known_to);
  write_changed("step", state.step, before.step);
  write_changed("further", state.further, before.further);
  write_changed("waited", state.waited, before.waited);
  write_changed("dropped", state.dropped, before.dropped);
  write_changed("seq", state.seq, before.seq);
  if (before.format == newest_format) {
    write_changed(early_key(newest_format), state.early, before.early);
  } else {
    write_meta("format", std::optional(newest_format));
    write_meta(early_key(newest_format), std::optional(state.early));
    write_meta(early_key(before.format), std::optional<std::int64_t>());
  }
  write_changed("stamp", state.stamp, before.stamp);
  write_changed("other_stamp", state.other_stamp, before.other_stamp);
}

void WatchRows::write_asked(std::optional<double> moment) {
  write_meta("asked", moment);
}

void WatchRows::write_anew(bool anew) {
  write_meta("anew", std::optional(std::int64_t{anew}));
}

void WatchRows::write_damaged() {
  write_meta("damaged", std::optional(std::int64_t{1}));
}

}  // namespace foresee::storage
