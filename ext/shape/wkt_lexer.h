// What comes next in a well-known text (OGC Simple Features, part 1, section 7)? For the readers of outlines
// and meshes, which say what may come.
//
//   if (take_word("POLYGON")) must_take('(');
//   const double x = number(), y = number();
//
// Words are known in any case; white space may stand between all. Each number is the double nearest to what
// is written; one beyond the largest double is refused, and one that is not 0 but nearest to it. Errors name
// the character (the first is 1) and quote at most 40 characters. Reads from the front to the back, each
// character once: linear in the text, whatever it is.
#pragma once

#include <string>
#include <string_view>

namespace foresee {

class WktLexer {
 public:
  explicit WktLexer(std::string_view text) : text_(text) {}

  /// What is left, from the next character that is no white space.
  std::string_view rest();
  /// The next word, number or sign, where the reader stands.
  std::string_view token();
  /// Whether that begins as a number does.
  bool next_is_number();
  /// In any case; not where it goes on in letters.
  bool next_is(std::string_view word);

  bool take(char sign);
  void must_take(char sign);
  bool take_word(std::string_view word);
  /// Drops "SRID=32632;", but refuses 4326: degrees are no lengths.
  void skip_srid();
  double number();
  void must_end();

  /// Throws Error: "at character 14: " and why.
  [[noreturn]] void fail(const std::string& why) const;
  /// "expected a number, found 'nan'"
  [[noreturn]] void expected(const std::string& what);

 private:
  std::string_view text_;
  std::size_t at_ = 0;  ///< all before it is read
};

}  // namespace foresee
