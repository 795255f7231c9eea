// Parser of one argument of CREATE VIRTUAL TABLE: a column, an auxiliary column or an option.
//
//   parse_argument("vx REAL")          // {column, "vx", "REAL"}
//   parse_argument("+\"full name\"")   // {auxiliary, "full name", ""}
//   parse_argument("horizon = 600")    // {option, "horizon", "600"}
//
// Names may be quoted in any style of SQLite. Throws Error with a message that says what to write instead.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace foresee {

struct Argument {
  enum class Kind : std::uint8_t { column, auxiliary, option };

  std::string text;  ///< as the user wrote it, for messages
  Kind kind = Kind::column;
  std::string name;
  std::string detail;  ///< of a column: the type; of an option: the value
};

Argument parse_argument(std::string_view text);

}  // namespace foresee
