// Parser of the arguments of CREATE VIRTUAL TABLE … USING moving_objects into a Declaration.
//
//   Declaration ships = parse_declaration("ships", {"id", "t", "x", "y", "vx", "vy", "r", "+name TEXT"});
//
// The id comes first, then the motion columns in any order, then auxiliary columns, as in SQLite's R*Tree.
// Options (`horizon = 60`) may occur anywhere after the id. An invalid declaration
// (docs/reference/moving_objects.md#columns) throws Error. The message names the table, quotes the argument and says
// what to write instead.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "format/declaration.h"

namespace foresee {

Declaration parse_declaration(std::string_view table, const std::vector<std::string_view>& arguments);

/// Throws Error if `table` is also a column's name, because the command column has the name of the table.
void require_table_name(const Declaration& declaration, std::string_view table);

/// The stored columns of a table in degrees, which can be read only: x, y and, if its objects move, vx, vy; on the
/// globe gx, gy, gz and gvx … gaz.
std::span<const std::string_view> hidden_columns(const Declaration& declaration);

/// The CREATE TABLE statement for sqlite3_declare_vtab: id, the declared columns in their order, the hidden
/// command column, which has the name of the table, and the other hidden_columns().
std::string declared_schema(const Declaration& declaration, std::string_view table);

}  // namespace foresee
