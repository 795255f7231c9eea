#include "sqlite/watch/declare_watch.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

#include "base/error.h"
#include "database/statement.h"
#include "sqlite/names/open_table.h"
#include "sqlite/names/visible_tables.h"
#include "sqlite/sql_tokens.h"
#include "sqlite/table/table_arguments.h"

namespace foresee {
namespace {

constexpr std::array<const char*, 11> columns{"a",     "b",      "t",     "t_end", "dt",  "dt_end",
                                              "t_cpa", "dt_cpa", "d_cpa", "now",   "pair"};

[[noreturn]] void refuse(const Argument& argument, const std::string& why) {
  throw Error("\"" + argument.text + "\": " + why);
}

/// The finite number >= 0 that the text holds; nothing if it holds none.
std::optional<double> read_number(const std::string& text) {
  const char* end = text.data() + text.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (stop != end || error != std::errc() || !(number >= 0) || !std::isfinite(number)) return std::nullopt;
  return number;
}

double number(const Argument& argument, const char* such_as) {
  const auto found = read_number(argument.detail);
  if (!found)
    refuse(argument, argument.name + " must be a finite number >= 0; write for example " + argument.name +
                         " = " + such_as);
  return *found;
}

std::int64_t whole_number(const Argument& argument) {
  const double found = read_number(argument.detail).value_or(0);
  if (found < 1 || found != std::floor(found) || found > 0x1p53)
    refuse(argument, argument.name + " must be a whole number >= 1; write for example keep = 1000000");
  return static_cast<std::int64_t>(found);
}

bool is_manual(const Argument& argument) {
  if (same_name(argument.detail, "manual")) return true;
  if (!same_name(argument.detail, "newest"))
    refuse(argument, "clock must be newest or manual; write clock = newest");
  return false;
}

struct Option {
  const char* name;
  std::function<void(WatchDeclaration&, const Argument&)> apply;
};

const std::array<Option, 8>& options() {
  static const std::array<Option, 8> all{{
      {"horizon", [](WatchDeclaration& d, const Argument& a) { d.horizon = number(a, "600"); }},
      {"within", [](WatchDeclaration& d, const Argument& a) { d.within = number(a, "926"); }},
      {"within_z", [](WatchDeclaration& d, const Argument& a) { d.within_z = number(a, "300"); }},
      {"other", [](WatchDeclaration& d, const Argument& a) { d.other = a.detail; }},
      {"clock", [](WatchDeclaration& d, const Argument& a) { d.manual = is_manual(a); }},
      {"tolerance", [](WatchDeclaration& d, const Argument& a) { d.tolerance = number(a, "1"); }},
      {"keep", [](WatchDeclaration& d, const Argument& a) { d.keep = whole_number(a); }},
      {"ahead", [](WatchDeclaration& d, const Argument& a) { d.ahead = number(a, "3600"); }},
  }};
  return all;
}

std::string known_options() {
  std::string names;
  for (const Option& option : options()) names += (names.empty() ? "" : ", ") + std::string(option.name);
  return names;
}

const Option* find_option(const std::string& name) {
  const auto found = std::find_if(options().begin(), options().end(),
                                  [&](const Option& option) { return same_name(option.name, name); });
  return found == options().end() ? nullptr : &*found;
}

/// Throws Error for an argument of the wrong form. `first`: the argument is the first one.
[[noreturn]] void refuse_form(std::string_view text, bool first) {
  const Argument given{.text = std::string(text), .kind = {}, .name = {}, .detail = {}};
  if (first)
    refuse(
        given,
        "the first argument is the name of the table to watch; write predictive_watch(ships, horizon = 600)");
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && stop == text.data() + text.size() && value >= 0;
  refuse(given,
         "an option needs a name; write " +
             (is_number ? "horizon = " + given.text : std::string("name = value, as in horizon = 600")) +
             "; known: " + known_options());
}

Argument parse_argument_of_watch(std::string_view text, bool first) try {
  return parse_argument(text);
} catch (const Error&) {  // its message is about columns
  refuse_form(text, first);
}

/// Throws Error for a later argument that is not `name = value`.
[[noreturn]] void refuse_second_table(const Argument& argument) {
  if (find_option(argument.name))
    refuse(argument, "an option is written name = value; write " + argument.name + " = " +
                         (argument.detail.empty() ? "600" : argument.detail));
  refuse(argument, "only the first argument is a table; a second one is written other = " + argument.name);
}

void apply_option(WatchDeclaration& declaration, std::set<std::string>& given, const Argument& argument) {
  const Option* option = find_option(argument.name);
  if (!option) refuse(argument, "no such option; known: " + known_options() + ", as in horizon = 600");
  if (!given.insert(option->name).second)
    refuse(argument, std::string(option->name) + " is given twice; leave one out");
  option->apply(declaration, argument);
}

/// A watch has no input `schema`: its tables are in its own schema, whose tables are `here`. No other schema is
/// read: while a table is being created that may free it (visible_tables.h).
void require_table(Connection& connection, const QualifiedName& watch, const std::vector<VisibleTable>& here,
                   const std::string& name) {
  std::string list;
  const VisibleTable* found = nullptr;
  for (const VisibleTable& table : here) {
    if (same_name(table.name, name)) found = &table;
    if (table.holds_moving_objects) list += (list.empty() ? "" : ", ") + quoted(table.name);
  }
  if (found && found->holds_moving_objects) return;
  if (!list.empty()) list = " (moving_objects tables here: " + list + ")";
  if (found)
    throw Error(quoted(name) + " is " + (found->is_watch ? "a watch" : "not a moving_objects table") +
                "; name the table whose objects move" + list);
  std::string elsewhere = connection.other_schema(name, watch.schema);
  if (elsewhere.empty() && !same_name(watch.schema, "main")) elsewhere = "main";  // probably
  throw Error("no such table: " + quoted(name) + " in schema " + quoted(watch.schema) +
              (elsewhere.empty() ? list
                                 : "; a watch is in the schema of its table: write CREATE VIRTUAL TABLE " +
                                       elsewhere + "." + watch.table));
}

}  // namespace

WatchDeclaration parse_watch(std::string_view watch, const std::vector<std::string_view>& arguments) try {
  for (const char* column : columns)
    if (same_name(column, watch))
      throw Error("a watch cannot be named like one of its columns; choose another name");
  WatchDeclaration declaration;
  std::set<std::string> given;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Argument argument = parse_argument_of_watch(arguments[i], i == 0);
    if (i == 0) {
      if (argument.kind != Argument::Kind::column || !argument.detail.empty())
        refuse_form(argument.text, true);
      declaration.tbl = argument.name;
    } else if (argument.kind != Argument::Kind::option) {
      refuse_second_table(argument);
    } else {
      apply_option(declaration, given, argument);
    }
  }
  if (declaration.tbl.empty())
    throw Error("no table is named; write for example predictive_watch(ships, horizon = 600)");
  if (!given.contains("horizon"))
    throw Error("horizon is missing: write predictive_watch(" + declaration.tbl + ", horizon = 600)");
  if (declaration.ahead && declaration.manual) throw Error("ahead is for clock = newest; leave it out");
  return declaration;
} catch (const Error& error) {
  throw Error(std::string(watch) + ": " + error.what());
}

void require_tables(Connection& connection, const QualifiedName& watch, const WatchDeclaration& declaration) {
  const std::vector<VisibleTable> here = visible_tables(connection.db(), watch.schema);
  require_table(connection, watch, here, declaration.tbl);
  if (declaration.other) require_table(connection, watch, here, *declaration.other);
}

std::string declared_watch(std::string_view watch) {
  return "CREATE TABLE x(a INTEGER, b INTEGER, t REAL, t_end REAL, dt REAL, dt_end REAL, t_cpa REAL, "
         "dt_cpa REAL, d_cpa REAL, now REAL HIDDEN, " +
         quoted_name(std::string(watch)) + " HIDDEN, pair BLOB HIDDEN NOT NULL PRIMARY KEY) WITHOUT ROWID";
}

}  // namespace foresee
