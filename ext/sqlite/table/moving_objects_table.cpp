#include "sqlite/table/moving_objects_table.h"

#include "sqlite/table/table_declaration.h"
#include "storage/rows/shadow_schema.h"

namespace foresee {

MovingObjectsTable::MovingObjectsTable(std::shared_ptr<Connection> connection_, Declaration declaration,
                                       StoreOrFault store, const std::string& schema_,
                                       const std::string& name_)
    : sqlite3_vtab{},
      connection(std::move(connection_)),
      schema(schema_),
      name(name_),
      reader(declaration, name, connection->interrupt()),
      number(0),
      declared_(std::move(declaration)),
      store_(std::move(store)) {
  number = connection->announce(store_.store, schema, name);
}

MovingObjectsTable::~MovingObjectsTable() {
  connection->leave(number);
  sqlite3_free(zErrMsg);  // a message left over: SQLite 3.40 does not take it from xDestroy
}

void MovingObjectsTable::rename(const std::string& new_name) {
  require_table_name(declaration(), new_name);
  store().rename(new_name);
  name = new_name;
  reader.rename(new_name);
  connection->rename(number, new_name);
}

void MovingObjectsTable::drop() {
  if (store_.store)
    store_.store->drop();
  else
    shadow_tables(connection->db(), {schema, name}, declaration()).drop();
}

}  // namespace foresee
