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
  if (argument.kind == Argument::Kind::column && at < tokens.size() && tokens[at].text == "=") {
    argument.kind = Argument::Kind::option;
    while (++at < tokens.size()) argument.detail += tokens[at].text;
    return argument;
  }
  argument.detail = type_of(argument, tokens, at);
  return argument;
}

}  // namespace foresee
