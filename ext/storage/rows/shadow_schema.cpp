#include "storage/rows/shadow_schema.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "database/blob_rows.h"
#include "database/sqlite_api.h"
#include "database/value_text.h"
#include "format/features.h"
#include "shape/shapes.h"
#include "storage/rows/shape_rows.h"
#include "storage/rows/tree_rows.h"

namespace foresee {
namespace {

constexpr std::array<const char*, 8> suffixes{"node",  "map", "meta",      "aux",
                                              "shape", "leg", "chunknode", "chunkmap"};

std::int64_t page_size(sqlite3* db, const QualifiedName& name) {
  Statement statement(db, format_sql("PRAGMA \"%w\".page_size", name.schema.c_str()));
  Statement::Run run(statement);
  if (!run.step()) throw StoreError(SQLITE_ERROR, "no page size of database " + name.schema);
  return run.integer(0);
}

[[noreturn]] void refuse(int code, const QualifiedName& name, const std::string& what) {
  throw StoreError(code, name.table + ": " + what);
}

void require_known_features(MetaRows& meta, const QualifiedName& name) {
  const std::string unknown = unknown_feature(meta.read("features", max_features));
  if (!unknown.empty())
    refuse(SQLITE_ERROR, name,
           "written with '" + without_nul(unknown) + "', which this foresee does not know: use a newer one");
}

/// The value of `origin` in _meta that CREATE writes, or "".
std::string declared_origin(const Frame& frame) {
  if (frame.on_globe()) return "globe";
  return frame.origin ? origin_text(*frame.origin) : "";
}

/// Coordinates are metres from the origin, so another one in the declaration would move every object.
void require_declared_origin(MetaRows& meta, const QualifiedName& name, const Frame& declared) {
  const std::string expected = declared_origin(declared);
  if (expected.empty()) return;
  const std::string stored = meta.read("origin");
  if (stored != expected)
    refuse(SQLITE_CORRUPT_VTAB, name,
           "stored with the origin '" + without_nul(stored) + "' but declared with '" + expected + "'");
}

/// The globe has three axes, whether or not z is declared.
int declared_axes(const Declaration& declaration) {
  const auto& columns = declaration.columns;
  const bool has_height = std::any_of(columns.begin(), columns.end(), [](const MotionColumn& column) {
    return column.geo == GeoColumn::height;
  });
  return declaration.frame.on_globe() && !has_height ? 2 : declaration.layout.axes;
}

}  // namespace

bool is_shadow_suffix(std::string_view suffix) {
  return is_one_of(suffix, suffixes);
}

ShadowTables shadow_tables(sqlite3* db, const QualifiedName& name, const Declaration& declaration) {
  std::vector<ShadowTable> tables = TreeRows::tables();
  tables.push_back(MetaRows::table());
  if (!declaration.auxiliaries.empty()) {
    std::string definition = "(id INTEGER PRIMARY KEY";
    for (std::size_t i = 0; i < declaration.auxiliaries.size(); ++i) definition += ", a" + std::to_string(i);
    tables.push_back({"aux", definition + ")"});
  }
  if (is_stored_apart(declaration.layout.shape)) tables.push_back(ShapeRows::table());
  if (declaration.layout.has_plan) {
    tables.push_back(BlobRows::table("leg", "number"));
    for (ShadowTable& table : TreeRows::tables("chunk")) tables.push_back(std::move(table));
  }
  return {db, name, std::move(tables)};
}

std::string describe_columns(const Declaration& declaration) {
  const Layout& layout = declaration.layout;
  const int axes = declared_axes(declaration);
  std::string text = "id";
  auto on_all_axes = [&](const char* prefix, int first = 0) {
    for (int axis = first; axis < axes; ++axis) text += std::string(", ") + prefix + "xyz"[axis];
  };
  const bool in_degrees = declaration.frame.in_degrees();
  const int first = in_degrees ? 2 : 0;
  if (layout.has_t) text += ", t";
  if (in_degrees && !declaration.has_zones()) text += ", lat, lon";
  on_all_axes("", first);
  if (in_degrees && layout.law != Law::rest) text += ", speed, course";
  if (layout.law != Law::rest) on_all_axes("v", first);
  if (layout.law == Law::accelerated && !declaration.frame.on_globe()) on_all_axes("a");
  if (layout.law == Law::forced) {
    on_all_axes("f");
    text += ", m";
  }
  for_each_size(layout, [&](const SizeColumn& column) {
    column.on_all_axes ? on_all_axes(column.name)
                       : static_cast<void>(text += std::string(", ") + column.name);
  });
  if (is_stored_apart(layout.shape)) text += declaration.has_zones() ? ", zone" : ", shape";
  if (layout.has_heading) text += ", heading";
  if (layout.has_until) text += ", until";
  if (layout.has_category) text += ", category";
  if (layout.has_mask) text += ", mask";
  if (layout.has_plan) text += ", plan";
  for (const AuxiliaryColumn& column : declaration.auxiliaries) text += ", +" + column.name;
  return text;
}

NodeFormat create_shadow_tables(sqlite3* db, const QualifiedName& name, const Declaration& declaration) {
  const auto page = static_cast<std::size_t>(page_size(db, name));
  const NodeFormat format(declaration.layout, NodeFormat::node_size_for(declaration.layout, page));
  const ShadowTables tables = shadow_tables(db, name, declaration);
  tables.create();
  std::int64_t stamp;
  sqlite3_randomness(sizeof stamp, &stamp);
  MetaRows meta(tables);
  meta.write("format", std::int64_t{NodeFormat::version});
  meta.write("columns", describe_columns(declaration));
  meta.write("node_size", static_cast<std::int64_t>(format.node_size));
  meta.write("horizon", declaration.horizon);
  meta.write("root", std::int64_t{0});
  if (declaration.layout.has_plan) meta.write("chunk_root", std::int64_t{0});
  meta.write("stamp", stamp);
  meta.write("objects", std::int64_t{0});
  meta.write("features", features_of(declaration));
  if (const std::string origin = declared_origin(declaration.frame); !origin.empty())
    meta.write("origin", origin);
  return format;
}

std::optional<std::int64_t> read_object_count(MetaRows& meta) {
  constexpr std::int64_t limit = std::int64_t{1} << 53;
  const std::optional<std::int64_t> stored = meta.read_integer("objects");
  return stored && 0 <= *stored && *stored <= limit ? stored : std::nullopt;
}

void refuse_unknown_features(sqlite3* db, const QualifiedName& name) {
  const ShadowTables only_meta(db, name, {MetaRows::table()});
  only_meta.require_tables();
  MetaRows meta(only_meta);
  require_known_features(meta, name);
}

NodeFormat read_node_format(const ShadowTables& tables, MetaRows& meta, const Declaration& declaration) {
  tables.require_tables();
  const QualifiedName& name = tables.name();
  const std::string version = std::to_string(NodeFormat::version), format = meta.read("format");
  if (format != version)
    refuse(SQLITE_ERROR, name,
           "stored in format '" + without_nul(format) + "', this foresee reads " + version +
               "; with the version that wrote it, copy it into an ordinary table, then insert that into a "
               "new one");
  require_known_features(meta, name);
  const std::string declared = describe_columns(declaration);
  if (const std::string columns = meta.read("columns", 2 * declared.size() + 1000); columns != declared)
    refuse(SQLITE_CORRUPT_VTAB, name,
           "stored with the columns (" + columns + ") but declared with (" + declared + ")");
  require_declared_origin(meta, name, declaration.frame);
  const std::string stored = meta.read("node_size");
  std::size_t size = 0;
  std::from_chars(stored.data(), stored.data() + stored.size(), size);
  if (stored == std::to_string(size) && NodeFormat::page_size_for(declaration.layout, size))
    return NodeFormat(declaration.layout, size);
  refuse(SQLITE_CORRUPT_VTAB, name, "the stored node size '" + stored + "' belongs to no page size");
}

}  // namespace foresee
