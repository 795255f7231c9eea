#include "sqlite/table/table_declaration.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "database/statement.h"
#include "sqlite/sql_tokens.h"
#include "sqlite/table/column_vocabulary.h"
#include "sqlite/table/frame_options.h"
#include "sqlite/table/layout_rules.h"
#include "sqlite/table/table_arguments.h"

namespace foresee {
namespace {

[[noreturn]] void refuse(const Argument& argument, const std::string& why) {
  throw Error("\"" + argument.text + "\": " + why);
}

bool is_one_of(std::string_view type, std::initializer_list<std::string_view> types) {
  for (std::string_view known : types)
    if (same_name(known, type)) return true;
  return false;
}

void require_id(const Argument& argument) {
  if (argument.kind != Argument::Kind::column || !same_name(argument.name, "id"))
    refuse(argument,
           hint_for(argument.name) == hint_for("mmsi")
               ? "the first column is the key and must be called id; write id in place of " + argument.name
               : "the first column must be id; write moving_objects(id, ...)");
  if (!is_one_of(argument.detail, {"", "INT", "INTEGER", "BIGINT", "INT PRIMARY KEY", "INTEGER PRIMARY KEY"}))
    refuse(argument, "the id is an INTEGER PRIMARY KEY; write id");
}

/// `name` as an auxiliary column: +name, or +"my name" where the name needs quotes. A + within the quotes of the
/// argument was meant to be in front of them.
std::string as_auxiliary(std::string_view name) {
  if (name.starts_with('+')) name.remove_prefix(1);
  if (name.empty()) return "+name";
  SqlTokens tokens(name);
  const auto word = tokens.next();
  const bool is_plain = word && word->kind == SqlToken::Kind::word && word->text == name;
  std::string column("+");
  column += is_plain ? std::string(name) : quoted_name(std::string(name));
  return column;
}

const Word& motion_word(const Argument& argument) {
  if (const Word* word = find_word(argument.name)) return *word;
  const std::string why = "no such column; ";
  const std::string own = "a column of your own is written " + as_auxiliary(argument.name);
  const std::string_view hint = hint_for(argument.name), near = nearest_word(argument.name);
  if (!hint.empty()) refuse(argument, why + std::string(hint) + " " + own);
  if (!near.empty()) refuse(argument, why + "did you mean " + std::string(near) + "? " + own);
  refuse(argument, why + "known: " + known_words() + "; " + own);
}

void require_type_of_plan(const Argument& argument) {
  if (!is_one_of(argument.detail, {"", "TEXT", "BLOB"}))
    refuse(argument, argument.name + " holds text or blobs; write " + argument.name);
}

void require_text(const Argument& argument) {
  if (!is_one_of(argument.detail, {"", "TEXT"}))
    refuse(argument, argument.name + " holds well-known text; write " + argument.name + " or " +
                         argument.name + " TEXT");
}

double positive_number(const Argument& argument) {
  const char* end = argument.detail.data() + argument.detail.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(argument.detail.data(), end, number);
  if (stop != end || error != std::errc() || !(number > 0) || !std::isfinite(number))
    refuse(argument,
           argument.name + " must be a number greater than 0; write for example " + argument.name + " = 60");
  return number;
}

/// Collects the arguments one by one; the layout is derived at the end, from all of them.
class Declarer {
 public:
  void add(const Argument& argument) {
    switch (argument.kind) {
      case Argument::Kind::column:
        return add_motion(argument);
      case Argument::Kind::auxiliary:
        return add_auxiliary(argument);
      case Argument::Kind::option:
        return add_option(argument);
    }
  }

  Declaration finish() {
    declaration_.frame = frame_.frame(words_);
    declaration_.layout = layout_of(words_);
    if (declaration_.frame.on_globe()) use_axes_of_globe();
    const Offsets at = record_offsets(declaration_.layout);
    for (const DeclaredWord& declared : words_) declaration_.columns.push_back(column_of(declared.word, at));
    if (declaration_.frame.in_degrees()) require_no_hidden_names();
    return std::move(declaration_);
  }

 private:
  MotionColumn column_of(const Word& word, const Offsets& at) const {
    return {.name = std::string(word.name),
            .place = offset_of(at, word),
            .is_form = word.quantity == Quantity::form,
            .is_kind = is_kind(word.quantity),
            .geo = geo_column(word.name, declaration_.frame),
            .is_plan = word.quantity == Quantity::plan};
  }

  void add_motion(const Argument& argument) {
    if (same_name(argument.name, "id")) refuse(argument, "id is declared twice; leave this one out");
    const Word& word = motion_word(argument);
    if (word.quantity == Quantity::form)
      require_text(argument);
    else if (word.quantity == Quantity::plan)
      require_type_of_plan(argument);
    else if (!is_one_of(argument.detail,
                        {"", "REAL", "DOUBLE", "DOUBLE PRECISION", "FLOAT", "NUMERIC", "INT", "INTEGER"}))
      refuse(argument, std::string(word.name) +
                           (is_kind(word.quantity) ? " holds an integer" : " holds a double") + "; write " +
                           std::string(word.name) + " or " + std::string(word.name) +
                           (is_kind(word.quantity) ? " INTEGER" : " REAL"));
    require_new_name(argument);
    if (!declaration_.auxiliaries.empty())
      refuse(argument, "motion columns come before the auxiliary columns; move it before +" +
                           declaration_.auxiliaries.front().name);
    require_before_kinds(argument, word);
    words_.push_back({word, argument.text});
  }

  void add_auxiliary(const Argument& argument) {
    require_new_name(argument);
    declaration_.auxiliaries.push_back({argument.name, argument.detail});
  }

  void add_option(const Argument& argument) {
    if (frame_.read_if_known(argument)) return;
    if (!same_name(argument.name, "horizon"))
      refuse(argument, "no such option; known: horizon, origin, speed_unit and frame, as in horizon = 60");
    if (has_horizon_) refuse(argument, "horizon is given twice; leave one out");
    has_horizon_ = true;
    declaration_.horizon = positive_number(argument);
  }

  /// Three axes, whether or not z is declared, with the Earth's curvature as acceleration.
  void use_axes_of_globe() {
    declaration_.layout.axes = 3;
    if (declaration_.layout.law == Law::uniform) declaration_.layout.law = Law::accelerated;
  }

  void require_before_kinds(const Argument& argument, const Word& word) const {
    if (!words_.empty() && is_kind(words_.back().word.quantity) && !is_kind(word.quantity))
      refuse(argument, "category and mask come after the motion columns; move it before " +
                           std::string(words_.back().word.name));
  }

  void require_new_name(const Argument& argument) const {
    bool taken = same_name(argument.name, "id");
    for (const DeclaredWord& declared : words_) taken |= same_name(declared.word.name, argument.name);
    for (const AuxiliaryColumn& column : declaration_.auxiliaries)
      taken |= same_name(column.name, argument.name);
    if (taken)
      refuse(argument, "a column named " + argument.name + " is declared already; choose another name");
  }

  void require_no_hidden_names() const {
    for (const AuxiliaryColumn& column : declaration_.auxiliaries)
      for (const std::string_view hidden : hidden_columns(declaration_))
        if (same_name(column.name, hidden))
          throw Error("\"+" + column.name + "\": a table with lat, lon has a hidden column " + column.name +
                      " already; choose another name");
  }

  std::vector<DeclaredWord> words_;
  FrameOptions frame_;
  Declaration declaration_;
  bool has_horizon_ = false;
};

}  // namespace

Declaration parse_declaration(std::string_view table, const std::vector<std::string_view>& arguments) try {
  if (arguments.empty())
    throw Error("no columns are declared; write for example moving_objects(id, t, x, y, vx, vy, r)");
  require_id(parse_argument(arguments[0]));
  Declarer declarer;
  for (std::size_t i = 1; i < arguments.size(); ++i) declarer.add(parse_argument(arguments[i]));
  Declaration declaration = declarer.finish();
  require_table_name(declaration, table);
  return declaration;
} catch (const Error& error) {
  throw Error(std::string(table) + ": " + error.what());
}

std::span<const std::string_view> hidden_columns(const Declaration& declaration) {
  static constexpr std::array<std::string_view, 4> on_plane{"x", "y", "vx", "vy"};
  static constexpr std::array<std::string_view, 9> on_globe{"gx",  "gy",  "gz",  "gvx", "gvy",
                                                            "gvz", "gax", "gay", "gaz"};
  if (!declaration.frame.in_degrees() || declaration.has_zones()) return {};
  const auto& columns = declaration.columns;
  const bool moves = std::any_of(columns.begin(), columns.end(),
                                 [](const MotionColumn& column) { return column.geo == GeoColumn::speed; });
  if (declaration.frame.on_globe()) return std::span(on_globe).first(moves ? 9 : 3);
  return std::span(on_plane).first(moves ? 4 : 2);
}

void require_table_name(const Declaration& declaration, std::string_view table) {
  bool taken = same_name("id", table);
  for (const MotionColumn& column : declaration.columns) taken |= same_name(column.name, table);
  for (const AuxiliaryColumn& column : declaration.auxiliaries) taken |= same_name(column.name, table);
  for (const std::string_view hidden : hidden_columns(declaration)) taken |= same_name(hidden, table);
  if (taken)
    throw Error(
        "a table cannot be named like one of its columns (commands go to a column named like the table);"
        " choose another name than " +
        std::string(table));
}

std::string declared_schema(const Declaration& declaration, std::string_view table) {
  std::string sql = "CREATE TABLE x(id INTEGER PRIMARY KEY";
  for (const MotionColumn& column : declaration.columns)
    sql += ", " + quoted_name(column.name) +
           (column.is_form   ? " TEXT"
            : column.is_kind ? " INTEGER"
            : column.is_plan ? " BLOB"
                             : " REAL");
  for (const AuxiliaryColumn& column : declaration.auxiliaries)
    sql += ", " + quoted_name(column.name) + " " + column.type;
  sql += ", " + quoted_name(std::string(table)) + " HIDDEN";
  for (const std::string_view hidden : hidden_columns(declaration))
    sql += ", " + std::string(hidden) + " REAL HIDDEN";
  return sql + ")";
}

}  // namespace foresee
