// Tokenizer of SQL text: words, quoted names, numbers and signs, split as SQLite does.
//
//   SqlTokens tokens("USING [a b](x -- why\n)");
//   while (const auto token = tokens.next()) use(token->text);      // USING, a b, (, x, )
//
// Skips blanks and comments. A name in any of SQLite's four kinds of quotes is returned without them, and a
// doubled closing quote once; without a closing quote it ends with the text. A sign is one character. A
// number extends over letters, digits and points, which is enough for declarations. Cost: linear in the text;
// one token is held at a time.
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

  /// The next token; nothing at the end.
  std::optional<SqlToken> next();

 private:
  void skip_blanks();
  void skip_past(std::string_view end);
  template <class Belongs>
  SqlToken take_while(SqlToken::Kind kind, Belongs belongs);
  SqlToken take_quoted(char open);

  std::string_view rest_;
};

/// Whether the names are equal for SQLite, which ignores the case of ASCII letters.
bool same_name(std::string_view a, std::string_view b);

}  // namespace foresee
