// Scenes that a connection caches: a decoded scene is reused by later queries while the cache has space for
// it.
#include "sqlite/connection.h"

#include "storage/database.h"

namespace foresee {
namespace {

class Scenes : public ::testing::Test {
 protected:
  Scenes() {
    for (const std::string name : {"a", "b", "c"}) {
      auto store = make_store(db, ships(), name);
      begin(db, *store);
      for (int id = 1; id <= 100; ++id) store->insert(id, ship(id), {});
      commit(db, *store);
      stores.push_back(store);
    }
  }
  std::shared_ptr<const Scene> load(Connection& connection, std::size_t table) {
    return connection.load_scene({stores[table], "main", "", 0});
  }

  static constexpr std::size_t scene_size = 100 * 7 * 8;  // an id and six numbers each
  Database db;
  std::vector<std::shared_ptr<Store>> stores;
};

TEST_F(Scenes, UsedLongAgoAreEvicted) {
  Connection connection(db, 2 * scene_size);
  const std::weak_ptr<const Scene> a = load(connection, 0), b = load(connection, 1);
  EXPECT_EQ(load(connection, 0), a.lock());
  load(connection, 2);
  EXPECT_FALSE(a.expired());
  EXPECT_TRUE(b.expired());
  EXPECT_EQ(load(connection, 1)->size(), 100u);
  EXPECT_TRUE(a.expired());
}

TEST_F(Scenes, OfASingleTableAreKeptWhateverTheirSize) {
  Connection connection(db, 0);
  const std::weak_ptr<const Scene> a = load(connection, 0);
  EXPECT_EQ(load(connection, 0), a.lock());
}

}  // namespace
}  // namespace foresee
