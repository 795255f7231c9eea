// The speed marks through SQL: foresee against base table + R*Tree + exact test as an SQL function, in one
// process.
//
//   bench_sql_marks [--quick] [--joins | --loads | --updates]
//
//   join  S-100000: SELECT a, b, t FROM predictive_join(3), all rows stepped, warm; both tables exist before.
//         Then the count of rows, and the ten pairs that touch first, beside the rival's whole join.
//   load  S-1000000: as many prepared single-row INSERTs in one transaction, in memory and into a file.
//         (--quick: 300,000.) Then the size of the file, and the peak memory of a process that loads it.
//   update  S-100000 and S-1000000: 100,000 random objects move on by up to half a unit, prepared single-row
//         UPDATEs in one transaction, into a file. (--quick: S-100000.) Then the join of the table that has
//         been updated, beside that of a fresh one of the same objects.
//
// Processor time, medians; a ratio is the rival's time over ours in the same repetition. Fails if the two
// joins differ in a pair or a time.
#include <cstdio>
#include <random>
#include <string>

#include "files.h"
#include "measure.h"
#include "program.h"
#include "sql_ours.h"
#include "sql_rival.h"

namespace foresee::bench {
namespace {

struct Row {
  std::int64_t a, b;
  double t;

  friend auto operator<=>(const Row&, const Row&) = default;
};

std::vector<Row> rows_of(Statement& statement) {
  std::vector<Row> rows;
  while (statement.step()) rows.push_back({statement.integer(0), statement.integer(1), statement.number(2)});
  return rows;
}

/// Medians of both times and of their ratio.
void print(const std::string& what, const Comparison& times, std::size_t count, double mark) {
  const double per_object = 1e9 / static_cast<double>(count);
  std::printf("%-24s foresee %7.0f   rival %7.0f ns per object   %6.2fx (mark: %gx)\n", what.c_str(),
              median(times.ours) * per_object, median(times.rivals) * per_object, median(times.ratios), mark);
  std::fflush(stdout);
}

/// False if the two answers differ.
bool compare_joins(std::size_t count, int repetitions) {
  const Workload w = make_workload("S-" + std::to_string(count));
  Database db(":memory:");
  create_ours(db, w);
  load_ours(db, w);
  Rival rival(db, w);
  rival.load();
  Statement our_join(db, "SELECT a, b, t FROM predictive_join(3)");
  Statement rival_join(db, rival.join_sql());
  std::vector<Row> our_rows = rows_of(our_join), rival_rows = rows_of(rival_join);  // also warms up
  std::sort(our_rows.begin(), our_rows.end());
  std::sort(rival_rows.begin(), rival_rows.end());
  if (our_rows != rival_rows) return false;

  Statement our_count(db, "SELECT count(*) FROM predictive_join(3)");
  Statement our_first(db, "SELECT a, b, t FROM predictive_join(3) WHERE dt > 0 ORDER BY t LIMIT 10");
  Comparison all, number, first;
  for (int i = 0; i < repetitions; ++i) {
    const double ours = seconds_of([&] { our_join.step_all(); }),
                 counted = seconds_of([&] { our_count.step_all(); }),
                 earliest = seconds_of([&] { our_first.step_all(); }),
                 rivals = seconds_of([&] { rival_join.step_all(); });
    all.add(ours, rivals), number.add(counted, rivals), first.add(earliest, rivals);
  }
  print("join " + w.name, all, count, 22);
  print("  count(*)", number, count, 34);
  print("  first ten", first, count, 60);
  std::printf("  %zu rows, equal\n", our_rows.size());
  return true;
}

void print_sizes(const std::string& ours, const std::string& theirs, std::size_t count) {
  const auto per_object = [count](const std::string& path) {
    return static_cast<double>(std::filesystem::file_size(path)) / static_cast<double>(count);
  };
  std::printf("%-24s foresee %7.1f   rival %7.1f bytes per object\n", "file", per_object(ours),
              per_object(theirs));
}

/// The objects of a table as they are now.
Workload stored(Database& db, const Workload& w) {
  Workload now = w;
  now.rows.clear();
  Statement all(db, "SELECT " + columns_of(w) + " FROM ships ORDER BY id");
  while (all.step())
    for (int k = 0; k < w.bodies().at.size; ++k) now.rows.push_back(all.number(k));
  return now;
}

/// The ratio of the join's time after updates to that of a fresh table.
void compare_with_fresh(Database& updated, const Workload& w, int repetitions) {
  Database fresh(":memory:");
  create_ours(fresh, w);
  load_ours(fresh, stored(updated, w));
  const std::string sql = "SELECT a, b, t FROM predictive_join(3)";
  Statement of_updated(updated, sql), of_fresh(fresh, sql);
  std::vector<double> ratios;
  for (int i = 0; i <= 3 * repetitions; ++i) {
    const double seconds = seconds_of([&] { of_updated.step_all(); }),
                 as_fresh = seconds_of([&] { of_fresh.step_all(); });
    if (i > 0) ratios.push_back(as_fresh / seconds);
  }
  std::printf("  then the join of %s, fresh / updated %.2fx (mark: 0.87x)\n", w.name.c_str(), median(ratios));
}

void compare_updates(std::size_t count, int repetitions) {
  constexpr int updates = 100000;
  const Workload w = make_workload("S-" + std::to_string(count));
  const TwoFiles files;
  Database our_db(files.ours), rival_db(files.theirs);
  create_ours(our_db, w);
  load_ours(our_db, w);
  Rival rival(rival_db, w);
  rival.load();
  Statement move(our_db, "UPDATE ships SET x = ?, y = ? WHERE id = ?");
  Statement object(rival_db, Rival::move_object_sql), box(rival_db, Rival::move_box_sql);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> by(-0.5, 0.5);
  const auto in_one_transaction = [&](Database& db, auto one) {
    return seconds_of([&] {
      db.run("BEGIN");
      for (int i = 0; i < updates; ++i) one(random() % w.count, by(random), by(random));
      db.run("COMMIT");
    });
  };
  Comparison comparison;
  for (int i = 0; i < repetitions; ++i) {
    const double our_seconds = in_one_transaction(our_db, [&](std::size_t row, double dx, double dy) {
      move.bind(1, w.bodies().row(row)[0] + dx);
      move.bind(2, w.bodies().row(row)[1] + dy);
      move.bind(3, static_cast<std::int64_t>(row + 1));
      move.step();
    });
    comparison.add(our_seconds, in_one_transaction(rival_db, [&](std::size_t row, double dx, double dy) {
                     rival.move(object, box, row, dx, dy);
                   }));
  }
  print("update " + w.name, comparison, updates, 4);
  compare_with_fresh(our_db, w, repetitions);
}

/// In children of a process that has not done much, so that their memory is theirs.
void print_memory_of_load(const Workload& w) {
  const double idle = peak_of([&] {
    const TwoFiles files;
    Database db(files.ours);
    create_ours(db, w);
  });
  const double loading = peak_of([&] {
    const TwoFiles files;
    Database db(files.ours);
    create_ours(db, w);
    load_ours(db, w);
  });
  std::printf("%-24s foresee %7.1f MB at most, beyond an empty table\n",
              ("load " + w.name + ", file").c_str(), (loading - idle) / 1e6);
}

void compare_loads(std::size_t count, int repetitions, bool into_file) {
  const Workload w = make_workload("S-" + std::to_string(count));
  if (into_file) print_memory_of_load(w);
  Comparison comparison;
  for (int i = 0; i < repetitions; ++i) {
    const TwoFiles files;
    Database our_db(into_file ? files.ours : ":memory:"), rival_db(into_file ? files.theirs : ":memory:");
    create_ours(our_db, w);
    Rival rival(rival_db, w);
    const double our_seconds = seconds_of([&] { load_ours(our_db, w); });
    comparison.add(our_seconds, seconds_of([&] { rival.load(); }));
    if (into_file && i == 0) print_sizes(files.ours, files.theirs, w.count);
  }
  print("load " + w.name + (into_file ? ", file" : ", memory"), comparison, count, 6);
}

int main_of(const Options& options) {
  const bool quick = options.has("--quick"), joins = options.has("--joins"), loads = options.has("--loads"),
             updates = options.has("--updates"), all = !joins && !loads && !updates;
  if (all || loads)
    for (bool into_file : {true, false}) compare_loads(quick ? 300000 : 1000000, quick ? 1 : 3, into_file);
  if ((all || joins) && !compare_joins(100000, quick ? 5 : 15)) {
    std::fprintf(stderr, "the two joins differ\n");
    return 1;
  }
  if (all || updates) {
    compare_updates(100000, quick ? 1 : 5);
    if (!quick) compare_updates(1000000, 3);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
