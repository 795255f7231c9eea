#include "sqlite/table/table_arguments.h"

#include <array>
#include <vector>

#include "base/error.h"
#include "sqlite/sql_tokens.h"

namespace foresee {
namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw Error("\"" + std::string(text) + "\": " + why);
}

std::vector<SqlToken> split(std::string_view text) {
  std::vector<SqlToken> tokens;
  SqlTokens source(text);
  while (auto token = source.next()) tokens.push_back(std::move(*token));
  return tokens;
}

bool is_constraint_keyword(std::string_view word) {
  static constexpr std::array<std::string_view, 11> keywords = {
      "primary", "not",        "null",      "unique",     "check", "default",
      "key",     "references", "generated", "constraint", "hidden"};
  for (std::string_view keyword : keywords)
    if (same_name(keyword, word)) return true;
  return false;
}

/// The type after a column's name: words, optional sizes in parentheses, optional COLLATE.
std::string type_of(const Argument& argument, const std::vector<SqlToken>& tokens, std::size_t i) {
  std::string type;
  for (; i < tokens.size(); ++i) {
    const SqlToken& token = tokens[i];
    const bool sizes = token.kind == SqlToken::Kind::number || token.text == "(" || token.text == ")" ||
                       token.text == "," || token.text == "-" || token.text == "+";
    if (!sizes && token.kind != SqlToken::Kind::word)
      refuse(argument.text, "'" + token.text + "' is not part of a type; write the name and a type");
    if (argument.kind == Argument::Kind::auxiliary && is_constraint_keyword(token.text))
      refuse(argument.text, "an auxiliary column takes a name, a type and COLLATE, but no " + token.text);
    if (!type.empty() && token.kind == SqlToken::Kind::word) type += ' ';
    type += token.text;
  }
  return type;
}

/// The text of a value of several tokens, such as -1e-3 or '60 s', with its blanks.
std::string text_behind_equals(std::string_view text) {
  constexpr std::string_view blanks = " \t\n\f\r";
  std::string_view value = text.substr(text.find('=') + 1);
  value.remove_prefix(std::min(value.find_first_not_of(blanks), value.size()));
  return std::string(value.substr(0, value.find_last_not_of(blanks) + 1));
}

}  // namespace

Argument parse_argument(std::string_view text) {
  const std::vector<SqlToken> tokens = split(text);
  Argument argument{.text = std::string(text), .kind = {}, .name = {}, .detail = {}};
  std::size_t at = 0;
  if (!tokens.empty() && tokens[0].is_sign('+')) {
    argument.kind = Argument::Kind::auxiliary;
    at = 1;
  }
  if (at == tokens.size() || !tokens[at].is_name() || tokens[at].text.empty())
    refuse(text, at == 1 ? "a name must follow the +, as in +name TEXT"
                         : "not a column; write a name, +name for a column of your own, or key = value");
  argument.name = tokens[at++].text;
  if (argument.kind == Argument::Kind::column && at < tokens.size() && tokens[at].is_sign('=')) {
    argument.kind = Argument::Kind::option;
    const std::size_t values = tokens.size() - ++at;
    argument.detail = values > 1 ? text_behind_equals(text) : values == 1 ? tokens[at].text : "";
    return argument;
  }
  argument.detail = type_of(argument, tokens, at);
  return argument;
}

}  // namespace foresee
