#include "sqlite/modules.h"

namespace foresee::sqlite {
namespace {

using Holder = std::shared_ptr<Connection>;

void release(void* holder) {
  delete static_cast<Holder*>(holder);
}

}  // namespace

int register_module(sqlite3* db, const char* name, const sqlite3_module* module,
                    const std::shared_ptr<Connection>& connection) {
  // SQLite calls release() also when it fails.
  return sqlite3_create_module_v2(db, name, module, new Holder(connection), release);
}

const std::shared_ptr<Connection>& connection_of(void* aux) {
  return *static_cast<Holder*>(aux);
}

}  // namespace foresee::sqlite
