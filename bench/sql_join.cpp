// The join through SQL against the self-join of a ready R*Tree in plain SQL, and what SQL adds to the join
// itself.
//
//   bench_sql_join [--quick] [--csv FILE] [workload ...]
//
//   warm    SELECT a, b, t FROM predictive_join(h), all rows stepped; queried before
//   count   SELECT count(*) of the same
//   first   SELECT a, b, t … WHERE dt > 0 ORDER BY t LIMIT 10
//   tree    as warm, method = 'tree'
//   cold    as warm, from opening the file to the last row; operating system's cache warm
//   core    the same pairs and times without SQL, from rows in native memory (no rival)
//
// Processor time, medians; a ratio is the rival's time over ours in the same repetition. Then the peak memory
// of one query in a fresh process, beyond a process that only opens the file. Fails if the results differ.
#include <cstdio>
#include <cstring>

#include "files.h"
#include "measure.h"
#include "program.h"
#include "query/join/join.h"
#include "sql_ours.h"
#include "sql_rival.h"

namespace foresee::bench {
namespace {

struct Row {
  std::int64_t a, b;
  double t;

  friend auto operator<=>(const Row&, const Row&) = default;
};

std::vector<Row> rows_of(Database& db, const std::string& sql) {
  Statement statement(db, sql);
  std::vector<Row> rows;
  while (statement.step()) rows.push_back({statement.integer(0), statement.integer(1), statement.number(2)});
  std::sort(rows.begin(), rows.end());
  return rows;
}

void step_all(Statement& statement) {
  while (statement.step()) {
  }
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// One workload in two files.
struct Files : TwoFiles {
  explicit Files(const Workload& w) : workload(w) {
    Database our_db(ours), rival_db(theirs);
    create_ours(our_db, w);
    load_ours(our_db, w);
    Rival(rival_db, w).load();
  }
  const Workload& workload;
};

struct Question {
  const char* name;
  std::string ours, rivals;
};

std::string our_join(const Workload& w) {
  return "SELECT a, b, t FROM predictive_join(" + number(w.h) + ")";
}

std::vector<Question> questions(const Workload& w, const std::string& rival) {
  const std::string h = number(w.h);
  const std::string ours = our_join(w);
  return {
      {"warm", ours, rival},
      {"count", "SELECT count(*) FROM predictive_join(" + h + ")", "SELECT count(*) FROM (" + rival + ")"},
      {"first", ours + " WHERE dt > 0 ORDER BY t LIMIT 10", rival + " AND t > 0 ORDER BY t LIMIT 10"},
      {"tree", ours + " WHERE method = 'tree'", rival}};
}

/// Medians of both times and of their ratio.
struct Comparison {
  std::vector<double> ours = {}, rivals = {}, ratios = {};

  void add(double our_seconds, double rival_seconds) {
    ours.push_back(our_seconds);
    rivals.push_back(rival_seconds);
    ratios.push_back(rival_seconds / our_seconds);
  }
};

class Report {
 public:
  explicit Report(std::FILE* csv) : csv_(csv) {
    if (csv_) std::fprintf(csv_, "workload,question,ours_ns_per_object,rival_ns_per_object,ratio\n");
  }
  void print(const Workload& w, const char* question, const Comparison& c) {
    const double per_object = 1e9 / static_cast<double>(w.count);
    const double ours = median(c.ours) * per_object, rival = median(c.rivals) * per_object;
    std::printf("%-12s %-6s foresee %8.0f   R*Tree in SQL %9.0f ns per object   %8.2fx\n", w.name.c_str(),
                question, ours, rival, median(c.ratios));
    std::fflush(stdout);
    if (csv_)
      std::fprintf(csv_, "%s,%s,%.1f,%.1f,%.3f\n", w.name.c_str(), question, ours, rival, median(c.ratios));
  }

 private:
  std::FILE* csv_;
};

/// The join without SQL, in seconds; the first run only warms up.
double core_seconds(const Workload& w, int repetitions) {
  NeverInterrupt never;
  const auto space = std::make_shared<GridSpace>();
  auto scene = std::make_shared<Scene>();
  scene->name = w.name, scene->layout = w.layout, scene->rows = w.rows;
  for (std::size_t i = 0; i < w.count; ++i) scene->ids.push_back(static_cast<std::int64_t>(i + 1));
  std::vector<double> seconds;
  for (int i = 0; i <= repetitions; ++i) {
    const double once = seconds_of([&] {
      Join join({.a = scene, .h = w.h, .wants = {.ends = false, .approach = false}, .space = space}, never);
      while (!join.next().empty()) {
      }
    });
    if (i > 0) seconds.push_back(once);
  }
  return median(seconds);
}

/// In children of a process that has not loaded anything yet, so that their memory is theirs.
void print_memory(const Files& files, const std::string& sql) {
  const auto run = [&](const std::string& question) {
    Database db(files.ours);
    register_foresee(db);
    Statement statement(db, question);
    step_all(statement);
  };
  const double idle = peak_of([&] { run("SELECT id FROM ships WHERE id = 1"); });
  const double queried = peak_of([&] { run(sql); });
  std::printf("%-12s memory %.0f bytes per object, beyond a process that has opened the file\n",
              files.workload.name.c_str(), (queried - idle) / static_cast<double>(files.workload.count));
}

/// False if the answers differ.
bool compare(const Workload& w, bool quick, Report& report) {
  const Files files(w);
  print_memory(files, our_join(w));
  Database our_db(files.ours), rival_db(files.theirs);
  register_foresee(our_db);
  Rival rival(rival_db, w, Rival::stands_ready);
  bool agree = true;
  const int rival_runs = quick || w.h > 3 || w.count > 100000 || w.name.starts_with("M") ? 1 : 5;
  for (const Question& question : questions(w, rival.join_sql())) {
    if (std::strcmp(question.name, "warm") == 0)
      agree = rows_of(our_db, question.ours) == rows_of(rival_db, question.rivals);
    Statement ours(our_db, question.ours), theirs(rival_db, question.rivals);
    Comparison comparison;
    for (int i = 0; i < rival_runs; ++i) {
      std::vector<double> runs;
      for (int run = 0; run < 3; ++run) runs.push_back(seconds_of([&] { step_all(ours); }));
      comparison.add(median(runs), seconds_of([&] { step_all(theirs); }));
    }
    report.print(w, question.name, comparison);
  }
  Comparison cold;
  for (int i = 0; i < (quick ? 1 : 3); ++i) {
    const double ours = seconds_of([&] {
      Database db(files.ours);
      register_foresee(db);
      Statement join(db, our_join(w));
      step_all(join);
    });
    cold.add(ours, seconds_of([&] {
               Database db(files.theirs);
               Rival ready(db, w, Rival::stands_ready);
               Statement join(db, ready.join_sql());
               step_all(join);
             }));
    if (w.h > 3 || w.count > 100000) break;
  }
  report.print(w, "cold", cold);
  const double core = core_seconds(w, 5);
  std::printf("%-12s core   foresee %8.0f ns per object\n", w.name.c_str(),
              core * 1e9 / static_cast<double>(w.count));
  return agree;
}

int main_of(Options options) {
  const bool quick = options.has("--quick");
  const auto csv_path = options.value("--csv");
  std::FILE* csv = csv_path ? std::fopen(csv_path->c_str(), "w") : nullptr;
  using Names = std::vector<std::string>;
  const Names usual =
      quick ? Names{"S-100000"} : Names{"S-100000", "S-1000000", "L-30", "M-100000", "D-100000"};
  Report report(csv);
  for (const std::string& name : options.names(usual))
    if (!compare(make_workload(name), quick, report)) {
      std::fprintf(stderr, "%s: the answers differ\n", name.c_str());
      return 1;
    }
  if (csv) std::fclose(csv);
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
