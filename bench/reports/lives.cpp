// Queries of a table whose objects come and go and never report: each lives for 50 s. The rival is a table of the same
// rows that was loaded at once.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "measure.h"
#include "reports/modes.h"
#include "scenes.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

constexpr double life = 50;

class Lives {
 public:
  Lives(std::int64_t objects, bool ends)
      : objects_(objects), side_(std::sqrt(14.0 * static_cast<double>(objects))), ends_(ends) {
    register_foresee(db_);
    create("ships");
    db_.run("BEGIN");
    Statement insert(db_, insertion("ships"));
    for (std::int64_t i = 0; i < objects; ++i) add(insert, life * static_cast<double>(i - objects) / count());
    db_.run("COMMIT");
  }

  /// Ends `changed` lives and starts as many; returns the seconds of the transaction.
  double change(std::int64_t changed) {
    now_ += life * static_cast<double>(changed) / count();
    return seconds_of([&] {
      db_.run("BEGIN");
      {
        Statement erase(db_, "DELETE FROM ships WHERE id = ?1"), insert(db_, insertion("ships"));
        for (std::int64_t i = 0; i < changed; ++i) erase.bind(1, first_++), erase.step_all();
        for (std::int64_t i = 0; i < changed; ++i) add(insert, now_);
      }
      db_.run("COMMIT");
    });
  }

  struct Speed {
    double us, ratio;  ///< per query, and the fresh table's time over ours
  };
  /// Of each kind of query.
  std::vector<Speed> queries(int repetitions) {
    create("fresh");
    db_.run("INSERT INTO fresh SELECT * FROM ships");
    std::vector<Speed> speeds;
    const std::string window =
                          "predictive_window WHERE h = 3 AND tbl = '%' AND now = ?1 AND "
                          "x0 = ?2 AND x1 = ?2 + 8 AND y0 = ?3 AND y1 = ?3 + 8",
                      nearest =
                          "predictive_nearest WHERE h = 3 AND tbl = '%' AND now = ?1 AND k = 10 AND "
                          "x = ?2 AND y = ?3";
    for (const std::string& what : {window, nearest}) {
      Comparison times;
      for (int i = 0; i <= repetitions; ++i) {
        std::uint64_t rows[2] = {0, 0};
        const double ours = seconds_of([&] { rows[0] = run(what, "ships"); }),
                     theirs = seconds_of([&] { rows[1] = run(what, "fresh"); });
        if (rows[0] != rows[1]) throw Error("the tables give different rows");
        if (i > 0) times.add(ours, theirs);
      }
      speeds.push_back({1e6 * median(times.ours) / places, median(times.ratios)});
    }
    db_.run("DROP TABLE fresh");
    return speeds;
  }

 private:
  static constexpr int places = 1000;

  double count() const { return static_cast<double>(objects_); }
  void create(const std::string& table) {
    db_.run("CREATE VIRTUAL TABLE " + table + " USING moving_objects(id, t, x, y, vx, vy, hx, hy" +
            (ends_ ? ", until)" : ")"));
  }
  std::string insertion(const std::string& table) const {
    return "INSERT INTO " + table + " VALUES (?1, ?2, ?3, ?4, ?5, ?6, 0.5, 0.5" +
           (ends_ ? ", ?2 + " + std::to_string(life) + ")" : ")");
  }
  void add(Statement& insert, double t) {
    insert.bind(1, next_++), insert.bind(2, t);
    insert.bind(3, random_.in(0, side_)), insert.bind(4, random_.in(0, side_));
    insert.bind(5, random_.in(-3, 3)), insert.bind(6, random_.in(-3, 3));
    insert.step_all();
  }

  /// The sum of all ids found.
  std::uint64_t run(std::string what, const std::string& table) {
    Statement find(db_, "SELECT id FROM " + what.replace(what.find('%'), 1, table));
    testing::Random random(23);
    std::uint64_t sum = 0;
    for (int i = 0; i < places; ++i) {
      find.bind(1, now_), find.bind(2, random.in(0, side_)), find.bind(3, random.in(0, side_));
      while (find.step()) sum += static_cast<std::uint64_t>(find.integer(0));
    }
    return sum;
  }

  std::int64_t objects_, first_ = 0, next_ = 0;
  double side_, now_ = 0;
  bool ends_;
  testing::Random random_{17};
  Database db_{":memory:"};
};

void compare_lives(std::int64_t objects, std::int64_t at_once, bool ends, int repetitions) {
  constexpr int reads = 16;
  Lives lives(objects, ends);
  std::vector<double> seconds, us[2], ratios[2];
  for (std::int64_t done = 0, read = 1; done < 2 * objects; done += at_once) {
    seconds.push_back(lives.change(at_once));
    if (done + at_once < read * 2 * objects / reads) continue;
    ++read;
    const auto speeds = lives.queries(repetitions);
    for (int q = 0; q < 2; ++q) us[q].push_back(speeds[q].us), ratios[q].push_back(speeds[q].ratio);
  }
  double all = 0;
  for (const double one : seconds) all += one;
  std::printf("%lld objects%s that live for %g s, %lld new and %lld gone a transaction, for two lives\n",
              static_cast<long long>(objects), ends ? " with until" : "", life,
              static_cast<long long>(at_once), static_cast<long long>(at_once));
  for (int q = 0; q < 2; ++q)
    std::printf("  %-20s median %6.1f us, %5.2fx the speed of a fresh table; slowest %5.2fx\n",
                q == 0 ? "windows of about 10" : "nearest 10", median(us[q]), median(ratios[q]),
                *std::min_element(ratios[q].begin(), ratios[q].end()));
  std::printf("  transactions         %.1f us per change, median %.2f ms, longest %.2f ms\n",
              1e6 * all / static_cast<double>(4 * objects), 1e3 * median(seconds),
              1e3 * *std::max_element(seconds.begin(), seconds.end()));
  std::fflush(stdout);
}

}  // namespace

void measure_lives(const Options& options) {
  const int repetitions = options.has("--quick") ? 1 : 3;
  compare_lives(10000, 1, false, repetitions);
  compare_lives(10000, 40, false, repetitions);
  compare_lives(10000, 40, true, repetitions);
  if (!options.has("--quick")) compare_lives(100000, 40, false, repetitions);
}

}  // namespace foresee::bench
