// Fixture: a table whose objects exceed the memory for sorting, and a plain map of its expected contents.
#pragma once

#include <algorithm>
#include <map>
#include <random>

#include "storage/database.h"
#include "storage/rows/shadow_schema.h"
#include "storage/table/store.h"

namespace foresee {

using Model = std::map<std::int64_t, double>;

class Partitioned : public ::testing::Test {
 protected:
  static constexpr int objects =
      4000;  // records of 48 bytes: about 24 partitions, and 12 times the limit of unwritten bytes

  static constexpr MemoryLimits little{
      .pending = 40'000, .memory = 40'000, .waiting = 16'000, .ordered = 8'000};

  Partitioned() { open(little); }

  void open(const MemoryLimits& limits) {
    db.run("BEGIN IMMEDIATE");
    format = create_shadow_tables(db, name(), ships());
    store = store_within(limits);
    commit(db, *store);
  }
  /// Another store of the same rows.
  std::shared_ptr<Store> store_within(const MemoryLimits& limits) {
    auto rows = std::make_unique<ShadowRows>(shadow_tables(db, name(), ships()), ships());
    return std::make_shared<Store>(db, name(), ships(), format, std::move(rows), true,
                                   std::make_shared<MemoryBudget>(limits));
  }
  static const QualifiedName& name() {
    static const QualifiedName ships{"main", "ships"};
    return ships;
  }
  std::vector<double> scattered(double mark) {
    return {100 + random() % 50 / 10.0, mark,
            random() % 1000 / 1.0,      random() % 20 - 10.0,
            random() % 20 - 10.0,       random() % 500 == 0 ? 90.0 : 1.0};
  }
  void insert(std::int64_t id) {
    store->insert(id, scattered(model[id] = static_cast<double>(random() % 999)), {});
  }
  void update(std::int64_t id) {
    store->update(id, id, scattered(model[id] = static_cast<double>(random() % 999)), {});
  }
  void erase(std::int64_t id) {
    store->erase(id);
    model.erase(id);
  }
  /// Ids in no order; some blocks of the map are full, others are not.
  void load(int count = objects) {
    begin(db, *store);
    for (int i = 1; i <= count; ++i) insert((i * 7919LL) % 10'007 - 300);
    commit(db, *store);
  }
  void expect_model() {
    const auto found = contents(*store);
    EXPECT_TRUE(std::equal(found.begin(), found.end(), model.begin(), model.end(),
                           [](auto& a, auto& b) { return a.first == b.first && a.second == b.second; }));
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
  }

  Database db;
  NodeFormat format;
  std::shared_ptr<Store> store;
  Model model;
  std::mt19937 random{7};
  NeverInterrupt never;
};

}  // namespace foresee
