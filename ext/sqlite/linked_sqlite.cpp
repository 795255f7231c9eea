// Table of SQLite's functions for an application that links its own SQLite. A function that is missing in the
// list is a null pointer; the first test that calls it fails.
#define SQLITE_CORE
#include <sqlite3ext.h>

namespace {

constexpr sqlite3_api_routines linked = [] {
  sqlite3_api_routines api{};
  api.aggregate_context = sqlite3_aggregate_context;
  api.bind_blob64 = sqlite3_bind_blob64;
  api.bind_double = sqlite3_bind_double;
  api.bind_int64 = sqlite3_bind_int64;
  api.bind_text64 = sqlite3_bind_text64;
  api.bind_value = sqlite3_bind_value;
  api.clear_bindings = sqlite3_clear_bindings;
  api.close = sqlite3_close;
  api.column_blob = sqlite3_column_blob;
  api.column_bytes = sqlite3_column_bytes;
  api.column_int64 = sqlite3_column_int64;
  api.column_text = sqlite3_column_text;
  api.column_type = sqlite3_column_type;
  api.column_value = sqlite3_column_value;
  api.context_db_handle = sqlite3_context_db_handle;
  api.create_function = sqlite3_create_function;
  api.create_module_v2 = sqlite3_create_module_v2;
  api.db_name = sqlite3_db_name;
  api.declare_vtab = sqlite3_declare_vtab;
  api.errmsg = sqlite3_errmsg;
  api.exec = sqlite3_exec;
  api.extended_errcode = sqlite3_extended_errcode;
  api.finalize = sqlite3_finalize;
  api.free = sqlite3_free;
  api.last_insert_rowid = sqlite3_last_insert_rowid;
  api.libversion = sqlite3_libversion;
  api.libversion_number = sqlite3_libversion_number;
  api.limit = sqlite3_limit;
  api.log = sqlite3_log;
  api.mprintf = sqlite3_mprintf;
  api.next_stmt = sqlite3_next_stmt;
  api.open = sqlite3_open;
  api.prepare_v3 = sqlite3_prepare_v3;
  api.randomness = sqlite3_randomness;
  api.reset = sqlite3_reset;
  api.result_blob = sqlite3_result_blob;
  api.result_blob64 = sqlite3_result_blob64;
  api.result_double = sqlite3_result_double;
  api.result_error = sqlite3_result_error;
  api.result_error_code = sqlite3_result_error_code;
  api.result_error_nomem = sqlite3_result_error_nomem;
  api.result_int64 = sqlite3_result_int64;
  api.result_null = sqlite3_result_null;
  api.result_text = sqlite3_result_text;
  api.result_text64 = sqlite3_result_text64;
  api.result_value = sqlite3_result_value;
  api.set_last_insert_rowid = sqlite3_set_last_insert_rowid;
  api.sql = sqlite3_sql;
  api.step = sqlite3_step;
  api.stmt_status = sqlite3_stmt_status;
  api.stricmp = sqlite3_stricmp;
  api.strnicmp = sqlite3_strnicmp;
  api.table_column_metadata = sqlite3_table_column_metadata;
  api.value_blob = sqlite3_value_blob;
  api.value_bytes = sqlite3_value_bytes;
  api.value_double = sqlite3_value_double;
  api.value_dup = sqlite3_value_dup;
  api.value_free = sqlite3_value_free;
  api.value_int64 = sqlite3_value_int64;
  api.value_nochange = sqlite3_value_nochange;
  api.value_numeric_type = sqlite3_value_numeric_type;
  api.value_text = sqlite3_value_text;
  api.value_type = sqlite3_value_type;
  api.vmprintf = sqlite3_vmprintf;
  api.vtab_config = sqlite3_vtab_config;
  api.vtab_in = sqlite3_vtab_in;
  api.vtab_nochange = sqlite3_vtab_nochange;
  api.vtab_on_conflict = sqlite3_vtab_on_conflict;
  api.vtab_rhs_value = sqlite3_vtab_rhs_value;
  return api;
}();

}  // namespace

extern const sqlite3_api_routines* sqlite3_api;
constinit const sqlite3_api_routines* sqlite3_api = &linked;
