// Look-ups of objects by their ids, beside an ordinary table of the same rows in the same database. The ids
// come from a prepared query, from IN, from a list, from a range, or from the rows of a join.
#include <cstdio>

#include "files.h"
#include "measure.h"
#include "reports/modes.h"
#include "reports/table.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

struct Answer {
  std::int64_t rows = 0;
  double sum = 0;
  friend bool operator==(const Answer&, const Answer&) = default;
};

/// Our table with an ordinary one beside it, "plain", and ids in two orders: "shuffled" and "rising".
class Tables {
 public:
  Tables(const Workload& w, Medium medium, const std::string& path)
      : table_(Table::foresee, w, medium, path), ids_(w.count) {
    table_.insert_all(writes_of(w));
    Database& db = table_.db();
    db.run("CREATE TABLE plain(id INTEGER PRIMARY KEY, " + columns_of(w) + ")");
    db.run("INSERT INTO plain SELECT * FROM ships ORDER BY id");
    for (const bool rising : {false, true}) {
      ids_ = rising ? sorted(ids_) : drawn(w.count);
      const std::string name = rising ? "rising" : "shuffled";
      db.run("CREATE TABLE " + name + "(id)");
      Statement insert(db, "INSERT INTO " + name + " VALUES(?)");
      db.run("BEGIN");
      for (const std::int64_t id : ids_) insert.bind(1, id), insert.step();
      db.run("COMMIT");
    }
  }

  Database& db() { return table_.db(); }
  std::size_t count() const { return ids_.size(); }

 private:
  /// A fifth of the ids, each as likely as any other; some come twice.
  static std::vector<std::int64_t> drawn(std::size_t count) {
    testing::Random random(19);
    std::vector<std::int64_t> ids(count / 5);
    for (std::int64_t& id : ids) id = static_cast<std::int64_t>(1 + random.below(count));
    return ids;
  }
  static std::vector<std::int64_t> sorted(std::vector<std::int64_t> ids) {
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  Table table_;
  std::vector<std::int64_t> ids_;
};

/// One query repeated, each time with the next id of a list.
double seconds_of_prepared(Tables& tables, const std::string& list, const std::string& table,
                           Answer& answer) {
  Statement ids(tables.db(), "SELECT id FROM " + list);
  Statement find(tables.db(), "SELECT x FROM " + table + " WHERE id = ?");
  std::vector<std::int64_t> wanted;
  while (ids.step()) wanted.push_back(ids.integer(0));
  return seconds_of([&] {
    for (const std::int64_t id : wanted) {
      find.bind(1, id);
      while (find.step()) ++answer.rows, answer.sum += find.number(0);
    }
  });
}

/// A prepared query with a first id, repeated for `queries` of the shuffled ids. Requires: one column.
double seconds_of_ranges(Tables& tables, std::string sql, const std::string& table, std::size_t queries,
                         Answer& answer) {
  sql.replace(sql.find("TABLE"), 5, table);
  Statement ids(tables.db(), "SELECT id FROM shuffled LIMIT " + std::to_string(queries)),
      find(tables.db(), sql);
  std::vector<std::int64_t> firsts;
  while (ids.step()) firsts.push_back(ids.integer(0));
  return seconds_of([&] {
    for (const std::int64_t first : firsts) {
      find.bind(1, first);
      while (find.step()) ++answer.rows, answer.sum += find.number(0);
    }
  });
}

/// A query with two columns; TABLE in `sql` stands for the table.
double seconds_of_sql(Tables& tables, std::string sql, const std::string& table, Answer& answer) {
  for (std::size_t at = 0; (at = sql.find("TABLE")) != std::string::npos;) sql.replace(at, 5, table);
  Statement question(tables.db(), sql);
  const double seconds = seconds_of([&] { question.step(); });
  answer = {question.integer(0), question.number(1)};
  return seconds;
}

/// Microseconds per row beyond `alone`, which reads the same rows without the table; `alone` may be empty.
void compare(const std::string& what, std::size_t rows, int repetitions, const char* mark, const auto& query,
             const auto& alone) {
  Comparison times;
  std::vector<double> ratios;
  for (int i = 0; i < repetitions; ++i) {
    Answer of_ours, of_plain;
    const double base = alone(), ours = query("ships", of_ours) - base,
                 plain = query("plain", of_plain) - base;
    if (of_ours != of_plain) throw Error(what + ": the two tables give different answers");
    times.add(ours, plain);
    ratios.push_back(ours / plain);
  }
  const double a_row = 1e6 / static_cast<double>(rows);
  std::printf("%-44s foresee %6.2f   ordinary table %6.2f us   %5.2f times, %5.2f us more (mark: %s)\n",
              what.c_str(), median(times.ours) * a_row, median(times.rivals) * a_row, median(ratios),
              (median(times.ours) - median(times.rivals)) * a_row, mark);
  std::fflush(stdout);
}

void compare_lists(Tables& tables, int repetitions) {
  const auto nothing = [] { return 0.0; };
  for (const std::string list : {"shuffled", "rising"}) {
    const char* mark = list == "rising" ? "0.25 us more" : "1.5 times";
    compare(
        "id = ?, " + list, tables.count(), repetitions, mark,
        [&](const char* table, Answer& answer) { return seconds_of_prepared(tables, list, table, answer); },
        nothing);
    Answer unused;
    compare(
        "list joined by id, " + list, tables.count(), repetitions, mark,
        [&](const char* table, Answer& answer) {
          return seconds_of_sql(
              tables, "SELECT count(*), sum(s.x) FROM " + list + " l CROSS JOIN TABLE s ON s.id = l.id",
              table, answer);
        },
        [&] { return seconds_of_sql(tables, "SELECT count(*), sum(id) FROM " + list, "", unused); });
  }
  compare(
      "id IN (SELECT id FROM list)", tables.count(), repetitions, "0.25 us more",
      [&](const char* table, Answer& answer) {
        return seconds_of_sql(tables,
                              "SELECT count(*), sum(x) FROM TABLE WHERE id IN (SELECT id FROM shuffled)",
                              table, answer);
      },
      nothing);
}

/// Ranges of a hundred ids, beside the ordinary table and beside a scan of ours, which `+id` prescribes.
void compare_ranges(Tables& tables, int repetitions) {
  constexpr std::size_t queries = 1000, scans = 3, ids = 100;
  const std::string range = "SELECT x FROM TABLE WHERE id BETWEEN ?1 AND ?1 + 99",
                    page = "SELECT x FROM TABLE WHERE id >= ?1 ORDER BY id LIMIT 100";
  for (const std::string& sql : {range, page})
    compare(
        sql == range ? "id BETWEEN ? AND ? + 99" : "id >= ? ORDER BY id LIMIT 100", queries * ids,
        repetitions, "0.25 us more",
        [&](const char* table, Answer& answer) {
          return seconds_of_ranges(tables, sql, table, queries, answer);
        },
        [] { return 0.0; });
  Comparison times;
  for (int i = 0; i < repetitions; ++i) {
    Answer by_ids, by_scan;
    const double ours = seconds_of_ranges(tables, range, "ships", scans, by_ids),
                 scan = seconds_of_ranges(tables, "SELECT x FROM TABLE WHERE +id BETWEEN ?1 AND ?1 + 99",
                                          "ships", scans, by_scan);
    if (by_ids.rows != by_scan.rows) throw Error("a range of ids and a scan give different rows");
    times.add(ours, scan);
  }
  std::printf("a range of 100 ids                           foresee %6.1f us   by a scan %8.0f us   %5.0fx\n",
              median(times.ours) * 1e6 / scans, median(times.rivals) * 1e6 / scans, median(times.ratios));
  std::fflush(stdout);
}

void compare_joins(Tables& tables, int h, int repetitions) {
  const std::string join = " FROM predictive_join(" + std::to_string(h) + ", 'ships') j";
  Answer pairs;
  const auto alone = [&] {
    return seconds_of_sql(tables, "SELECT count(*), sum(j.a + j.b)" + join, "", pairs);
  };
  const double seconds = alone();
  std::printf("join alone: %lld pairs, %.2f s\n", static_cast<long long>(pairs.rows), seconds);
  const auto rows = static_cast<std::size_t>(pairs.rows);
  const std::string one = " CROSS JOIN TABLE p ON p.id = j.a", other = " CROSS JOIN TABLE q ON q.id = j.b";
  for (const bool both : {false, true})
    compare(
        both ? "pairs joined by id on both sides" : "pairs joined by id on one side", rows, repetitions,
        "1.5 times",
        [&](const char* table, Answer& answer) {
          return seconds_of_sql(tables,
                                both ? "SELECT count(*), sum(p.x - q.x + j.a + j.b)" + join + one + other
                                     : "SELECT count(*), sum(p.x + j.a + j.b)" + join + one,
                                table, answer);
        },
        alone);
}

}  // namespace

void measure_lookups(const Options& options) {
  const bool quick = options.has("--quick");
  const int repetitions = quick ? 1 : 3;
  for (const std::string& name : options.names({quick ? "S-100000" : "S-1000000"}))
    for (const Medium medium : mediums_of(options, {Medium::memory})) {
      const TwoFiles files;
      const Workload w = make_workload(name);
      std::printf("look-ups, %s, %s\n", name.c_str(), name_of(medium));
      Tables tables(w, medium, files.ours);
      compare_lists(tables, repetitions);
      compare_ranges(tables, repetitions);
      compare_joins(tables, 11, repetitions);
    }
}

}  // namespace foresee::bench
