#include "sqlite/table.h"

#include "sqlite/declare.h"

namespace foresee {

Table::Table(std::shared_ptr<Connection> connection_, std::shared_ptr<ObjectStore> store_,
             const std::string& schema, const std::string& name_)
    : sqlite3_vtab{},
      connection(std::move(connection_)),
      store(std::move(store_)),
      name(name_),
      values(store->declaration(), name),
      number(connection->announce(store.get(), schema, name)) {}

Table::~Table() {
  connection->leave(number);
}

void Table::rename(const std::string& new_name) {
  require_table_name(declaration(), new_name);
  store->rename(new_name);
  name = new_name;
  values.rename(new_name);
  connection->rename(number, new_name);
}

}  // namespace foresee
