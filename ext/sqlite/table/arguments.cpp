#include "sqlite/table/arguments.h"

#include <array>
#include <vector>

#include "base/error.h"
#include "sqlite/table/vocabulary.h"

namespace foresee {
namespace {

struct Token {
  enum class Kind : std::uint8_t { word, quoted, number, symbol };
  Kind kind;
  std::string text;  ///< a quoted token without its quotes
};

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Splits the text as SQLite's tokenizer does, as far as arguments need it.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : rest_(text) {
    while (skip_blanks(), !rest_.empty()) tokens_.push_back(take());
  }

  const std::vector<Token>& all() const { return tokens_; }

 private:
  void skip_blanks() {
    for (;;) {
      if (!rest_.empty() && is_space(rest_[0])) {
        rest_.remove_prefix(1);
      } else if (rest_.starts_with("--")) {
        skip_past("\n");
      } else if (rest_.starts_with("/*")) {
        skip_past("*/");
      } else {
        return;
      }
    }
  }

  void skip_past(std::string_view end) {
    const std::size_t found = rest_.find(end, 2);
    rest_.remove_prefix(found == std::string_view::npos ? rest_.size() : found + end.size());
  }

  Token take() {
    const char first = rest_[0];
    if (first == '"' || first == '`' || first == '\'' || first == '[') return take_quoted(first);
    if (is_letter(first))
      return take_while(Token::Kind::word, [](char c) { return is_letter(c) || is_digit(c) || c == '$'; });
    if (is_digit(first) || first == '.')
      return take_while(Token::Kind::number, [](char c) { return is_letter(c) || is_digit(c) || c == '.'; });
    rest_.remove_prefix(1);
    return {Token::Kind::symbol, std::string(1, first)};
  }

  template <class Belongs>
  Token take_while(Token::Kind kind, Belongs belongs) {
    std::size_t size = 1;
    while (size < rest_.size() && belongs(rest_[size])) ++size;
    Token token{kind, std::string(rest_.substr(0, size))};
    rest_.remove_prefix(size);
    return token;
  }

  /// A doubled closing quote stands for itself.
  Token take_quoted(char open) {
    const char close = open == '[' ? ']' : open;
    Token token{Token::Kind::quoted, ""};
    std::size_t i = 1;
    for (; i < rest_.size(); ++i) {
      if (rest_[i] != close) {
        token.text += rest_[i];
      } else if (open != '[' && i + 1 < rest_.size() && rest_[i + 1] == close) {
        token.text += rest_[i++];
      } else {
        break;
      }
    }
    rest_.remove_prefix(i < rest_.size() ? i + 1 : i);
    return token;
  }

  std::string_view rest_;
  std::vector<Token> tokens_;
};

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw Error("\"" + std::string(text) + "\": " + why);
}

bool is_name(const Token& token) {
  return token.kind == Token::Kind::word || token.kind == Token::Kind::quoted;
}

bool is_constraint_keyword(std::string_view word) {
  static constexpr std::array<std::string_view, 11> keywords = {
      "primary", "not",        "null",      "unique",     "check", "default",
      "key",     "references", "generated", "constraint", "hidden"};
  for (std::string_view keyword : keywords)
    if (same_name(keyword, word)) return true;
  return false;
}

/// Words, perhaps sizes in parentheses, perhaps COLLATE: what may follow a column's name.
std::string type_of(const Argument& argument, const std::vector<Token>& tokens, std::size_t i) {
  std::string type;
  for (; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    const bool sizes = token.kind == Token::Kind::number || token.text == "(" || token.text == ")" ||
                       token.text == "," || token.text == "-" || token.text == "+";
    if (!sizes && token.kind != Token::Kind::word)
      refuse(argument.text, "'" + token.text + "' is not part of a type; write the name and a type");
    if (argument.kind == Argument::Kind::auxiliary && is_constraint_keyword(token.text))
      refuse(argument.text, "an auxiliary column takes a name, a type and COLLATE, but no " + token.text);
    if (!type.empty() && token.kind == Token::Kind::word) type += ' ';
    type += token.text;
  }
  return type;
}

}  // namespace

Argument parse_argument(std::string_view text) {
  const Tokens split(text);
  const std::vector<Token>& tokens = split.all();
  Argument argument{.text = std::string(text), .kind = {}, .name = {}, .detail = {}};
  std::size_t at = 0;
  if (!tokens.empty() && tokens[0].kind == Token::Kind::symbol && tokens[0].text == "+") {
    argument.kind = Argument::Kind::auxiliary;
    at = 1;
  }
  if (at == tokens.size() || !is_name(tokens[at]) || tokens[at].text.empty())
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
