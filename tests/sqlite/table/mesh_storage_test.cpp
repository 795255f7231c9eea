// Where meshes rest: shared by content, in one transaction with the rows that name them, checked when read.
// What they have in common with outlines, outline_storage_test.cpp asks.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* create_drones =
    "CREATE VIRTUAL TABLE drones USING moving_objects(id, t, x, y, z, shape, heading, r);";

/// A tetrahedron of this size.
std::string solid(int size) {
  const std::string s = std::to_string(size);
  const std::string o = "0 0 0", x = s + " 0 0", y = "0 " + s + " 0", z = "0 0 " + s;
  const auto face = [](const std::string& a, const std::string& b, const std::string& c) {
    return "((" + a + ", " + b + ", " + c + ", " + a + "))";
  };
  return "POLYHEDRALSURFACE Z(" + face(o, y, x) + ", " + face(o, x, z) + ", " + face(o, z, y) + ", " +
         face(x, y, z) + ")";
}

std::string insert_drone(int id, int size, int heading = 0) {
  return "INSERT INTO drones(id, t, x, y, z, shape, heading) VALUES(" + std::to_string(id) +
         ", 0, 0, 0, 0, '" + solid(size) + "', " + std::to_string(heading) + ");";
}

std::string stored_solids(Database& db) {
  return db.rows("SELECT count(*) FROM drones_shape");
}

TEST(MeshStorage, EqualContentIsStoredOnce) {
  Database db;
  db.exec(create_drones);
  for (int id = 1; id <= 100; ++id) db.exec(insert_drone(id, id % 3 + 1, id));
  EXPECT_EQ(stored_solids(db), "3");
  // The same triangles as a surface are another mesh.
  db.exec("INSERT INTO drones(id, t, x, y, z, shape) VALUES(999, 0, 0, 0, 0, 'TIN Z" + solid(1).substr(19) +
          "')");
  EXPECT_EQ(stored_solids(db), "4");
  db.exec("UPDATE drones SET heading = id % 360");
  EXPECT_EQ(stored_solids(db), "4");
  db.exec("INSERT INTO drones(drones) VALUES('integrity-check')");
}

TEST(MeshStorage, WhatIsTakenBackIsStoredAnewWhenItComesAgain) {
  Database db;
  db.exec(create_drones);
  db.exec("BEGIN;" + insert_drone(1, 1) + "ROLLBACK;" + insert_drone(1, 1));
  EXPECT_EQ(stored_solids(db), "1");
  db.exec("BEGIN;" + insert_drone(2, 2) + "SAVEPOINT a;" + insert_drone(3, 3) + "ROLLBACK TO a;" +
          insert_drone(4, 4) + insert_drone(3, 3) + "RELEASE a; COMMIT");
  EXPECT_EQ(db.rows("SELECT id, shape FROM drones ORDER BY id"),
            "1|" + solid(1) + "\n2|" + solid(2) + "\n3|" + solid(3) + "\n4|" + solid(4));
  db.exec("INSERT INTO drones(drones) VALUES('integrity-check')");
}

TEST(MeshStorage, OptimizeAndRebuildDropWhatNoRowHas) {
  for (const char* command : {"optimize", "rebuild"}) {
    Database db;
    db.exec(create_drones + insert_drone(1, 1) + insert_drone(2, 2) + insert_drone(3, 3));
    db.exec("UPDATE drones SET shape = NULL WHERE id = 2; DELETE FROM drones WHERE id = 3");
    db.exec("INSERT INTO drones(drones) VALUES('" + std::string(command) + "')");
    EXPECT_EQ(stored_solids(db), "1");
    db.exec(insert_drone(3, 3) + insert_drone(4, 1));
    EXPECT_EQ(db.rows("SELECT shape FROM drones ORDER BY id"),
              solid(1) + "\nNULL\n" + solid(3) + "\n" + solid(1));
    db.exec("INSERT INTO drones(drones) VALUES('integrity-check')");
  }
}

TEST(MeshStorage, IsTheSameInTheNextConnection) {
  const TemporaryFile file;
  {
    Database db(file.path());
    db.exec(create_drones + insert_drone(1, 1, 30) + insert_drone(2, 2));
    db.exec("ALTER TABLE drones RENAME TO fleet");
  }
  Database db(file.path());
  EXPECT_EQ(db.rows("SELECT shape, heading FROM fleet ORDER BY id"),
            solid(1) + "|30.0\n" + solid(2) + "|0.0");
  db.exec("UPDATE fleet SET heading = 60 WHERE id = 2; INSERT INTO fleet(fleet) VALUES('integrity-check')");
}

TEST(MeshStorage, DamageIsSaidAndChangesNothing) {
  const std::string damages[][2] = {
      {"DELETE FROM drones_shape WHERE number = 1", "mesh 1"},
      {"UPDATE drones_shape SET data = x'00' WHERE number = 1", "mesh 1 is damaged: it is too short"},
      {"UPDATE drones_shape SET data = zeroblob(length(data)) WHERE number = 1",
       "mesh 1 is damaged: its checksum is wrong"},
      {"UPDATE drones_shape SET data = 7 WHERE number = 1", "mesh 1 is damaged: it is no blob"},
      {"UPDATE drones_shape SET hash = 3 WHERE number = 1", "mesh 1 is damaged: its hash"},
      // An outline, whose checksum is right.
      {"CREATE VIRTUAL TABLE s USING moving_objects(id, x, y, shape);"
       "INSERT INTO s VALUES(1, 0, 0, 'POLYGON((0 0, 4 0, 0 3, 0 0))');"
       "UPDATE drones_shape SET (hash, data) = (SELECT hash, data FROM s_shape) WHERE number = 1",
       "mesh 1 is damaged: its format or kind is not known"},
  };
  for (const auto& [damage, words] : damages) {
    const TemporaryFile file;
    {
      Database db(file.path());
      db.exec(create_drones + insert_drone(1, 1) + insert_drone(2, 2));
      db.exec(damage);
    }
    Database db(file.path());
    for (const char* statement : {"SELECT shape FROM drones", "SELECT * FROM predictive_join(9, 'drones')",
                                  "UPDATE drones SET heading = 45 WHERE id = 1",
                                  "INSERT INTO drones(drones) VALUES('integrity-check')"})
      EXPECT_NE(db.error_of(statement).find(words), std::string::npos)
          << damage << "; " << statement << ": " << db.error_of(statement);
    EXPECT_EQ(db.rows("SELECT count(*), sum(heading) FROM drones"), "2|0.0");
    db.exec(
        "UPDATE drones SET shape = NULL; INSERT INTO drones(drones) VALUES('rebuild');"
        "INSERT INTO drones(drones) VALUES('integrity-check')");
  }
}

// The blob of a larger mesh under the number: sound, but not what the bounds of the rows are of.
TEST(MeshStorage, BoundsAreThoseOfTheTurnedMesh) {
  const TemporaryFile file;
  {
    Database db(file.path());
    db.exec(create_drones + insert_drone(1, 1, 30) + insert_drone(2, 2));
    db.exec(
        "CREATE TABLE t AS SELECT hash, data FROM drones_shape WHERE number = 2;"
        "DELETE FROM drones_shape WHERE number = 2;"
        "UPDATE drones_shape SET (hash, data) = (SELECT hash, data FROM t) WHERE number = 1;");
  }
  Database db(file.path());
  const std::string said = db.error_of("INSERT INTO drones(drones) VALUES('integrity-check')");
  EXPECT_NE(said.find("object 1 has other bounds than mesh 1"), std::string::npos) << said;
  EXPECT_NE(said.find("object 2 has mesh 2, which is missing"), std::string::npos) << said;
}

TEST(MeshStorage, QuestionsSeeWhatHasChanged) {
  Database db;
  db.exec("CREATE VIRTUAL TABLE s USING moving_objects(id, t, x, y, z, vx, vy, vz, shape, heading)");
  // A rod of ten along y, and a point ten beside it.
  db.exec(
      "INSERT INTO s VALUES(1, 0, 0, 0, 0, 0, 0, 0, 'TIN Z(((0 0 0, 0 10 0, 0 5 1, 0 0 0)))', 0), "
      "(2, 0, 10, 0, 0, 0, 0, 0, NULL, 0)");
  const std::string question = "SELECT a, b FROM predictive_join(5, 's')";
  EXPECT_EQ(db.rows(question), "");
  db.exec("UPDATE s SET heading = 90 WHERE id = 1");
  EXPECT_EQ(db.rows(question), "1|2");
  db.exec("BEGIN; UPDATE s SET shape = NULL");
  EXPECT_EQ(db.rows(question), "");
  db.exec("ROLLBACK");
  EXPECT_EQ(db.rows(question), "1|2");
}

}  // namespace
}  // namespace foresee::testing
