// Which tables hold a moving_objects table, and what do they say about themselves?
//
//   <name>_node(nodeno INTEGER PRIMARY KEY, data BLOB)                 leaves and inner nodes
//   <name>_map(id INTEGER PRIMARY KEY, leaf INTEGER)                   where each object is (map_rows.h)
//   <name>_aux(id INTEGER PRIMARY KEY, a0, a1, …)                      only with auxiliary columns
//   <name>_shape(number INTEGER PRIMARY KEY, hash, data BLOB)          only with outlines (shape_rows.h)
//   <name>_meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID             see below
//
// _meta: `format` version of all this, `columns` as declared, `node_size`, `horizon`, `root` (0: there are no
// objects), `stamp` (random, rewritten by every write transaction), `objects` how many there are and
// `features` what the table has that version 0.1 did not know (format/features.h); that version wrote
// neither.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "storage/format/declaration.h"
#include "storage/format/node_format.h"
#include "storage/rows/meta_rows.h"
#include "storage/rows/shadow_tables.h"

namespace foresee {

/// True for node, map, aux, meta and shape: what stands behind `<name>_` in a shadow table's name.
bool is_shadow_suffix(std::string_view suffix);

/// The record's columns in their order, then the auxiliary ones: what `columns` holds in _meta.
std::string describe_columns(const Declaration& declaration);

/// The tables themselves.
ShadowTables shadow_tables(sqlite3* db, const QualifiedName& name, const Declaration& declaration);

/// Makes the shadow tables of a new, empty table and returns its nodes' format.
NodeFormat create_shadow_tables(sqlite3* db, const QualifiedName& name, const Declaration& declaration);

/// The nodes' format of an existing table, of which `meta` are the rows. Throws StoreError if the shadow
/// tables were written for another declaration or by a version of foresee that this one does not understand,
/// or if one of them is no table. Cost: two statements are compiled, and four look-ups in _meta.
NodeFormat read_node_format(const ShadowTables& tables, MetaRows& meta, const Declaration& declaration);

/// How many objects a table says it has; nothing where it does not say, or what no table can have. Believed
/// by nobody but the planner, and by who keeps it.
std::optional<std::int64_t> read_object_count(MetaRows& meta);

/// Throws StoreError if an existing table was written with a feature that this foresee does not know. For a
/// declaration that cannot be read: the feature says why.
void refuse_unknown_features(sqlite3* db, const QualifiedName& name);

}  // namespace foresee
