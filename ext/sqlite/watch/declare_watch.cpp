#include "sqlite/watch/declare_watch.h"

#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <set>

#include "base/error.h"
#include "sqlite/sql_tokens.h"
#include "sqlite/table/arguments.h"
#include "storage/rows/statement.h"

namespace foresee::sqlite {
namespace {

constexpr std::array<const char*, 11> columns{"a",     "b",      "t",     "t_end", "dt",  "dt_end",
                                              "t_cpa", "dt_cpa", "d_cpa", "now",   "pair"};

[[noreturn]] void refuse(const Argument& argument, const std::string& why) {
  throw Error("\"" + argument.text + "\": " + why);
}

double number(const Argument& argument, const char* such_as) {
  const char* end = argument.detail.data() + argument.detail.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(argument.detail.data(), end, number);
  if (stop != end || error != std::errc() || !(number >= 0) || !std::isfinite(number))
    refuse(argument, argument.name + " must be a finite number >= 0; write for example " + argument.name +
                         " = " + such_as);
  return number;
}

std::int64_t whole_number(const Argument& argument) {
  const double found = number(argument, "1000000");
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
  std::function<void(WatchDeclaration&, const Argument&)> take;
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

void take_option(WatchDeclaration& declaration, std::set<std::string>& given, const Argument& argument) {
  for (const Option& option : options()) {
    if (!same_name(option.name, argument.name)) continue;
    if (!given.insert(option.name).second)
      refuse(argument, std::string(option.name) + " is given twice; leave one out");
    return option.take(declaration, argument);
  }
  refuse(argument, "no such option; known are " + known_options() + ", as in horizon = 600");
}

}  // namespace

WatchDeclaration parse_watch(std::string_view watch, const std::vector<std::string_view>& arguments) try {
  for (const char* column : columns)
    if (same_name(column, watch))
      throw Error("a watch cannot be named like one of its columns; choose another name");
  WatchDeclaration declaration;
  std::set<std::string> given;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Argument argument = parse_argument(arguments[i]);
    if (i > 0 && argument.kind != Argument::Kind::option)
      refuse(argument,
             "only the first argument is a table; a second one is written other = " + argument.name);
    if (i > 0)
      take_option(declaration, given, argument);
    else if (argument.kind != Argument::Kind::column || !argument.detail.empty())
      refuse(argument,
             "the first argument is the table to watch, as in predictive_watch(ships, horizon = 600)");
    else
      declaration.tbl = argument.name;
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

std::string declared_watch(std::string_view watch) {
  return "CREATE TABLE x(a INTEGER, b INTEGER, t REAL, t_end REAL, dt REAL, dt_end REAL, t_cpa REAL, "
         "dt_cpa REAL, d_cpa REAL, now REAL HIDDEN, " +
         quoted_name(std::string(watch)) + " HIDDEN, pair BLOB HIDDEN NOT NULL PRIMARY KEY) WITHOUT ROWID";
}

}  // namespace foresee::sqlite
