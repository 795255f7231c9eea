#include "sqlite/functions/table_functions.h"

#include "sqlite/modules.h"

namespace foresee {

int register_table_functions(sqlite3* db, const std::shared_ptr<Connection>& connection) {
  for (const TableFunction* function :
       {&predictive_join(), &predictive_explain(), &predictive_window(), &predictive_nearest(),
        &predictive_avoid(), &predictive_position(), &predictive_track(), &predictive_sweep(),
        &geo_to_plane(), &plane_to_geo(), &geo_to_globe(), &globe_to_geo(), &foresee_tables(), &plan_rows()})
    if (const int rc = register_table_function(db, *function, connection); rc != SQLITE_OK) return rc;
  return SQLITE_OK;
}

}  // namespace foresee
