// After a large load: look-ups of stored ids and of new ids (database/id_filter.h).
#include "storage/table/partitioned_table.h"

namespace foresee {
namespace {

class NewIds : public Partitioned {
 protected:
  NewIds() {
    load();
    for (std::int64_t id = -320; id < 12'000; id += 3) queried.push_back(id);
    begin(db, *store);
    store->rebuild(never);
  }
  void expect_known() {
    for (const std::int64_t id : queried) ASSERT_EQ(store->contains(id), model.contains(id)) << id;
    expect_model();
  }
  /// An id that is not stored.
  std::int64_t new_id() {
    std::int64_t id = 0;
    do id = static_cast<std::int64_t>(random() % 12'000) - 320;
    while (model.contains(id));
    return id;
  }
  /// So few that they are merged into the existing tree.
  void insert_some() {
    for (int i = 0; i < 300; ++i) insert(new_id());
    store->sync();
  }
  void erase_some() {
    for (int i = 0; i < 100; ++i)
      erase(std::next(model.begin(), static_cast<int>(random() % model.size()))->first);
    store->sync();
  }

  std::vector<std::int64_t> queried;
};

TEST_F(NewIds, AreDistinguishedFromInsertedAndDeletedOnes) {
  expect_known();
  for (int round = 0; round < 4; ++round) {
    insert_some();
    expect_known();
    erase_some();
    expect_known();
    commit(db, *store);
    begin(db, *store);
  }
  store->rebuild(never);
  expect_known();
}

TEST_F(NewIds, AreThoseOfTheSavepointRolledBackTo) {
  insert_some();
  const Model before = model;
  open_savepoint(db, *store, 0);
  for (int round = 0; round < 2; ++round) {
    erase_some();
    store->rebuild(never);  // deleted ids are in no list any more
    insert_some();
    expect_known();
    roll_back_to(db, *store, 0);
    model = before;
    expect_known();
  }
}

TEST_F(NewIds, AreThoseBeforeTheTransactionThatIsRolledBack) {
  commit(db, *store);
  const Model before = model;
  begin(db, *store);
  erase_some();
  store->rebuild(never);
  roll_back(db, *store);
  model = before;
  expect_known();
}

TEST_F(NewIds, AreNotThoseOfAnotherConnection) {
  commit(db, *store);
  const std::int64_t id = new_id();
  const auto other = store_within(little);
  begin(db, *other);
  other->insert(id, scattered(model[id] = 5), {});
  commit(db, *other);
  begin(db, *store);
  EXPECT_TRUE(store->contains(id));
  expect_known();
}

}  // namespace
}  // namespace foresee
