// Nodes that are sound alone, with correct checksums, and contradict one another: integrity-check names each
// fault, and 'rebuild' repairs all that does not damage a leaf.
#include <algorithm>
#include <numeric>

#include "format/inner_node.h"
#include "format/leaf_node.h"
#include "storage/database.h"

namespace foresee {
namespace {

class TreeDamage : public ::testing::Test {
 protected:
  /// `kinds`: category and mask of all objects, if the table declares them.
  explicit TreeDamage(const Declaration& declared = ships(), const std::vector<double>& kinds = {})
      : format(declared.layout, 4032), store(make_store(db, declared)) {
    begin(db, *store);
    for (int id = 1; id <= 3000; ++id) {
      std::vector<double> record = ship(id);
      record.insert(record.end(), kinds.begin(), kinds.end());
      store->insert(id, record, {});
    }
    commit(db, *store);
    root = db.number("SELECT value FROM ships_meta WHERE key = 'root'");
  }

  Node node(std::int64_t number) {
    Statement select(db, "SELECT data FROM ships_node WHERE nodeno = ?");
    Statement::Run run(select);
    run.bind(1, number);
    EXPECT_TRUE(run.step());
    const auto blob = run.blob(0);
    return blob[NodeFormat::level_at] == std::byte{0} ? decode_leaf(format, blob)
                                                      : decode_inner(format, blob);
  }
  void write(std::int64_t number, const Node& node) {
    const auto blob = node.is_leaf() ? encode_leaf(format, number, node) : encode_inner(format, number, node);
    Statement insert(db, "INSERT OR REPLACE INTO ships_node VALUES(?, ?)");
    Statement::Run run(insert);
    run.bind(1, number);
    run.bind(2, std::span<const std::byte>(blob));
    run.step();
  }
  template <class Change>
  void change(std::int64_t number, Change change_node) {
    Node changed = node(number);
    change_node(changed);
    write(number, changed);
  }
  /// integrity-check reports it; rebuild repairs it, and nothing is lost.
  void expect_found_and_repaired(const std::string& words) {
    db.run("UPDATE ships_meta SET value = random() WHERE key = 'stamp'");
    const std::vector<std::string> found = faults(*store);
    EXPECT_TRUE(std::ranges::any_of(
        found, [&](const std::string& fault) { return fault.find(words) != std::string::npos; }))
        << words << ", found: " << (found.empty() ? "nothing" : found.front());
    begin(db, *store);
    expect_store_error(SQLITE_CORRUPT_VTAB, "", [&] { store->optimize(never); });
    store->rebuild(never);
    commit(db, *store);
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
    EXPECT_EQ(contents(*store).size(), 3000u);
  }

  NeverInterrupt never;
  Database db;
  NodeFormat format;
  std::shared_ptr<Store> store;
  std::int64_t root = 0;
};

TEST_F(TreeDamage, BoundsThatDoNotContainWhatIsBelow) {
  constexpr std::size_t first_bound = 3;
  for (const std::size_t bound : {0, 2, 4, 6}) {  // lower x, upper x, lower vx, upper vx
    change(root, [&](Node& n) {
      n.values[first_bound + bound] = n.values[first_bound + bound] + (bound % 4 == 0 ? 0.1 : -0.1);
      const std::size_t other = first_bound + (bound ^ 2);
      if (bound % 4 == 0) n.values[other] = std::max(n.values[other], n.values[first_bound + bound]);
      if (bound % 4 != 0) n.values[other] = std::min(n.values[other], n.values[first_bound + bound]);
    });
    expect_found_and_repaired("which an entry above does not contain");
    root = db.number("SELECT value FROM ships_meta WHERE key = 'root'");
  }
}

Declaration ships_with_kinds() {
  Declaration declaration = ships();
  declaration.layout.has_category = declaration.layout.has_mask = true;
  return declaration;
}

class KindsDamage : public TreeDamage {
 protected:
  KindsDamage() : TreeDamage(ships_with_kinds(), {6, 12}) {}
};

TEST_F(KindsDamage, KindsThatDoNotContainWhatIsBelow) {
  EXPECT_EQ(kinds_at(node(root), 0), (Kinds{6, 12}));
  for (const Kinds wrong : {Kinds{2, 12}, Kinds{6, 8}, Kinds{}, Kinds::none()}) {
    change(root, [&](Node& n) { set_kinds(n, 0, wrong); });
    expect_found_and_repaired("which an entry above does not contain");
    root = db.number("SELECT value FROM ships_meta WHERE key = 'root'");
    EXPECT_EQ(kinds_at(node(root), 0), (Kinds{6, 12}));
  }
}

TEST_F(KindsDamage, ACategoryThatIsNotAWholeNumber) {
  const NodeNumber leaf = node(node(root).keys[0]).keys[0];
  change(leaf, [](Node& n) { n.values[6] = 1.5; });
  db.run("UPDATE ships_meta SET value = random() WHERE key = 'stamp'");
  expect_store_error(SQLITE_CORRUPT_VTAB, "a category is not a whole number", [&] { contents(*store); });
}

TEST_F(TreeDamage, TimesThatDoNotContainWhatIsBelow) {
  change(root, [](Node& n) {
    n.values[0] = 100.5;
    n.values[1] = 101;
  });
  expect_found_and_repaired("has another greatest t than its entry");
  root = db.number("SELECT value FROM ships_meta WHERE key = 'root'");
  change(root, [](Node& n) { n.values[2] = 1000; });
  expect_found_and_repaired("which an entry above does not contain");
}

TEST_F(TreeDamage, AParentThatIsNotTheParent) {
  change(1, [](Node& n) { n.parent = 2; });
  expect_found_and_repaired("node 1: names a parent that is not its own");
}

TEST_F(TreeDamage, AChildReachedTwice) {
  change(root, [](Node& n) { n.keys[1] = n.keys[0]; });
  expect_found_and_repaired("a child is named twice");
  root = db.number("SELECT value FROM ships_meta WHERE key = 'root'");
  const NodeNumber shared = node(node(root).keys[0]).keys[0];
  change(node(root).keys[1], [&](Node& n) { n.keys[0] = shared; });
  expect_found_and_repaired("is reached twice");
}

TEST_F(TreeDamage, AChildThatIsMissing) {
  change(root, [](Node& n) { n.keys[1] = 4444; });
  expect_found_and_repaired("node 4444 is missing");
}

TEST_F(TreeDamage, AChildOfTheWrongLevel) {
  change(root, [&](Node& n) { n.level += 1; });
  expect_found_and_repaired("has level");
}

TEST_F(TreeDamage, AnUnreachableNode) {
  change(node(root).keys[0], [](Node& n) {
    n.keys.pop_back();
    n.values.resize(n.values.size() - static_cast<std::size_t>(entry_size(2)));
  });
  expect_found_and_repaired("nodes that are not part of the tree");
}

TEST_F(TreeDamage, ARootThatIsNotTheRoot) {
  for (const char* other : {"0", "1", "777777"}) {
    db.run(std::string("UPDATE ships_meta SET value = ") + other + " WHERE key = 'root'");
    expect_found_and_repaired("");
  }
  for (const char* other : {"-1", "'text'", "NULL"}) {
    db.run(std::string("UPDATE ships_meta SET value = ") + other + " WHERE key = 'root'");
    expect_found_and_repaired("the root is not a node");
  }
}

TEST_F(TreeDamage, NoRootDemandsAnEmptyMap) {
  db.run("UPDATE ships_meta SET value = 0 WHERE key = 'root'");
  store = nullptr;
  store = Store::open(db, "main", "ships", ships());
  expect_store_error(SQLITE_CORRUPT_VTAB, "ships: there is no root, but the map has objects",
                     [&] { store->take_snapshot(); });
  expect_store_error(SQLITE_CORRUPT_VTAB, "ships: there is no root", [&] { store->read_newest_t(); });
  expect_found_and_repaired("there is no root");
}

TEST_F(TreeDamage, NoObjectsMoveIntoALeafThatIsAnInnerNode) {
  const NodeNumber first = node(root).keys[0], other = node(root).keys[1];
  change(first, [&](Node& n) {
    n.keys = {n.keys[0], other};
    n.values.resize(2 * static_cast<std::size_t>(entry_size(2)));
  });
  db.run("UPDATE ships_meta SET value = random() WHERE key = 'stamp'");
  const std::vector<double> record = *store->read(node(node(first).keys[0]).keys[0]);
  begin(db, *store);
  for (int id = 9000; id < 9060; ++id) store->insert(id, record, {});
  expect_store_error(SQLITE_CORRUPT_VTAB, "ships: ", [&] { store->take_snapshot(); });
  roll_back(db, *store);
}

TEST_F(TreeDamage, ReadersAndWritersGetAnErrorAndChangeNothing) {
  change(root, [](Node& n) { std::iota(n.keys.begin(), n.keys.end(), 4444); });
  db.run("UPDATE ships_meta SET value = random() WHERE key = 'stamp'");
  const auto before = contents(*store);
  begin(db, *store);
  // A few objects are inserted one at a time, many together.
  for (int last : {1, 3000}) {
    for (int id = 1; id <= last; id += 50) store->update(id, id, ship(-9e9), {});
    store->insert(9000 + last, ship(1), {});
    expect_store_error(SQLITE_CORRUPT_VTAB, "ships: ", [&] { contents(*store); });
    expect_store_error(SQLITE_CORRUPT_VTAB, "ships: ", [&] { store->take_snapshot(); });
    expect_store_error(SQLITE_CORRUPT_VTAB, "ships: ", [&] { store->sync(); });
  }
  roll_back(db, *store);
  EXPECT_EQ(contents(*store), before);
}

}  // namespace
}  // namespace foresee
