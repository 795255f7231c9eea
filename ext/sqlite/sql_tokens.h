// Of which words, names and signs does a text of SQL consist? One token after another, as SQLite splits it.
//
//   SqlTokens tokens("USING [a b](x -- why\n)");
//   while (const auto token = tokens.next()) use(token->text);      // USING, a b, (, x, )
//
// Blanks and comments come between tokens. What is quoted in any of SQLite's four ways comes without its
// quotes, a doubled closing quote once; what is never closed ends with the text. Signs come one character at
// a time, and a number reaches as far as letters, digits and points do: enough for declarations. Cost:
// linear, and one token is held at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace foresee {

struct SqlToken {
  enum class Kind : std::uint8_t { word, quoted, number, sign };

  Kind kind;
  std::string text;  ///< a quoted token without its quotes

  bool is_name() const { return kind == Kind::word || kind == Kind::quoted; }
  bool is_sign(char c) const { return kind == Kind::sign && text[0] == c; }
};

class SqlTokens {
 public:
  /// `text` must outlive this.
  explicit SqlTokens(std::string_view text) : rest_(text) {}

  /// Nothing at the end.
  std::optional<SqlToken> next();

 private:
  void skip_blanks();
  void skip_past(std::string_view end);
  template <class Belongs>
  SqlToken take_while(SqlToken::Kind kind, Belongs belongs);
  SqlToken take_quoted(char open);

  std::string_view rest_;
};

/// Equal as SQLite compares names: ASCII letters in any case.
bool same_name(std::string_view a, std::string_view b);

}  // namespace foresee
