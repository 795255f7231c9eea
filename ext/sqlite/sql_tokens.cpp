#include "sqlite/sql_tokens.h"

#include <algorithm>

namespace foresee {
namespace {

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

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::optional<SqlToken> SqlTokens::next() {
  using Kind = SqlToken::Kind;
  skip_blanks();
  if (rest_.empty()) return std::nullopt;
  const char first = rest_[0];
  if (first == '"' || first == '`' || first == '\'' || first == '[') return take_quoted(first);
  if (is_letter(first))
    return take_while(Kind::word, [](char c) { return is_letter(c) || is_digit(c) || c == '$'; });
  if (is_digit(first) || first == '.')
    return take_while(Kind::number, [](char c) { return is_letter(c) || is_digit(c) || c == '.'; });
  return take_while(Kind::sign, [](char) { return false; });
}

void SqlTokens::skip_blanks() {
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

/// Moves past `end`, the end of a comment that starts with two characters.
void SqlTokens::skip_past(std::string_view end) {
  const std::size_t found = rest_.find(end, 2);
  rest_.remove_prefix(found == std::string_view::npos ? rest_.size() : found + end.size());
}

template <class Belongs>
SqlToken SqlTokens::take_while(SqlToken::Kind kind, Belongs belongs) {
  std::size_t size = 1;
  while (size < rest_.size() && belongs(rest_[size])) ++size;
  SqlToken token{kind, std::string(rest_.substr(0, size))};
  rest_.remove_prefix(size);
  return token;
}

SqlToken SqlTokens::take_quoted(char open) {
  const char close = open == '[' ? ']' : open;
  SqlToken token{SqlToken::Kind::quoted, ""};
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

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char l, char r) { return lower(l) == lower(r); });
}

}  // namespace foresee
