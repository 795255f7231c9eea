// Entry point of the extension: registers everything that `.load foresee` provides.
#include "database/statement.h"
#include "sqlite/callback.h"
#include "sqlite/foresee.h"
#include "sqlite/host_sqlite.h"
#include "sqlite/modules.h"

// The one name that the module exports. Windows exports every name of a DLL unless one is marked.
#ifdef _WIN32
#define FORESEE_EXPORT __declspec(dllexport)
#else
#define FORESEE_EXPORT __attribute__((visibility("default")))
#endif

namespace foresee {
namespace {

/// Reads no schema: an encrypted file may not have its key yet.
bool is_registered(sqlite3* db) {
  Statement modules(db, "PRAGMA module_list");
  for (Statement::Run run(modules); run.step();)
    if (run.text(0) == "predictive_join") return true;
  return false;
}

}  // namespace

extern "C" FORESEE_EXPORT int sqlite3_foresee_init(sqlite3* db, char** message,
                                                   const sqlite3_api_routines* api) {
  if (api != nullptr) sqlite3_api = api;
  return guarded(message, [db] {
    require_version(sqlite3_libversion_number(), sqlite3_libversion());
    // A second registration would know nothing of the tables that are connected already.
    if (is_registered(db)) return SQLITE_OK;
    const auto connection = std::make_shared<Connection>(db);
    int rc = register_scalars(db);
    if (rc == SQLITE_OK) rc = register_moving_objects(db, connection);
    if (rc == SQLITE_OK) rc = register_predictive_watch(db, connection);
    if (rc == SQLITE_OK) rc = register_table_functions(db, connection);
    return rc;
  });
}

}  // namespace foresee
