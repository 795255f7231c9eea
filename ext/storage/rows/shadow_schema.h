// Schema of the shadow tables of a moving_objects table, and what their `_meta` says about the format.
//
//   <name>_node(nodeno INTEGER PRIMARY KEY, data BLOB)                 leaves and inner nodes
//   <name>_map(id INTEGER PRIMARY KEY, leaf INTEGER)                   the leaves of 64 ids per row (id_map_rows.h)
//   <name>_aux(id INTEGER PRIMARY KEY, a0, a1, …)                      only with auxiliary columns
//   <name>_shape(number INTEGER PRIMARY KEY, hash, data BLOB)          only with outlines or meshes (shape_rows.h)
//   <name>_leg(number INTEGER PRIMARY KEY, data BLOB)                  only with plans (blob_rows.h)
//   <name>_chunknode, <name>_chunkmap                                  the tree of their chunks, as node and map
//   <name>_meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID             see below
//
// `format` in _meta is the version of the format, `columns` the columns as declared, `root` is 0 in an empty
// table. `stamp` is a random number that every write transaction replaces. `objects` is the number of
// objects, `features` a list of what version 0.1 does not know (format/features.h); version 0.1 has neither
// key. `origin` is the origin of a table in degrees, once it has one: its latitude and longitude as text. The
// others are `node_size`, `horizon`, and `chunk_root` of a table with plans.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "database/meta_rows.h"
#include "database/shadow_tables.h"
#include "format/declaration.h"
#include "format/node_format.h"

namespace foresee {

/// True for node, map, aux, meta, shape, leg, chunknode and chunkmap: the suffixes after `<name>_` of a shadow table's
/// name. None has an underscore: SQLite looks at what follows the last one.
bool is_shadow_suffix(std::string_view suffix);

/// The columns of the record in their order, then the auxiliary ones: the value of `columns` in _meta.
std::string describe_columns(const Declaration& declaration);

/// The shadow tables of a table with this declaration.
ShadowTables shadow_tables(sqlite3* db, const QualifiedName& name, const Declaration& declaration);

/// Creates the shadow tables of a new, empty table and returns its node format.
NodeFormat create_shadow_tables(sqlite3* db, const QualifiedName& name, const Declaration& declaration);

/// Returns the node format of an existing table; `meta` are its rows. Throws StoreError if the shadow tables
/// were written for another declaration or by an unknown version of foresee, or if one of them is not an
/// ordinary table. Cost: two statements to compile, and four look-ups in _meta.
NodeFormat read_node_format(const ShadowTables& tables, MetaRows& meta, const Declaration& declaration);

/// The stored number of objects; nothing if it is missing or out of range. It may be wrong in a damaged file:
/// only the query planner uses it, and the commit that updates it.
std::optional<std::int64_t> read_object_count(MetaRows& meta);

/// Throws StoreError if an existing table was written with a feature that this version of foresee does not
/// know. Call it for a declaration that cannot be parsed: the feature explains why.
void refuse_unknown_features(sqlite3* db, const QualifiedName& name);

}  // namespace foresee
