#include "shape/outline/wkt_reader.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "base/float_environment.h"
#include "shape/outline/wkt_writer.h"

namespace foresee::shape {

namespace {

constexpr std::string_view white_space = " \t\n\v\f\r", separators = "(),;= \t\n\v\f\r";
constexpr std::size_t most_quoted = 40;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// Reads from the front to the back, each character once.
class WktReader {
 public:
  explicit WktReader(std::string_view text) : text_(text) {}

  Outline outline() {
    skip_srid();
    if (take_word("MULTIPOLYGON"))
      parts();
    else if (take_word("POLYGON"))
      part();
    else
      refuse_kind();
    if (!rest().empty()) expected("the end");
    return std::move(outline_);
  }

 private:
  /// What is left, from the next character that is no white space.
  std::string_view rest() {
    at_ = std::min(text_.find_first_not_of(white_space, at_), text_.size());
    return text_.substr(at_);
  }

  /// The next word, number or sign, where the reader stands.
  std::string_view token() {
    const std::string_view left = rest();
    return left.substr(0, std::max<std::size_t>(left.find_first_of(separators), left.empty() ? 0 : 1));
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw Error("at character " + std::to_string(at_ + 1) + ": " + why);
  }

  [[noreturn]] void expected(const std::string& what) {
    const std::string_view found = token();
    if (found.empty()) fail("expected " + what + ", found the end");
    fail("expected " + what + ", found '" + quoted(found) + "'");
  }

  /// So many characters of it, in UTF-8, as a message can hold, and none behind a zero byte.
  static std::string quoted(std::string_view found) {
    found = found.substr(0, found.find('\0'));
    std::size_t characters = 0, last = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const bool begins = (static_cast<unsigned char>(found[i]) & 0xc0) != 0x80;
      if (begins && ++characters == most_quoted) last = i;
      if (characters > most_quoted || i > 4 * most_quoted) return std::string(found.substr(0, last)) + "…";
    }
    return std::string(found);
  }

  bool take(char sign) {
    const std::string_view left = rest();
    if (left.empty() || left.front() != sign) return false;
    ++at_;
    return true;
  }

  void must_take(char sign) {
    if (!take(sign)) expected({sign});
  }

  /// In any case; not where it goes on in letters.
  bool next_is(std::string_view word) {
    const std::string_view next = token();
    return std::equal(next.begin(), next.end(), word.begin(), word.end(),
                      [](char a, char b) { return upper(a) == b; });
  }

  bool take_word(std::string_view word) {
    const bool found = next_is(word);
    if (found) at_ += word.size();
    return found;
  }

  /// "SRID=32632;"
  void skip_srid() {
    if (!take_word("SRID")) return;
    must_take('=');
    const std::string_view digits = token();
    std::uint64_t srid = 0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), srid);
    if (status != std::errc() || end != digits.data() + digits.size()) expected("a whole number");
    if (srid == 4326) fail("SRID 4326 is in degrees: project to metres first");
    at_ += digits.size();
    must_take(';');
  }

  [[noreturn]] void refuse_kind() {
    for (const char* mesh : {"TIN", "POLYHEDRALSURFACE"})
      if (next_is(mesh))
        fail(std::string(mesh) + " is a mesh, which is not read yet: write POLYGON or MULTIPOLYGON");
    expected("POLYGON or MULTIPOLYGON");
  }

  /// "POLYGON Z ((...))"
  void refuse_more_numbers() {
    for (const char* more : {"Z", "M", "ZM"})
      if (next_is(more))
        fail("corners of a flat outline have two numbers: leave " + std::string(token()) + " out");
  }

  void refuse_empty() {
    refuse_more_numbers();
    if (next_is("EMPTY")) fail("EMPTY is no outline: write NULL for a point");
  }

  void parts() {
    refuse_empty();
    must_take('(');
    do part();
    while (take(','));
    must_take(')');
  }

  void part() {
    refuse_empty();
    must_take('(');
    outline_.begin_part();
    ring();
    while (take(',')) {
      outline_.begin_hole();
      ring();
    }
    must_take(')');
  }

  void ring() {
    refuse_empty();
    must_take('(');
    for (;;) {
      const double x = number();
      outline_.add({x, number()});
      if (!take(',')) break;
      if (outline_.corners().size() > most_corners) refuse_corners(1);
    }
    if (!take(')')) refuse_corner_end();
    const std::size_t last = outline_.rings() - 1;
    if (outline_.close_ring() || outline_.ring(last).size() == 1) {
      if (outline_.corners().size() > most_corners) refuse_corners(0);
      return;
    }
    throw Error(name_of_ring(outline_, last) + " is not closed: write the first corner (" +
                shown(outline_.ring(last).front()) + ") again at its end");
  }

  double number() {
    std::string_view left = rest();
    const bool plus = left.starts_with('+');
    if (plus) left.remove_prefix(1);
    // Of what from_chars reads as a number, words are none here.
    const std::size_t sign = !plus && left.starts_with('-') ? 1 : 0;
    if (left.size() <= sign || !(is_digit(left[sign]) || left[sign] == '.')) expected("a number");
    double number = 0;
    const auto [end, status] = std::from_chars(left.data(), left.data() + left.size(), number);
    if (status == std::errc::result_out_of_range) fail("no double is near " + quoted(token()));
    const bool ends = end == left.data() + left.size() || separators.find(*end) != std::string_view::npos;
    if (status != std::errc() || !ends) expected("a number");
    at_ = static_cast<std::size_t>(end - text_.data());
    return number;
  }

  [[noreturn]] void refuse_corner_end() {
    const std::string_view next = token();
    if (!next.empty() && (is_digit(next[0]) || next[0] == '-' || next[0] == '+' || next[0] == '.'))
      fail("a third number: corners of a flat outline have two: leave z out");
    expected(", or )");
  }

  /// More than there may be have been read: counts the others by the commas before them, as rings are closed.
  /// `begun`: of how many the comma has been read.
  [[noreturn]] void refuse_corners(std::size_t begun) {
    std::size_t corners = outline_.corners().size() + begun;
    bool closed = begun == 0;
    for (const char c : text_.substr(at_)) {
      if (c == ',') ++corners, closed = false;
      if (c == ')' && !closed) --corners, closed = true;
    }
    throw Error(std::to_string(corners) + " corners; at most " + std::to_string(most_corners) +
                ": simplify the outline");
  }

  std::string_view text_;
  std::size_t at_ = 0;  ///< all before it is read
  Outline outline_;
};

}  // namespace

Outline read_outline(std::string_view text) {
  const FloatEnvironment environment;
  return WktReader(text).outline();
}

}  // namespace foresee::shape
