#include "base/text/wkt_lexer.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "base/error.h"

namespace foresee {

namespace {

constexpr std::string_view white_space = " \t\n\v\f\r", separators = "(),;= \t\n\v\f\r";
constexpr std::size_t max_quoted = 40;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// The first characters, in UTF-8, as many as a message can hold, up to a zero byte.
std::string quoted(std::string_view found) {
  found = found.substr(0, found.find('\0'));
  std::size_t characters = 0, last = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool starts = (static_cast<unsigned char>(found[i]) & 0xc0) != 0x80;
    if (starts && ++characters == max_quoted) last = i;
    if (characters > max_quoted || i > 4 * max_quoted) return std::string(found.substr(0, last)) + "…";
  }
  return std::string(found);
}

}  // namespace

bool starts_with_date(std::string_view text) {
  constexpr std::string_view date = "dddd-dd-dd";
  return text.size() >= date.size() &&
         std::equal(date.begin(), date.end(), text.begin(),
                    [](char pattern, char c) { return pattern == 'd' ? is_digit(c) : pattern == c; });
}

std::string_view WktLexer::rest() {
  at_ = std::min(text_.find_first_not_of(white_space, at_), text_.size());
  return text_.substr(at_);
}

std::string_view WktLexer::token() {
  const std::string_view left = rest();
  return left.substr(0, std::max<std::size_t>(left.find_first_of(separators), left.empty() ? 0 : 1));
}

bool WktLexer::next_is_number() {
  const std::string_view next = token();
  return !next.empty() && (is_digit(next[0]) || next[0] == '-' || next[0] == '+' || next[0] == '.');
}

bool WktLexer::next_is(std::string_view word) {
  const std::string_view next = token();
  return std::equal(next.begin(), next.end(), word.begin(), word.end(),
                    [](char a, char b) { return upper(a) == b; });
}

bool WktLexer::take(char sign) {
  const std::string_view left = rest();
  if (left.empty() || left.front() != sign) return false;
  ++at_;
  return true;
}

void WktLexer::must_take(char sign) {
  if (!take(sign)) expected({sign});
}

bool WktLexer::take_word(std::string_view word) {
  const bool found = next_is(word);
  if (found) at_ += word.size();
  return found;
}

void WktLexer::skip_srid(WktUnit unit) {
  if (!take_word("SRID")) return;
  must_take('=');
  const std::string_view digits = token();
  std::uint64_t srid = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), srid);
  if (status != std::errc() || end != digits.data() + digits.size()) expected("a whole number");
  if (srid == 4326 && unit == WktUnit::metres) fail("SRID 4326 is in degrees: project to metres first");
  if (srid != 4326 && unit == WktUnit::degrees)
    fail("SRID " + std::to_string(srid) + " is not 4326, longitude and latitude: transform it first");
  at_ += digits.size();
  must_take(';');
}

double WktLexer::number() {
  std::string_view left = rest();
  const bool plus = left.starts_with('+');
  if (plus) left.remove_prefix(1);
  // from_chars also reads words, such as "inf", as numbers; they are refused here.
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

void WktLexer::must_end() {
  if (!rest().empty()) expected("the end");
}

void WktLexer::fail(const std::string& why) const {
  throw Error("at character " + std::to_string(at_ + 1) + ": " + why);
}

void WktLexer::expected(const std::string& what) {
  const std::string_view found = token();
  if (found.empty()) fail("expected " + what + ", found the end");
  fail("expected " + what + ", found '" + quoted(found) + "'");
}

}  // namespace foresee
