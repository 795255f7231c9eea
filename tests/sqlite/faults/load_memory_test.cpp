// Memory that a bulk load, an UPDATE of all rows, 'rebuild' and 'optimize' need, and what happens without
// memory or disk space. The limits are far below those of an application, so that few objects count as many.
#include <array>
#include <filesystem>

#include "sqlite/faults/fault_steps.h"
#include "sqlite/faults/faulty_files.h"
#include "sqlite/faults/killed_writer.h"
#include "sqlite/faults/memory_faults.h"
#include "storage/database.h"
#include "storage/plan_cases.h"
#include "storage/rows/shadow_schema.h"

namespace foresee {
namespace {

using testing::bytes_held, testing::bytes_peak, testing::FileFault, testing::FaultyFiles;

constexpr MemoryLimits small{.pending = 3'000'000, .memory = 400'000, .waiting = 200'000, .ordered = 200'000};

class LargeTable {
 public:
  /// An existing file has the table already.
  explicit LargeTable(const MemoryLimits& limits = small, const std::string& path = "")
      : LargeTable(limits, path, std::filesystem::exists(path)) {}

  void load(std::int64_t objects) {
    begin(db, *store);
    start_statement();
    for (std::int64_t i = 1; i <= objects; ++i) store->insert(id_of(i), at(i), {});
    commit(db, *store);
  }
  /// The same in many transactions, which pack new objects beside those that are there.
  void load_in(std::int64_t transactions, std::int64_t objects) {
    for (std::int64_t k = 0; k < transactions; ++k) {
      begin(db, *store);
      for (std::int64_t i = objects * k / transactions; i++ < objects * (k + 1) / transactions;)
        store->insert(id_of(i), at(i), {});
      commit(db, *store);
    }
  }
  void update_all(std::int64_t objects) {
    begin(db, *store);
    start_statement();
    for (std::int64_t i = 0; i < objects; ++i) {
      const std::int64_t id = id_of(i * 9973 % objects + 1);
      store->update(id, id, at(i), {});
    }
    commit(db, *store);
  }
  void erase_half(std::int64_t objects) {
    begin(db, *store);
    store->erase(id_of(2));
    store->take_snapshot();  // the statement starts with changes that are not written
    start_statement();
    for (std::int64_t i = 1; i <= objects; i += 2) store->erase(id_of(i));
    commit(db, *store);
  }
  void rebuild() {
    begin(db, *store);
    store->rebuild(never);
    commit(db, *store);
  }
  void optimize() {
    begin(db, *store);
    store->optimize(never);
    commit(db, *store);
  }

  testing::TemporaryFile file;
  Database db;
  std::shared_ptr<Store> store;
  NeverInterrupt never;
  /// Whether one statement of a longer transaction writes all rows, as INSERT … SELECT does.
  bool by_one_statement = false;

 private:
  void start_statement() {
    if (by_one_statement) store->savepoint(0);
  }

  LargeTable(const MemoryLimits& limits, const std::string& path, bool is_there)
      : db(path.empty() ? file.path() : path) {
    db.run("PRAGMA synchronous = OFF");
    static const QualifiedName name{"main", "ships"};
    db.run("BEGIN IMMEDIATE");
    const ShadowTables tables = shadow_tables(db, name, ships());
    const NodeFormat made = is_there ? NodeFormat() : create_shadow_tables(db, name, ships());
    auto rows = std::make_unique<ShadowRows>(tables, ships());
    const NodeFormat format = is_there ? read_node_format(tables, rows->meta(), ships()) : made;
    store = std::make_shared<Store>(db, name, ships(), format, std::move(rows), !is_there,
                                    std::make_shared<MemoryBudget>(limits));
    if (is_there) db.run("COMMIT");
    if (!is_there) commit(db, *store);
  }

  static std::int64_t id_of(std::int64_t i) { return i * 7919 % 200'003; }
  static std::vector<double> at(std::int64_t i) {
    return {1, static_cast<double>(i * 31 % 997), static_cast<double>(i * 17 % 991), 1, -1, 1};
  }
};

/// Peak memory of the work beyond the memory in use before it, of foresee and SQLite together.
template <class Work>
double peak_of(Work work) {
  const std::size_t held = bytes_peak = bytes_held;
  const std::int64_t lite = sqlite3_memory_used();
  sqlite3_memory_highwater(1);
  work();
  return static_cast<double>(bytes_peak - held) + static_cast<double>(sqlite3_memory_highwater(0) - lite);
}

/// Peaks of a load with ids in random order, one UPDATE of all rows likewise, 'rebuild', 'optimize', and a DELETE of
/// half of the rows.
std::array<double, 5> peaks_of(std::int64_t objects, bool by_one_statement) {
  LargeTable table;
  table.by_one_statement = by_one_statement;
  return {peak_of([&] { table.load(objects); }), peak_of([&] { table.update_all(objects); }),
          peak_of([&] { table.rebuild(); }), peak_of([&] { table.optimize(); }),
          peak_of([&] { table.erase_half(objects); })};
}

TEST(LoadMemory, GrowsByFewBytesPerRow) {
  constexpr std::int64_t some = 60'000, more = 120'000;
  // 'optimize' checks the table first, and DELETE looks objects up: hints to their leaves (leaf_hints.h) grow by 17
  // bytes per object, up to 16 MB.
  constexpr std::array<double, 5> limit{20, 20, 20, 45, 47};
  for (const bool by_one_statement : {false, true}) {
    const auto few = peaks_of(some, by_one_statement), many = peaks_of(more, by_one_statement);
    for (std::size_t work = 0; work < limit.size(); ++work) {
      EXPECT_LT((many[work] - few[work]) / (more - some), limit[work])
          << "bytes per row: work " << work << (by_one_statement ? " by one statement" : "");
      EXPECT_LT(many[work], 16e6) << "all of it: work " << work;
    }
  }
}

TEST(LoadMemory, ManyTransactionsGrowByFewBytesPerRow) {
  const auto peak = [](std::int64_t objects) {
    LargeTable table;
    return peak_of([&] { table.load_in(objects / 3'000, objects); });
  };
  // In the smaller tables a transaction packs nodes of level 1, in the larger ones nodes of level 2.
  for (const std::int64_t some : {30'000, 99'000}) {
    const double few = peak(some), many = peak(2 * some);
    // 12 bytes for each object that a commit places, 4 for the filter of ids.
    EXPECT_LT((many - few) / static_cast<double>(some), 20) << "bytes per row";
    EXPECT_LT(many, 16e6);
  }
}

/// Peak of 'rebuild' of a table with few plans of many chunks.
double peak_of_plans(std::int64_t objects, std::int64_t chunks) {
  static const QualifiedName name{"main", "ships"};
  testing::TemporaryFile file;
  Database db(file.path());
  db.run("PRAGMA synchronous = OFF; BEGIN IMMEDIATE");
  const NodeFormat format = create_shadow_tables(db, name, fleet());
  auto rows = std::make_unique<ShadowRows>(shadow_tables(db, name, fleet()), fleet());
  const auto store = std::make_shared<Store>(db, name, fleet(), format, std::move(rows), true,
                                             std::make_shared<MemoryBudget>(small));
  commit(db, *store);
  begin(db, *store);
  for (std::int64_t id = 1; id <= objects; ++id) {
    Plan plan = plan_of_knots({});
    for (std::int64_t i = 0; i <= 16 * chunks; ++i)
      plan.knots.push_back({static_cast<double>(i),
                            {static_cast<double>((id * 31 + i * 7) % 997), static_cast<double>(i % 991)}});
    store->insert(id, robot_record(1), {}, {}, &plan);
  }
  commit(db, *store);
  EXPECT_GE(db.number("SELECT count(*) FROM ships_leg"), objects * chunks);
  NeverInterrupt never;
  return peak_of([&] {
    begin(db, *store);
    store->rebuild(never);
    commit(db, *store);
  });
}

TEST(LoadMemory, ARebuildOfPlansGrowsByFewBytesPerChunk) {
  constexpr std::int64_t some = 120, more = 360, chunks = 500;
  const double few = peak_of_plans(some, chunks), many = peak_of_plans(more, chunks);
  EXPECT_LT((many - few) / ((more - some) * chunks), 20) << "bytes per chunk";
}

TEST(LoadFile, ARebuildThatIsKilledLeavesEveryObject) {
  testing::TemporaryFile file;
  const MemoryLimits limits{.pending = 100'000, .memory = 60'000, .waiting = 20'000, .ordered = 20'000};
  LargeTable(limits, file.path()).load(6'000);
  const auto before = contents(*LargeTable(limits, file.path()).store);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    testing::write_and_kill(seed, [&](testing::Announce announce) {
      LargeTable table(limits, file.path());
      for (std::int64_t number = 1;; ++number) {
        number % 2 ? table.rebuild() : table.optimize();
        announce(number);
      }
    });
    LargeTable table(limits, file.path());
    EXPECT_EQ(contents(*table.store), before) << seed;
    EXPECT_EQ(faults(*table.store), std::vector<std::string>{}) << seed;
  }
}

struct LoadFaults : testing::MemoryFaults {
  static constexpr std::int64_t objects = 1'500;
  static constexpr MemoryLimits tiny{
      .pending = 100'000, .memory = 60'000, .waiting = 20'000, .ordered = 20'000};
};

/// The work succeeds, or it fails with an error of foresee and the rollback restores the table.
template <class Work>
bool is_done(LargeTable& table, Work work) {
  bool done = false;
  int code = SQLITE_OK;
  try {
    work();
    done = true;
  } catch (const std::bad_alloc&) {
    code = SQLITE_NOMEM;
  } catch (const StoreError& error) {
    code = error.code & 0xff;
  }
  testing::faults = {};
  if (!done) {
    EXPECT_TRUE(code == SQLITE_NOMEM || code == SQLITE_FULL || code == SQLITE_IOERR ||
                code == SQLITE_CANTOPEN)
        << code;
    if (!sqlite3_get_autocommit(table.db)) table.db.run("ROLLBACK");
    table.store->rollback();
  }
  return done;
}

TEST_F(LoadFaults, WithoutMemoryARebuildChangesNothing) {
  for (const bool for_good : {false, true}) {
    LargeTable table(tiny);
    table.load(objects);
    const auto before = contents(*table.store);
    for (long n = 0;; n = testing::next_fault_of_many(n)) {
      begin(table.db, *table.store);
      const bool done = is_done(table, [&] {
        testing::faults = {.armed = true, .for_good = for_good, .left = n, .fired = false};
        table.store->rebuild(table.never);
        testing::faults = {};
        commit(table.db, *table.store);
      });
      ASSERT_EQ(contents(*table.store), before) << n;
      ASSERT_EQ(faults(*table.store), std::vector<std::string>{}) << n;
      if (done) break;
    }
  }
}

TEST(LoadFile, WithoutDiskSpaceARebuildChangesNothing) {
  FaultyFiles files(FaultyFiles::default_for_all);
  constexpr MemoryLimits limits{
      .pending = 6'000'000, .memory = 4'000'000, .waiting = 4'000'000, .ordered = 400'000};
  constexpr std::int64_t objects = 50'000;  // 2.8 MB: more than SQLite keeps of the file in memory
  LargeTable table(limits, ":memory:");
  table.load(objects);
  const auto before = contents(*table.store);
  int failed = 0;
  for (const FileFault fault :
       {FileFault::write_fails, FileFault::disk_full, FileFault::read_fails, FileFault::open_fails})
    for (const long n : {0L, 3L}) {
      files.arm(fault, n, FaultyFiles::once);
      begin(table.db, *table.store);
      std::string words;
      const bool done = is_done(table, [&] {
        try {
          table.store->rebuild(table.never);
        } catch (const StoreError& error) {
          words = error.what();
          throw;
        }
        commit(table.db, *table.store);
      });
      const bool fired = files.disarm();
      EXPECT_EQ(done, !fired) << "fault " << static_cast<int>(fault) << " at " << n;
      if (fired) {
        EXPECT_NE(words.find("ships: a temporary file"), std::string::npos) << words;
      }
      failed += fired;
      EXPECT_EQ(contents(*table.store), before);
    }
  EXPECT_GE(failed, 5);
  EXPECT_EQ(faults(*table.store), std::vector<std::string>{});
  // A database in memory has no file that could fail.
  table.db.run("PRAGMA temp_store = MEMORY");
  files.arm(FileFault::open_fails, 0, FaultyFiles::for_good);
  table.rebuild();
  EXPECT_FALSE(files.disarm());
  EXPECT_EQ(contents(*table.store), before);
}

}  // namespace
}  // namespace foresee
