#include "storage/rows/shadow_schema.h"

#include <array>
#include <cstring>
#include <span>

#include "shape/shapes.h"
#include "storage/rows/statement.h"
#include "storage/rows/store_error.h"

namespace foresee {
namespace {

constexpr std::array<const char*, 4> suffixes{"node", "map", "meta", "aux"};

std::span<const char* const> suffixes_of(const Declaration& declaration) {
  const bool has_aux = !declaration.auxiliaries.empty();
  return std::span(suffixes).first(has_aux ? 4 : 3);
}

std::string create_tables_sql(const QualifiedName& name, const Declaration& declaration) {
  const char* schema = name.schema.c_str();
  const char* table = name.table.c_str();
  std::string sql =
      format_sql("CREATE TABLE \"%w\".\"%w_node\"(nodeno INTEGER PRIMARY KEY, data BLOB);", schema, table) +
      format_sql("CREATE TABLE \"%w\".\"%w_map\"(id INTEGER PRIMARY KEY, leaf INTEGER);", schema, table) +
      format_sql("CREATE TABLE \"%w\".\"%w_meta\"(key TEXT PRIMARY KEY, value) WITHOUT ROWID;", schema,
                 table);
  if (declaration.auxiliaries.empty()) return sql;
  sql += format_sql("CREATE TABLE \"%w\".\"%w_aux\"(id INTEGER PRIMARY KEY", schema, table);
  for (std::size_t i = 0; i < declaration.auxiliaries.size(); ++i) sql += ", a" + std::to_string(i);
  return sql + ");";
}

std::int64_t page_size(sqlite3* db, const QualifiedName& name) {
  Statement statement(db, format_sql("PRAGMA \"%w\".page_size", name.schema.c_str()));
  Statement::Run run(statement);
  if (!run.step()) throw StoreError(SQLITE_ERROR, "no page size of database " + name.schema);
  return run.integer(0);
}

class MetaWriter {
 public:
  MetaWriter(sqlite3* db, const QualifiedName& name)
      : insert_(db, format_sql("INSERT INTO \"%w\".\"%w_meta\" VALUES(?, ?)", name.schema.c_str(),
                               name.table.c_str())) {}

  template <class Value>
  void write(const char* key, Value value) {
    Statement::Run run(insert_);
    run.bind(1, std::string(key));
    run.bind(2, value);
    run.step();
  }

 private:
  Statement insert_;
};

[[noreturn]] void refuse(int code, const QualifiedName& name, const std::string& what) {
  throw StoreError(code, name.table + ": " + what);
}

/// What _meta says under a key, as text; "" where it says nothing. Of a text that is longer than `most` only
/// the beginning: who reads it compares it with what is shorter.
std::string read_meta(sqlite3* db, const QualifiedName& name, const char* key, std::size_t most = 100) {
  Statement select(
      db, format_sql("SELECT substr(value, 1, %lld) FROM \"%w\".\"%w_meta\" WHERE key = %Q",
                     static_cast<sqlite3_int64>(most), name.schema.c_str(), name.table.c_str(), key));
  Statement::Run run(select);
  return run.step() ? run.text(0) : "";
}

/// A view or a virtual table may have rows without end, and run what it likes. A table that is missing says
/// so where it is read.
void require_tables(sqlite3* db, const QualifiedName& name, const Declaration& declaration) {
  std::string sql = format_sql(
      "SELECT name, type = 'view' FROM \"%w\".sqlite_schema WHERE type IN ('table', 'view') "
      "AND coalesce(rootpage, 0) <= 0 AND name COLLATE NOCASE IN (''",
      name.schema.c_str());
  for (const char* suffix : suffixes_of(declaration))
    sql += format_sql(", '%q_%s'", name.table.c_str(), suffix);
  Statement no_tables(db, sql + ")");
  Statement::Run run(no_tables);
  if (!run.step()) return;
  const std::string shadow = run.text(0);
  const bool is_view = run.integer(1) != 0;
  refuse(SQLITE_CORRUPT_VTAB, name,
         shadow + " is a " + (is_view ? "view" : "virtual table") +
             ", where foresee keeps a table of its own: DROP " + (is_view ? "VIEW " : "TABLE ") + shadow +
             ", then DROP TABLE " + name.table + " or restore what was there");
}

}  // namespace

bool is_shadow_suffix(std::string_view suffix) {
  for (const char* known : suffixes)
    if (suffix.size() == std::strlen(known) &&
        sqlite3_strnicmp(suffix.data(), known, static_cast<int>(suffix.size())) == 0)
      return true;
  return false;
}

std::string describe_columns(const Declaration& declaration) {
  const Layout& layout = declaration.layout;
  std::string text = "id";
  auto on_all_axes = [&](const char* prefix) {
    for (int axis = 0; axis < layout.axes; ++axis) text += std::string(", ") + prefix + "xyz"[axis];
  };
  if (layout.has_t) text += ", t";
  on_all_axes("");
  if (layout.law != Law::rest) on_all_axes("v");
  if (layout.law == Law::accelerated) on_all_axes("a");
  if (layout.law == Law::forced) {
    on_all_axes("f");
    text += ", m";
  }
  with_shape(layout.shape, [&](auto shape) {
    for (const SizeColumn& column : shape.sizes)
      column.on_all_axes ? on_all_axes(column.name)
                         : static_cast<void>(text += std::string(", ") + column.name);
  });
  if (layout.has_until) text += ", until";
  for (const AuxiliaryColumn& column : declaration.auxiliaries) text += ", +" + column.name;
  return text;
}

NodeFormat create_shadow_tables(sqlite3* db, const QualifiedName& name, const Declaration& declaration) {
  const auto page = static_cast<std::size_t>(page_size(db, name));
  const NodeFormat format(declaration.layout, NodeFormat::node_size_for(declaration.layout, page));
  execute(db, create_tables_sql(name, declaration));
  std::int64_t stamp;
  sqlite3_randomness(sizeof stamp, &stamp);
  MetaWriter meta(db, name);
  meta.write("format", std::int64_t{NodeFormat::version});
  meta.write("columns", describe_columns(declaration));
  meta.write("node_size", static_cast<std::int64_t>(format.node_size));
  meta.write("horizon", declaration.horizon);
  meta.write("root", std::int64_t{0});
  meta.write("stamp", stamp);
  return format;
}

NodeFormat read_node_format(sqlite3* db, const QualifiedName& name, const Declaration& declaration) {
  require_tables(db, name, declaration);
  const std::string version = std::to_string(NodeFormat::version), format = read_meta(db, name, "format");
  if (format != version)
    refuse(SQLITE_ERROR, name,
           "stored in format '" + format + "'; this version of foresee reads format " + version +
               ". Copy the table with the version that wrote it (CREATE TABLE copy AS SELECT * FROM " +
               name.table + "), drop it, make it anew and insert the copy");
  const std::string declared = describe_columns(declaration);
  if (const std::string columns = read_meta(db, name, "columns", 2 * declared.size() + 1000);
      columns != declared)
    refuse(SQLITE_CORRUPT_VTAB, name,
           "stored with the columns (" + columns + ") but declared with (" + declared + ")");
  const std::string stored = read_meta(db, name, "node_size");
  constexpr std::size_t largest_page = 65536;
  for (std::size_t page = 512; page <= largest_page; page *= 2)
    if (const std::size_t size = NodeFormat::node_size_for(declaration.layout, page);
        stored == std::to_string(size))
      return NodeFormat(declaration.layout, size);
  refuse(SQLITE_CORRUPT_VTAB, name, "the stored node size '" + stored + "' belongs to no page size");
}

void rename_shadow_tables(sqlite3* db, const QualifiedName& name, const std::string& new_table,
                          const Declaration& declaration) {
  for (const char* suffix : suffixes_of(declaration))
    execute(db, format_sql("ALTER TABLE \"%w\".\"%w_%s\" RENAME TO \"%w_%s\"", name.schema.c_str(),
                           name.table.c_str(), suffix, new_table.c_str(), suffix));
}

void drop_shadow_tables(sqlite3* db, const QualifiedName& name, const Declaration& declaration) {
  for (const char* suffix : suffixes_of(declaration))
    execute(db, format_sql("DROP TABLE IF EXISTS \"%w\".\"%w_%s\"", name.schema.c_str(), name.table.c_str(),
                           suffix));
}

}  // namespace foresee
