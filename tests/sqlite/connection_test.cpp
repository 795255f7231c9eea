// Decoded scenes are kept from question to question, as many as have room together.
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
  std::shared_ptr<const Scene> ask(Connection& connection, std::size_t table) {
    return connection.load_scene({stores[table], "main", "", 0});
  }

  static constexpr std::size_t scene_size = 100 * 7 * 8;  // an id and six numbers each
  Database db;
  std::vector<std::shared_ptr<Store>> stores;
};

TEST_F(Scenes, ThatWereUsedLongAgoMakeRoom) {
  Connection connection(db, 2 * scene_size);
  const std::weak_ptr<const Scene> a = ask(connection, 0), b = ask(connection, 1);
  EXPECT_EQ(ask(connection, 0), a.lock());
  ask(connection, 2);
  EXPECT_FALSE(a.expired());
  EXPECT_TRUE(b.expired());
  EXPECT_EQ(ask(connection, 1)->size(), 100u);
  EXPECT_TRUE(a.expired());
}

TEST_F(Scenes, OfATableByItselfIsKeptWhateverItsSize) {
  Connection connection(db, 0);
  const std::weak_ptr<const Scene> a = ask(connection, 0);
  EXPECT_EQ(ask(connection, 0), a.lock());
}

}  // namespace
}  // namespace foresee
