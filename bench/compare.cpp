// foresee beside other methods that join moving objects, from 10^3 to 10^6 of them: what each costs to build, to
// keep up to date, to join, and in memory.
//
//   bench_compare [--quick] [--csv FILE] [--export FOLDER] [--ships FILE] [objects ...]
//
// Scenes: U-<objects> (workloads.h) for 10^3, 10^4, 10^5 and 10^6 objects (--quick: to 10^5), and, with
// --ships, real ships within half a nautical mile in ten minutes. Contestants: compare/contestant.h.
//
//   build    from objects in an array to an index or a table that can be joined
//   join     all pairs (a, b, t); a median of joins of a table that has been read. At the first size at which
//            it takes more than 60 seconds (--quick: 10) a contestant stops
//   report   100,000 random objects, at most every one, get another position and velocity, up to half a unit
//            away on each axis: one transaction. A contestant for which they take longer than that gets fewer
//   after    the first join after the reports
//   memory   what build and join add to a process with the objects, at most
//
// Processor time of one thread, each contestant and scene in a process of its own. The program fails if
// contestants differ in a pair, before or after the reports; time stepping may miss pairs, and none else.
// --export writes each scene, its reports and its checksums for contestants of other languages (duckdb/).
#include <malloc.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include "compare/contestant.h"
#include "compare/ships.h"
#include "measure.h"
#include "program.h"

namespace foresee::bench {
namespace {

constexpr std::size_t max_reports = 100000;

struct Move {
  std::uint32_t row;
  double dx, dy, dvx, dvy;

  Report of(const double* row_of_scene) const {
    return {row_of_scene[0] + dx, row_of_scene[1] + dy, row_of_scene[2] + dvx, row_of_scene[3] + dvy};
  }
};

/// At most one report per object.
std::vector<Move> moves_of(const Workload& w) {
  std::mt19937_64 random(7);
  std::vector<Move> moves(w.count);
  for (std::uint32_t row = 0; row < w.count; ++row) moves[row].row = row;
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (std::size_t i = 0; i < w.count; ++i) {
    std::swap(moves[i], moves[i + random() % (w.count - i)]);
    Move& move = moves[i];
    for (double* const by : {&move.dx, &move.dy, &move.dvx, &move.dvy}) *by = unit() - 0.5;
  }
  moves.resize(std::min(w.count, max_reports));
  return moves;
}

struct Measured {
  double build = 0, join = 0, report = 0, join_after = 0, bytes = 0;  ///< seconds; report: per report
  bool stopped = false;                                               ///< the join took too long
  bool compared_after = false;                                        ///< all reports are in
  Answer before = {}, after = {};  ///< of the join, and of that after the reports
};

/// The median of some joins; the first only warms up if it is short.
double seconds_of_joins(Contestant& contestant, Answer& answer) {
  std::vector<double> seconds;
  const double first = seconds_of([&] { answer = contestant.join(); });
  if (first > 2) return first;
  for (double sum = 0; seconds.size() < 3 || (sum < 0.5 && seconds.size() < 25); sum += seconds.back())
    seconds.push_back(seconds_of([&] { answer = contestant.join(); }));
  return median(seconds);
}

/// Runs in a process of its own.
void measure(const ContestantKind& kind, const Workload& scene, double limit, Measured& out) {
  Workload objects = scene;
  const std::unique_ptr<Contestant> contestant = kind.make(objects);
  const std::vector<Move> moves = moves_of(scene);
  malloc_trim(0);
  Resident::forget_peak();
  const double resident = Resident::now();
  out.build = seconds_of([&] { contestant->build(); });
  out.bytes = Resident::peak() - resident;
  // The join in a child, so that one that takes too long can be ended and the reports still measured.
  out.stopped = !run_in_child(
      [&] {
        Resident::forget_peak();
        out.join = seconds_of_joins(*contestant, out.before);
        out.bytes = std::max(out.bytes, Resident::peak() - resident);
      },
      limit);
  if (!kind.takes_reports) return;
  if (!out.stopped) contestant->join();  // the reports come to a table that has been read
  std::size_t reported = 0;
  const double begin = cpu_seconds();
  contestant->begin();
  for (; reported < moves.size() && (reported % 64 != 0 || cpu_seconds() - begin < limit); ++reported) {
    const Move& move = moves[reported];
    contestant->report(move.row, move.of(objects.bodies().row(move.row)));
  }
  contestant->commit();
  out.report = (cpu_seconds() - begin) / static_cast<double>(reported);
  out.compared_after = !out.stopped && reported == moves.size();
  if (out.compared_after) out.join_after = seconds_of([&] { out.after = contestant->join(); });
}

/// Throws Error if `found` is not what a contestant of this kind must find.
void require_agreement(const ContestantKind& kind, const Answer& found, const Answer& truth) {
  if (kind.misses_pairs ? found.pairs <= truth.pairs : found.same_as(truth)) return;
  throw Error(std::string(kind.name) + " finds other pairs than foresee: " + std::to_string(found.pairs) +
              " in place of " + std::to_string(truth.pairs));
}

class Table {
 public:
  Table(const std::optional<std::string>& path, double limit)
      : csv_(path ? std::fopen(path->c_str(), "w") : nullptr), limit_(limit) {
    if (csv_)
      std::fprintf(
          csv_,
          "scene,objects,method,build_s,join_s,over_s,report_s,join_after_s,memory_bytes,pairs,missed\n");
  }
  ~Table() {
    if (csv_) std::fclose(csv_);
  }
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  void add(const Workload& scene, const ContestantKind& kind, const Measured& m, const Answer& truth) {
    const double missed = m.stopped || truth.pairs == 0
                              ? 0
                              : 1 - static_cast<double>(m.before.pairs) / static_cast<double>(truth.pairs);
    std::printf("%-10s %-24s", scene.name.c_str(), kind.name);
    kind.keeps_index ? std::printf(" build %10.3f ms", 1e3 * m.build) : std::printf(" build          –   ");
    m.stopped ? std::printf("   join   too long   ") : std::printf("   join %10.3f ms", 1e3 * m.join);
    const bool updated = kind.keeps_index && kind.takes_reports;
    updated ? std::printf("   report %9.3f µs", 1e6 * m.report) : std::printf("   report         –   ");
    if (m.compared_after) std::printf("   then join %10.3f ms", 1e3 * m.join_after);
    std::printf("   memory %8.2f MB", m.bytes / 1e6);
    if (kind.misses_pairs) std::printf("   misses %.2f %%", 100 * missed);
    std::printf("\n");
    std::fflush(stdout);
    if (!csv_) return;
    std::fprintf(csv_, "%s,%zu,%s,", scene.name.c_str(), scene.count, kind.name);
    const auto cell = [&](bool known, double value) {
      known ? std::fprintf(csv_, "%.6g,", value) : std::fprintf(csv_, ",");
    };
    cell(kind.keeps_index, m.build);
    cell(!m.stopped, m.join);
    cell(m.stopped, limit_);
    cell(updated, m.report);
    cell(m.compared_after, m.join_after);
    std::fprintf(csv_, "%.0f,", std::max(0.0, m.bytes));
    m.stopped ? std::fprintf(csv_, ",\n") : std::fprintf(csv_, "%zu,%.6g\n", m.before.pairs, missed);
    std::fflush(csv_);
  }

 private:
  std::FILE* csv_;
  double limit_;
};

/// Three tables of a scene: objects (id and numbers), reports (id, x, y, vx, vy), and the pairs and checksums to find.
void export_scene(const std::string& folder, const Workload& scene, const Measured& m) {
  const std::filesystem::path path = std::filesystem::path(folder) / scene.name;
  std::filesystem::create_directories(path);
  const auto file = [&](const char* name) {
    std::ofstream out(path / name);
    out.precision(17);
    return out;
  };
  std::ofstream objects = file("objects.csv"), reports = file("reports.csv"), expected = file("expected.csv");
  const bool discs = scene.layout.shape == Shape::ball;
  objects << (discs ? "id,x,y,vx,vy,r\n" : "id,x,y,vx,vy,hx,hy\n");
  for (std::size_t i = 0; i < scene.count; ++i) {
    objects << i;
    for (int k = 0; k < scene.bodies().at.size; ++k) objects << ',' << scene.bodies().row(i)[k];
    objects << '\n';
  }
  reports << "id,x,y,vx,vy\n";
  for (const Move& move : moves_of(scene)) {
    const auto [x, y, vx, vy] = move.of(scene.bodies().row(move.row));
    reports << move.row << ',' << x << ',' << y << ',' << vx << ',' << vy << '\n';
  }
  expected << "h,pairs,sum,pairs_after,sum_after,join_s\n"
           << scene.h << ',' << m.before.pairs << ',' << m.before.sum << ',' << m.after.pairs << ','
           << m.after.sum << ',' << m.join << '\n';
}

int main_of(Options options) {
  const bool quick = options.has("--quick");
  const double limit = quick ? 10 : 60;
  Table table(options.value("--csv"), limit);
  const auto folder = options.value("--export"), ships = options.value("--ships");
  using Names = std::vector<std::string>;
  const Names sizes =
      options.names(quick ? Names{"1000", "10000", "100000"} : Names{"1000", "10000", "100000", "1000000"});
  const std::vector<ContestantKind> kinds = contestant_kinds();
  std::map<std::string, bool> stopped;

  const auto compare = [&](const Workload& scene) {
    std::optional<Measured> ours;
    for (const ContestantKind& kind : kinds) {
      if (!kind.accepts(scene) || stopped[kind.name]) continue;
      SharedValue<Measured> measured;
      run_in_child([&] { measure(kind, scene, limit, *measured); });
      if (!ours) ours = *measured;
      if (!measured->stopped) require_agreement(kind, measured->before, ours->before);
      if (measured->compared_after) require_agreement(kind, measured->after, ours->after);
      stopped[kind.name] = measured->stopped;
      table.add(scene, kind, *measured, ours->before);
    }
    if (folder) export_scene(*folder, scene, *ours);
    std::printf("%s: %zu objects, %zu pairs; the same by every contestant that decides each pair\n\n",
                scene.name.c_str(), scene.count, ours->before.pairs);
  };
  if (ships) compare(real_ships(*ships, 463, 600));
  for (const std::string& size : sizes) compare(make_workload("U-" + size));
  return 0;
}

}  // namespace

std::vector<ContestantKind> contestant_kinds() {
  std::vector<ContestantKind> kinds = contestants_in_memory();
  const std::vector<ContestantKind> in_sql = contestants_in_sql();
  kinds.insert(kinds.begin() + 1, in_sql.begin(), in_sql.end());
  return kinds;
}

}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
