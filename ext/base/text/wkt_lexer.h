// Lexer of well-known text (WKT; OGC Simple Features, part 1, section 7) for readers of geometries.
//
//   if (take_word("POLYGON")) must_take('(');
//   const double x = number(), y = number();
//
// Words are recognized in any case; white space may stand between all tokens. Each number is the nearest
// double; one beyond the largest double is refused, and so is one that underflows to 0. Errors name the
// character (the first is 1) and quote at most 40 characters. The lexer reads each character once: linear in
// the text, whatever it is.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace foresee {

/// The unit of the numbers in a text.
enum class WktUnit : std::uint8_t { metres, degrees };

/// True for "2026-11-21T12:00:00Z": where a number is needed, its seconds are.
bool starts_with_date(std::string_view text);

class WktLexer {
 public:
  explicit WktLexer(std::string_view text) : text_(text) {}

  /// The remaining text, from the next character that is not white space.
  std::string_view rest();
  /// The next word, number or sign, at the current position.
  std::string_view token();
  /// Whether the next token starts like a number.
  bool next_is_number();
  /// Whether the next word is `word`, in any case; not if more letters follow.
  bool next_is(std::string_view word);

  bool take(char sign);
  void must_take(char sign);
  bool take_word(std::string_view word);
  /// Drops "SRID=32632;", but refuses 4326: degrees are not lengths. For degrees, drops 4326 alone.
  void skip_srid(WktUnit unit = WktUnit::metres);
  double number();
  void must_end();

  /// Throws Error: "at character 14: " and why.
  [[noreturn]] void fail(const std::string& why) const;
  /// "expected a number, found 'nan'"
  [[noreturn]] void expected(const std::string& what);

 private:
  std::string_view text_;
  std::size_t at_ = 0;  ///< the current position
};

}  // namespace foresee
