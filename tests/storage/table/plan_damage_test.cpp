// Plans that are damaged: reported in every way of reading, and by 'integrity-check'; repaired by 'rebuild'.
#include "format/node_format.h"
#include "storage/plan_cases.h"

namespace foresee {
namespace {

class PlanDamage : public ThreePlans {
 protected:
  std::string number(int chunk) {
    return std::to_string(static_cast<std::int64_t>(plan_number(record(1))) + chunk);
  }
  void read_everything() { read_during(-no_end, no_end); }
  void read_during(double from, double until) {
    store->read_objects(
        from, until, [](std::int64_t, std::span<const double>, std::span<const Leg>) {}, never);
  }
  /// Expects damage in every way of reading object 1 and its second chunk.
  void expect_damage(const std::string& words, const std::string& of_plan = "") {
    const std::vector<double> head = record(1);
    const auto second = static_cast<std::int64_t>(plan_number(head)) + 1;
    expect_store_error(SQLITE_CORRUPT_VTAB, of_plan.empty() ? words : of_plan,
                       [&] { store->read_plan(1, head); });
    expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { read_everything(); });
    Chunk chunk;
    expect_store_error(SQLITE_CORRUPT_VTAB, "chunk", [&] { store->chunks()->read_chunk(second, {}, chunk); });
    expect_fault(words);
  }
  void expect_fault(const std::string& words) {
    std::string all;
    for (const std::string& fault : faults(*store)) all += fault + "\n";
    EXPECT_NE(all.find(words), std::string::npos) << "expected: " << words << "\nfound: " << all;
  }
};

TEST_F(PlanDamage, EveryChangedByteOfAChunkIsAnErrorOnEveryPath) {
  const std::int64_t size = db.number("SELECT length(data) FROM ships_leg WHERE number = " + number(1));
  Statement change(db,
                   "UPDATE ships_leg SET data = CAST(substr(data, 1, ?1) || CAST(x'ff' AS BLOB) || "
                   "substr(data, ?1 + 2) AS BLOB) WHERE number = ?2 AND substr(data, ?1 + 1, 1) <> x'ff'");
  const std::string name = number(1);
  int changed = 0;
  for (std::int64_t at = 0; at < size && !HasFailure(); ++at) {
    db.run("SAVEPOINT untouched");
    {
      Statement::Run run(change);
      run.bind(1, at);
      run.bind(2, std::int64_t{std::stoll(name)});
      run.step();
    }
    if (sqlite3_changes(db) == 1) {
      ++changed;
      expect_damage("chunk " + name + " is damaged: its checksum does not match");
    }
    db.run("ROLLBACK TO untouched; RELEASE untouched");
  }
  EXPECT_GT(changed, size - 100);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(PlanDamage, RowsThatAreMissingMovedOrForeign) {
  const std::string second = number(1);
  const auto with = [&](const std::string& sql, const std::string& words, const std::string& of_plan = "") {
    db.run("SAVEPOINT untouched; " + sql);
    expect_damage(words, of_plan);
    db.run("ROLLBACK TO untouched; RELEASE untouched");
  };
  with("DELETE FROM ships_leg WHERE number = " + second, " chunks, but ", "a chunk of object 1 is missing");
  with("UPDATE ships_leg SET data = NULL WHERE number = " + second, "it is too short");
  with("UPDATE ships_leg SET data = 'text' WHERE number = " + second, "it is too short");
  with("UPDATE ships_leg SET number = -5 WHERE number = " + second, " is of no object",
       "a chunk of object 1 is missing");
  with("UPDATE ships_leg SET data = (SELECT data FROM ships_leg WHERE number = " + number(0) +
           ") WHERE number = " + second,
       "its checksum does not match");
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(PlanDamage, AMissingFirstChunkIsNotAPlanWithoutLegs) {
  db.run("DELETE FROM ships_leg WHERE number = " + number(0));
  std::vector<Leg> legs;
  StatementReadState statement_state;
  expect_store_error(SQLITE_CORRUPT_VTAB, "a chunk of object 1 is missing",
                     [&] { store->read_legs(1, stored_record(*store, 1), {}, statement_state, legs); });
}

TEST_F(PlanDamage, AChunkOfAnotherObjectIsRefused) {
  std::vector<std::byte> blob;
  const std::int64_t second = std::stoll(number(1));
  BlobRows rows(shadow_tables(db, {"main", "ships"}, fleet()), "leg", "number");
  rows.read(second, second, [&](std::int64_t, std::span<const std::byte> bytes) {
    blob = chunk_of_object(bytes, second, 2);
  });
  rows.write(second, blob);
  expect_damage("chunk " + std::to_string(second) + " is of object 2, not of object 1");
  begin(db, *store);
  expect_store_error(SQLITE_CORRUPT_VTAB, "is of object 2", [&] { store->rebuild(never); });
  roll_back(db, *store);
}

/// A query of few legs finds their chunk by the starts in the first one.
TEST_F(PlanDamage, WrongStartsOfChunksAreReported) {
  constexpr std::int64_t starts = 24;  // after the header of 16 bytes and two counts
  const std::int64_t first = std::stoll(number(0));
  BlobRows rows(shadow_tables(db, {"main", "ships"}, fleet()), "leg", "number");
  std::vector<std::byte> sound;
  rows.read(first, first, [&](std::int64_t, std::span<const std::byte> bytes) {
    sound.assign(bytes.begin(), bytes.end());
  });
  const auto chunks = load_number<std::uint32_t>(sound.data() + 16);
  ASSERT_GT(chunks, 3u);
  for (std::int64_t chunk = 1; chunk < chunks; ++chunk) {
    std::vector<std::byte> changed = sound;
    std::byte* const at = changed.data() + starts + chunk * 8;
    store_number(at, load_number<double>(at) + 1e-6);
    seal_node(changed, first);
    rows.write(first, changed);
    expect_fault("chunk " + std::to_string(first + chunk) +
                 " is damaged: the first chunk of its plan has another start for it");
    begin(db, *store);
    expect_store_error(SQLITE_CORRUPT_VTAB, "another start", [&] { store->rebuild(never); });
    roll_back(db, *store);
  }
  rows.write(first, sound);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(PlanDamage, StraysAreReportedAndRebuildDeletesThem) {
  db.run("INSERT INTO ships_leg SELECT number + 1000, data FROM ships_leg WHERE number = " + number(1));
  expect_fault(" is of no object");
  expect_store_error(SQLITE_CORRUPT_VTAB, "is of no object", [&] { read_everything(); });
  begin(db, *store);
  store->rebuild(never);
  commit(db, *store);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
  expect_robots(*store, robots, "rebuilt");
}

TEST_F(PlanDamage, NodesOfTheTreeOfChunks) {
  db.run("UPDATE ships_chunknode SET data = zeroblob(length(data)) WHERE nodeno = 1");
  open_again();
  expect_fault("ships_chunk: node 1 is damaged");
  begin(db, *store);
  expect_store_error(SQLITE_CORRUPT_VTAB, "ships_chunk: node 1 is damaged", [&] { store->erase(1); });
  store->rebuild(never);  // trusts the rows of chunks alone
  commit(db, *store);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
  expect_robots(*store, robots, "rebuilt");
  db.run(
      "DELETE FROM ships_chunknode; DELETE FROM ships_chunkmap; UPDATE ships_meta SET value = 0 WHERE key "
      "= "
      "'chunk_root'");
  open_again();
  expect_fault("is missing in the tree of chunks");
  begin(db, *store);
  store->rebuild(never);
  commit(db, *store);
  expect_robots(*store, robots, "rebuilt from nothing");
}

TEST_F(PlanDamage, ItemsThatDoNotContainTheirLegs) {
  // The items of another plan of the same size, under the numbers of this one.
  Database other;
  auto wrong = make_store(other, fleet());
  begin(other, *wrong);
  for (auto& [id, robot] : robots) {
    Plan moved = robot.plan.value_or(Plan());
    for (Knot& knot : moved.knots) knot.x[0] += 1000;
    wrong->insert(id, robot_record(1), {}, {}, robot.plan ? &moved : nullptr);
  }
  commit(other, *wrong);
  const std::string sql = "SELECT quote(data) FROM ships_chunknode WHERE nodeno = 1";
  db.run("UPDATE ships_chunknode SET data = " + other.text(sql) + " WHERE nodeno = 1");
  open_again();
  expect_fault(" is not within its box");
}

/// Few chunks exist at one time: each is looked up.
TEST_F(PlanDamage, AReadOfOneTimeReportsTheRowsThatItReads) {
  const std::string second = number(1);
  Chunk chunk;
  store->chunks()->read_chunk(std::stoll(second), {}, chunk);
  const double t = chunk.legs[1].t;
  const auto with = [&](const std::string& sql, const std::string& words) {
    db.run("SAVEPOINT untouched; " + sql);
    expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { read_during(t, t); });
    db.run("ROLLBACK TO untouched; RELEASE untouched");
    read_during(t, t);
  };
  with("DELETE FROM ships_leg WHERE number = " + second, "chunk " + second + " is missing");
  with("UPDATE ships_leg SET number = -5 WHERE number = " + second, "chunk " + second + " is missing");
  with("UPDATE ships_leg SET data = NULL WHERE number = " + second, "it is too short");
}

TEST_F(PlanDamage, OptimizeKeepsPlansAndPacksTheirTree) {
  begin(db, *store);
  store->optimize(never);
  commit(db, *store);
  expect_robots(*store, robots, "optimized");
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

}  // namespace
}  // namespace foresee
