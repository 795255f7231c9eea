// Small queries through SQL: windows and nearest neighbours, and the first row after opening a file.
//
//   bench_sql_questions [--quick]
//
//   window  S-100000, S-1000000 and D-100000: prepared windows of about 100 objects over the next 3 seconds,
//           ids only and with t, against base table + R*Tree of swept boxes + a textbook's test in plain
//           double as an SQL function. Both are loaded in memory before.
//   nearest the 10 nearest during the next 3 seconds (the R*Tree has no such query).
//   open    S-10000, S-100000 and S-1000000 in files: open, query one window, read one row. Warm file cache.
//
// Processor time, medians; a ratio is the rival's time over ours in the same repetition. Fails if a window
// holds other objects there than here. (--quick: without S-1000000.)
#include <cmath>
#include <cstdio>
#include <random>

#include "files.h"
#include "measure.h"
#include "plain_shapes.h"
#include "program.h"
#include "sql_ours.h"
#include "sql_rival.h"

namespace foresee::bench {
namespace {

constexpr double window_side = 33;  // about 100 objects in S

/// The first time at which a box (x, y, vx, vy, ax, ay, hx, hy) touches the window (x0, x1, y0, y1) within h
/// seconds. Candidates are `now` and the times at which a side of the box passes one of the window; the
/// earliest at which all sides overlap is returned. NULL: never.
void first_in_window(sqlite3_context* context, int, sqlite3_value** values) {
  double in[13];
  for (int i = 0; i < 13; ++i) in[i] = sqlite3_value_double(values[i]);
  const double h = in[12];
  // Four sides: c + b s + a s²/2 <= 0 inside.
  double c[4], b[4], a[4], first[9] = {0};
  int instants = 1;
  for (int side = 0; side < 4; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 ? 1 : -1;
    c[side] = sign * (in[axis] - in[8 + side]) - in[6 + axis];
    b[side] = sign * in[2 + axis], a[side] = sign * in[4 + axis];
    const double root = b[side] * b[side] - 2 * a[side] * c[side];
    if (root < 0) continue;  // never passes
    const double q = -(b[side] + std::copysign(std::sqrt(root), b[side]));
    for (const double s : {q / a[side], 2 * c[side] / q})
      if (s >= 0 && s <= h) first[instants++] = s;
  }
  double earliest = HUGE_VAL;
  for (int i = 0; i < instants; ++i) {
    bool inside = first[i] < earliest;
    for (int side = 0; side < 4 && inside; ++side)
      inside = c[side] + first[i] * (b[side] + 0.5 * a[side] * first[i]) <= 1e-9;
    if (inside) earliest = first[i];
  }
  if (earliest <= h) sqlite3_result_double(context, earliest);
}

/// The same for a disc (x, y, vx, vy, ax, ay, r).
void first_disc_in_window(sqlite3_context* context, int, sqlite3_value** values) {
  static const Offsets at_box = row_offsets({2, Law::accelerated, Shape::box});
  static const Offsets at_disc = row_offsets({2, Law::accelerated, Shape::ball});
  double in[12];
  for (int i = 0; i < 12; ++i) in[i] = sqlite3_value_double(values[i]);
  const double* side = in + 7;
  const double window[] = {0.5 * (side[0] + side[1]), 0.5 * (side[2] + side[3]), 0, 0, 0, 0,
                           0.5 * (side[1] - side[0]), 0.5 * (side[3] - side[2])};
  const double first = BoxAndDisc<2>(at_box, at_disc, in[11]).first<true>(window, in);
  if (first >= 0) sqlite3_result_double(context, first);
}

/// LIMIT -1 keeps SQLite from calling the function twice.
std::string rival_sql(const Workload& w, bool with_t) {
  const std::string first = (w.layout.shape == Shape::box ? "first_in_window(" : "first_disc_in_window(") +
                            columns_of(w) + ", ?1, ?2, ?3, ?4, 3)";
  const std::string found =
      " FROM boxes i CROSS JOIN base p WHERE i.x0 <= ?2 AND i.x1 >= ?1 AND i.y0 <= ?4 AND i.y1 >= ?3"
      " AND p.id = i.id";
  return with_t
             ? "SELECT id, t FROM (SELECT p.id, " + first + " AS t" + found + " LIMIT -1) WHERE t IS NOT NULL"
             : "SELECT p.id" + found + " AND " + first + " IS NOT NULL";
}

const char* our_sql(bool with_t) {
  return with_t ? "SELECT id, t FROM predictive_window(3, 'ships', ?1, ?2, ?3, ?4)"
                : "SELECT id FROM predictive_window(3, 'ships', ?1, ?2, ?3, ?4)";
}

/// Both tables of one workload.
struct Tables {
  Tables(const Workload& w, const std::string& ours, const std::string& theirs)
      : our_db(ours), rival_db(theirs), rival(rival_db, w) {
    create_ours(our_db, w);
    load_ours(our_db, w);
    rival.load();
  }

  Database our_db, rival_db;
  Rival rival;
};

void add_rival_functions(Database& db) {
  constexpr int flags = SQLITE_UTF8 | SQLITE_DETERMINISTIC;
  db.require_ok(sqlite3_create_function(db.handle(), "first_in_window", 13, flags, nullptr, first_in_window,
                                        nullptr, nullptr));
  db.require_ok(sqlite3_create_function(db.handle(), "first_disc_in_window", 12, flags, nullptr,
                                        first_disc_in_window, nullptr, nullptr));
}

class Places {
 public:
  explicit Places(std::size_t count) : random_(11), place_(0, std::sqrt(14.0 * static_cast<double>(count))) {}
  double next() { return place_(random_); }

 private:
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> place_;
};

struct Answer {
  std::int64_t rows = 0, ids = 0;
  friend bool operator==(const Answer&, const Answer&) = default;
};

Answer answer_of(Statement& window, double x, double y) {
  window.bind(1, x), window.bind(2, x + window_side), window.bind(3, y), window.bind(4, y + window_side);
  Answer answer;
  while (window.step()) ++answer.rows, answer.ids += window.integer(0);
  return answer;
}

/// The marks are those of boxes.
bool has_marks(const Workload& w) {
  return w.layout.shape == Shape::box;
}

void print(const std::string& what, const Workload& w, double ours, double rivals, double ratio,
           double mark) {
  std::printf("%-28s foresee %8.1f   rival %8.1f us   %6.2fx", what.c_str(), ours * 1e6, rivals * 1e6, ratio);
  if (has_marks(w)) std::printf(" (mark: %gx)", mark);
  std::printf("\n");
  std::fflush(stdout);
}

bool compare_windows(Tables& tables, const Workload& w, int repetitions) {
  constexpr int windows = 1000;
  add_rival_functions(tables.rival_db);
  for (const bool with_t : {false, true}) {
    Statement ours(tables.our_db, our_sql(with_t)), rivals(tables.rival_db, rival_sql(w, with_t));
    std::vector<double> our_times, rival_times, ratios;
    std::int64_t rows = 0;
    for (int i = 0; i < repetitions; ++i) {
      std::vector<Answer> here, there;
      const auto run = [&](Statement& statement, std::vector<Answer>& answers) {
        Places places(w.count);
        return seconds_of([&] {
          for (int k = 0; k < windows; ++k) {
            const double x = places.next(), y = places.next();
            answers.push_back(answer_of(statement, x, y));
          }
        });
      };
      our_times.push_back(run(ours, here) / windows);
      rival_times.push_back(run(rivals, there) / windows);
      ratios.push_back(rival_times.back() / our_times.back());
      if (here != there) return false;
      rows = 0;
      for (const Answer& answer : here) rows += answer.rows;
    }
    print("window " + w.name + (with_t ? ", id and t" : ", id"), w, median(our_times), median(rival_times),
          median(ratios), 2.5);
    std::printf("  %.1f rows a window, equal\n", static_cast<double>(rows) / windows);
  }
  return true;
}

void measure_nearest(Tables& tables, const Workload& w, int repetitions) {
  constexpr int questions = 1000;
  Statement nearest(tables.our_db, "SELECT id, distance FROM predictive_nearest(3, 'ships', 10, ?1, ?2)");
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    Places places(w.count);
    times.push_back(seconds_of([&] {
                      for (int k = 0; k < questions; ++k) {
                        nearest.bind(1, places.next()), nearest.bind(2, places.next());
                        while (nearest.step()) {
                        }
                      }
                    }) /
                    questions);
  }
  std::printf("%-28s foresee %8.1f us: %.0f queries per second%s\n", ("nearest 10, " + w.name).c_str(),
              median(times) * 1e6, 1 / median(times), has_marks(w) ? " (mark: 20000)" : "");
}

/// From opening the file to the first row of a window.
void compare_opening(const Workload& w, int repetitions) {
  const TwoFiles files;
  { Tables tables(w, files.ours, files.theirs); }
  std::vector<double> our_times, rival_times, ratios;
  const auto first_row = [&](const std::string& path, bool is_ours) {
    return seconds_of([&] {
      Database db(path);
      if (is_ours)
        register_foresee(db);
      else
        add_rival_functions(db);
      Statement window(db, is_ours ? our_sql(true) : rival_sql(w, true));
      const double x = 0.4 * std::sqrt(14.0 * static_cast<double>(w.count));
      window.bind(1, x), window.bind(2, x + window_side), window.bind(3, x), window.bind(4, x + window_side);
      window.step();
    });
  };
  for (int i = 0; i < repetitions; ++i) {
    our_times.push_back(first_row(files.ours, true));
    rival_times.push_back(first_row(files.theirs, false));
    ratios.push_back(rival_times.back() / our_times.back());
  }
  print("first row, " + w.name, w, median(our_times), median(rival_times), median(ratios), 0.5);
}

int main_of(const Options& options) {
  const bool quick = options.has("--quick");
  for (const std::string name : {"S-10000", "S-100000", "S-1000000", "D-100000"}) {
    if (quick && name == "S-1000000") continue;
    const Workload w = make_workload(name);
    if (w.count > 10000) {
      Tables tables(w, ":memory:", ":memory:");
      if (!compare_windows(tables, w, quick ? 3 : 9)) {
        std::fprintf(stderr, "%s: the windows differ\n", name.c_str());
        return 1;
      }
      measure_nearest(tables, w, quick ? 3 : 9);
    }
    if (w.layout.shape == Shape::box) compare_opening(w, quick ? 9 : 25);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
