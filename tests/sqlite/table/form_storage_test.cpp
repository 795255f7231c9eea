// Storage of outlines and meshes: shared by content, written in the same transaction as the rows that
// reference them, checked when read.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct Outlines {
  static constexpr const char* kind = "outline";
  static constexpr const char* create =
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, shape, heading, r);";
  static constexpr const char *place = "t, x, y", *origin = "0, 0, 0";

  /// A square of this size.
  static std::string shape(int size) {
    const std::string s = std::to_string(size);
    return "POLYGON((0 0, " + s + " 0, " + s + " " + s + ", 0 " + s + ", 0 0))";
  }
  static std::string shape_one_in_other_words() { return " polygon((0 0,1 0,1 1,0 1.0,0 0))"; }
  /// Damage to this kind of form, and its error.
  static std::pair<std::string, std::string> damage() {
    return {"UPDATE ships_shape SET number = number + 10", "outline 1"};
  }
};

struct Meshes {
  static constexpr const char* kind = "mesh";
  static constexpr const char* create =
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, z, shape, heading, r);";
  static constexpr const char *place = "t, x, y, z", *origin = "0, 0, 0, 0";

  /// A tetrahedron of this size.
  static std::string shape(int size) {
    const std::string s = std::to_string(size);
    const std::string o = "0 0 0", x = s + " 0 0", y = "0 " + s + " 0", z = "0 0 " + s;
    const auto face = [](const std::string& a, const std::string& b, const std::string& c) {
      return "((" + a + ", " + b + ", " + c + ", " + a + "))";
    };
    return "POLYHEDRALSURFACE Z(" + face(o, y, x) + ", " + face(o, x, z) + ", " + face(o, z, y) + ", " +
           face(x, y, z) + ")";
  }
  static std::string shape_one_in_other_words() { return " polyhedralsurface  z" + shape(1).substr(19); }
  /// The blob of an outline, with a valid checksum.
  static std::pair<std::string, std::string> damage() {
    return {
        "CREATE VIRTUAL TABLE s USING moving_objects(id, x, y, shape);"
        "INSERT INTO s VALUES(1, 0, 0, 'POLYGON((0 0, 4 0, 0 3, 0 0))');"
        "UPDATE ships_shape SET (hash, data) = (SELECT hash, data FROM s_shape) WHERE number = 1",
        "mesh 1 is damaged: its format or kind is not known"};
  }
};

template <class Kind>
struct FormStorage : ::testing::Test {
  const std::string create = Kind::create;

  static std::string shape(int size) { return Kind::shape(size); }
  static std::string insert(int id, const std::string& shape, int heading = 0) {
    return "INSERT INTO ships(id, " + std::string(Kind::place) + ", shape, heading) VALUES(" +
           std::to_string(id) + ", " + Kind::origin + ", '" + shape + "', " + std::to_string(heading) + ");";
  }
  static std::string insert(int id, int size, int heading = 0) { return insert(id, shape(size), heading); }
  static std::string stored(Database& db) { return db.rows("SELECT count(*) FROM ships_shape"); }
};

/// The number of rows of a window without bounds, if `meanwhile` is executed after its first row.
int rows_of_window(Database& db, const std::string& meanwhile) {
  sqlite3_stmt* window = nullptr;
  const char* query = "SELECT id FROM predictive_window(0, 'ships')";
  EXPECT_EQ(sqlite3_prepare_v2(db.handle(), query, -1, &window, nullptr), SQLITE_OK);
  EXPECT_EQ(sqlite3_step(window), SQLITE_ROW);
  db.exec(meanwhile);
  int rows = 1;
  while (sqlite3_step(window) == SQLITE_ROW) ++rows;
  EXPECT_EQ(sqlite3_finalize(window), SQLITE_OK) << sqlite3_errmsg(db.handle());
  return rows;
}

struct KindNames {
  template <class Kind>
  static std::string GetName(int) {
    return Kind::kind;
  }
};
using Kinds = ::testing::Types<Outlines, Meshes>;
TYPED_TEST_SUITE(FormStorage, Kinds, KindNames);

TYPED_TEST(FormStorage, EqualContentIsStoredOnce) {
  Database db;
  db.exec(this->create);
  for (int id = 1; id <= 100; ++id) db.exec(this->insert(id, id % 3 + 1, id));
  EXPECT_EQ(this->stored(db), "3");
  db.exec(this->insert(999, TypeParam::shape_one_in_other_words()));
  EXPECT_EQ(this->stored(db), "3");
  db.exec("UPDATE ships SET heading = id % 360");
  EXPECT_EQ(this->stored(db), "3");
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TYPED_TEST(FormStorage, ARolledBackFormIsStoredWhenItIsInsertedAgain) {
  Database db;
  db.exec(this->create);
  db.exec("BEGIN;" + this->insert(1, 1) + "ROLLBACK;" + this->insert(1, 1));
  EXPECT_EQ(this->stored(db), "1");
  db.exec("BEGIN;" + this->insert(2, 2) + "SAVEPOINT a;" + this->insert(3, 3) + "ROLLBACK TO a;" +
          this->insert(4, 4) + this->insert(3, 3) + "RELEASE a; COMMIT");
  EXPECT_EQ(
      db.rows("SELECT id, shape FROM ships ORDER BY id"),
      "1|" + this->shape(1) + "\n2|" + this->shape(2) + "\n3|" + this->shape(3) + "\n4|" + this->shape(4));
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TYPED_TEST(FormStorage, AStatementThatFailsLeavesNone) {
  Database db;
  db.exec(this->create + this->insert(1, 1));
  db.exec("CREATE TABLE feed(id, shape)");
  db.exec("INSERT INTO feed VALUES(5, '" + this->shape(5) + "'), (6, '" + this->shape(6) + "'), (1, '" +
          this->shape(7) + "')");
  const std::string place = TypeParam::place, origin = TypeParam::origin;
  const std::string all = " INTO ships(id, " + place + ", shape) SELECT id, " + origin + ", shape FROM feed";
  EXPECT_EQ(db.error_of("INSERT" + all), "UNIQUE constraint failed: ships.id");
  EXPECT_EQ(this->stored(db), "1");
  // The failed statement has parsed these texts: they must not count as stored.
  db.exec("INSERT OR IGNORE" + all);
  EXPECT_EQ(db.rows("SELECT id, shape FROM ships ORDER BY id"),
            "1|" + this->shape(1) + "\n5|" + this->shape(5) + "\n6|" + this->shape(6));
  db.exec("INSERT OR REPLACE" + all);
  EXPECT_EQ(db.rows("SELECT shape FROM ships WHERE id = 1"), this->shape(7));
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TYPED_TEST(FormStorage, OptimizeAndRebuildDropFormsWithoutARow) {
  for (const char* command : {"optimize", "rebuild"}) {
    Database db;
    db.exec(this->create + this->insert(1, 1) + this->insert(2, 2) + this->insert(3, 3));
    db.exec("UPDATE ships SET shape = NULL WHERE id = 2; DELETE FROM ships WHERE id = 3");
    EXPECT_EQ(this->stored(db), "3");
    db.exec("INSERT INTO ships(ships) VALUES('" + std::string(command) + "')");
    EXPECT_EQ(this->stored(db), "1");
    db.exec(this->insert(3, 3) + this->insert(4, 1));
    EXPECT_EQ(db.rows("SELECT shape FROM ships ORDER BY id"),
              this->shape(1) + "\nNULL\n" + this->shape(3) + "\n" + this->shape(1));
    db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
  }
}

TYPED_TEST(FormStorage, ARunningQueryKeepsItsForms) {
  Database db;
  db.exec(this->create);
  for (int id = 1; id <= 300; ++id) db.exec(this->insert(id, id));
  EXPECT_EQ(rows_of_window(db, "DELETE FROM ships; INSERT INTO ships(ships) VALUES('optimize')"), 300);
}

TYPED_TEST(FormStorage, ARunningQueryOutlivesARollback) {
  Database db;
  db.exec(this->create + "BEGIN; SAVEPOINT q");
  for (int id = 1; id <= 1200; ++id) db.exec(this->insert(id, id));
  EXPECT_EQ(rows_of_window(db, "ROLLBACK TO q; COMMIT"), 1200);
}

TYPED_TEST(FormStorage, TwoConnectionsGiveNumbersInTurn) {
  const TemporaryFile file;
  Database a(file.path()), b(file.path());
  a.exec("PRAGMA journal_mode = WAL;" + this->create + this->insert(1, 1));
  EXPECT_EQ(b.rows("SELECT shape FROM ships"), this->shape(1));
  a.exec("BEGIN;" + this->insert(2, 2) + "ROLLBACK");
  b.exec(this->insert(3, 3));  // under the number of a's rolled-back form
  EXPECT_EQ(a.rows("SELECT shape FROM ships ORDER BY id"), this->shape(1) + "\n" + this->shape(3));
  a.exec(this->insert(2, 2));
  EXPECT_EQ(b.rows("SELECT shape FROM ships ORDER BY id"),
            this->shape(1) + "\n" + this->shape(2) + "\n" + this->shape(3));
  b.exec("DELETE FROM ships WHERE id = 1; INSERT INTO ships(ships) VALUES('optimize');" + this->insert(4, 4));
  a.exec(this->insert(5, 1));
  EXPECT_EQ(a.rows("SELECT shape FROM ships ORDER BY id"),
            this->shape(2) + "\n" + this->shape(3) + "\n" + this->shape(4) + "\n" + this->shape(1));
  a.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

// The number of a's rolled-back form now belongs to b: a must not use, read or rotate its cached form.
TYPED_TEST(FormStorage, ARolledBackNumberMayBelongToAnotherForm) {
  const TemporaryFile file;
  Database a(file.path()), b(file.path());
  a.exec("PRAGMA journal_mode = WAL;" + this->create);
  a.exec("BEGIN;" + this->insert(2, 2) + "ROLLBACK");
  b.exec(this->insert(3, 3));
  EXPECT_EQ(a.rows("SELECT id, shape FROM ships"), "3|" + this->shape(3));
  a.exec("BEGIN;" + this->insert(4, 4) + "ROLLBACK");
  b.exec(this->insert(5, 5));
  a.exec("UPDATE ships SET heading = 90");
  a.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
  EXPECT_EQ(a.rows("SELECT id FROM predictive_window(0, 'ships', 0, 1, -5, -4)"), "5");
}

TYPED_TEST(FormStorage, GoesWhereTheTableGoes) {
  const TemporaryFile file;
  {
    Database db(file.path());
    db.exec(this->create + this->insert(1, 1));
    db.exec("ALTER TABLE ships RENAME TO fleet");
    db.exec("INSERT INTO fleet" + this->insert(2, 2).substr(std::string("INSERT INTO ships").size()));
    db.exec(this->create + this->insert(1, 3) + "VACUUM");  // the old name is free
    EXPECT_EQ(db.rows("SELECT shape FROM fleet ORDER BY id"), this->shape(1) + "\n" + this->shape(2));
    db.exec("DROP TABLE ships");
    EXPECT_EQ(db.rows("SELECT count(*) FROM sqlite_schema WHERE name LIKE 'ships%'"), "0");
  }
  Database db;
  db.exec("ATTACH '" + file.path() + "' AS old");
  EXPECT_EQ(db.rows("SELECT shape FROM old.fleet ORDER BY id"), this->shape(1) + "\n" + this->shape(2));
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(0, 'fleet')"), "1|2");
}

TYPED_TEST(FormStorage, DamageIsReportedAndChangesNothing) {
  const std::string kind = TypeParam::kind;
  const std::pair<std::string, std::string> damages[] = {
      {"DELETE FROM ships_shape WHERE number = 1", kind + " 1"},
      {"UPDATE ships_shape SET data = x'00' WHERE number = 1", kind + " 1 is damaged: it is too short"},
      {"UPDATE ships_shape SET data = zeroblob(length(data)) WHERE number = 1",
       kind + " 1 is damaged: its checksum is wrong"},
      {"UPDATE ships_shape SET data = 7 WHERE number = 1", kind + " 1 is damaged: it is not a blob"},
      {"UPDATE ships_shape SET hash = 3 WHERE number = 1", kind + " 1 is damaged: its hash"},
      TypeParam::damage(),
  };
  for (const auto& [damage, words] : damages) {
    const TemporaryFile file;
    {
      Database db(file.path());
      db.exec(this->create + this->insert(1, 1) + this->insert(2, 2));
      db.exec(damage);
    }
    Database db(file.path());
    for (const char* statement :
         {"SELECT shape FROM ships", "SELECT * FROM predictive_join(9, 'ships')",
          "SELECT * FROM predictive_window(9, 'ships', 0)", "UPDATE ships SET heading = 45 WHERE id = 1",
          "INSERT INTO ships(ships) VALUES('integrity-check')"})
      EXPECT_NE(db.error_of(statement).find(words), std::string::npos)
          << damage << "; " << statement << ": " << db.error_of(statement);
    EXPECT_EQ(db.rows("SELECT count(*), sum(heading) FROM ships"), "2|0.0");
    db.exec(
        "UPDATE ships SET shape = NULL; INSERT INTO ships(ships) VALUES('rebuild');"
        "INSERT INTO ships(ships) VALUES('integrity-check')");
  }
}

TYPED_TEST(FormStorage, NumbersBeyondWhatADoubleHoldsAreDamage) {
  Database db;
  db.exec(this->create + this->insert(1, 1));
  for (const char* number : {"9223372036854775807", "9007199254740992", "-5", "0"}) {
    db.exec("UPDATE ships_shape SET number = " + std::string(number));
    EXPECT_NE(db.error_of(this->insert(2, 2)).find("ships"), std::string::npos);
    EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "1");
  }
}

TYPED_TEST(FormStorage, IsTheSameInTheNextConnection) {
  const TemporaryFile file;
  {
    Database db(file.path());
    db.exec(this->create + this->insert(1, 1, 30) + this->insert(2, 2));
    db.exec("ALTER TABLE ships RENAME TO fleet");
  }
  Database db(file.path());
  EXPECT_EQ(db.rows("SELECT shape, heading FROM fleet ORDER BY id"),
            this->shape(1) + "|30.0\n" + this->shape(2) + "|0.0");
  db.exec("UPDATE fleet SET heading = 60 WHERE id = 2; INSERT INTO fleet(fleet) VALUES('integrity-check')");
}

// A valid blob of a larger form under the number: the stored bounds of the rows do not belong to it.
TYPED_TEST(FormStorage, BoundsAreThoseOfTheRotatedForm) {
  const TemporaryFile file;
  {
    Database db(file.path());
    db.exec(this->create + this->insert(1, 1, 30) + this->insert(2, 2));
    db.exec(
        "CREATE TABLE t AS SELECT hash, data FROM ships_shape WHERE number = 2;"
        "DELETE FROM ships_shape WHERE number = 2;"
        "UPDATE ships_shape SET (hash, data) = (SELECT hash, data FROM t) WHERE number = 1;");
  }
  Database db(file.path());
  const std::string said = db.error_of("INSERT INTO ships(ships) VALUES('integrity-check')");
  const std::string kind = TypeParam::kind;
  EXPECT_NE(said.find("object 1 has other bounds than " + kind + " 1"), std::string::npos) << said;
  EXPECT_NE(said.find("object 2 has " + kind + " 2, which is missing"), std::string::npos) << said;
}

TEST(MeshStorage, TheSameTrianglesAsASurfaceAreAnotherMesh) {
  Database db;
  db.exec(Meshes::create + FormStorage<Meshes>::insert(1, 1) +
          FormStorage<Meshes>::insert(2, "TIN Z" + Meshes::shape(1).substr(19)));
  EXPECT_EQ(FormStorage<Meshes>::stored(db), "2");
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

}  // namespace
}  // namespace foresee::testing
