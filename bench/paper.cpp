// The paper's experiments: running time, pairs and prune power against h, v_max, n and a_max, on its scene of
// 10000 x 10000 x 50 with centres uniform, by Zipf's law and in cities, in linear and in accelerated motion.
//
//   bench_paper [--quick] FOLDER          # writes paper.csv, paper_stages.csv and the stages of soldiers
//                                         # there; progress to stderr
//
// Methods: gpcd (reference implementation of the paper), grid (production), sij-tpr and scan (brute force).
// sij-tpr is the synchronous traversal of a loaded TPR-tree with itself; loading is a column of its own. Each
// emits (a, b, t) with the same exact contact, and all must agree. Processor time of one thread; the methods
// take turns, and a figure is the median over the turns. Stages are also those of soldiers (soldiers.h),
// meshes in place of boxes, at the defaults and 5000 objects. --quick: fewer turns, and sweeps of three
// steps.
#include <bit>
#include <cstdio>
#include <functional>
#include <string>

#include "contact/contact.h"
#include "index/memory_pages.h"
#include "index/tpr_tree/search/tree_join.h"
#include "index/tpr_tree/tpr_tree.h"
#include "measure.h"
#include "program.h"
#include "query/join/explain.h"
#include "query/join/join.h"
#include "soldiers.h"
#include "workloads.h"

namespace foresee::bench {
namespace {

NeverInterrupt never;

/// Pairs as a count and a sum that does not depend on their order.
struct Answer {
  std::size_t pairs = 0;
  std::uint64_t sum = 0;

  void add(std::int64_t a, std::int64_t b, double t) {
    const auto low = static_cast<std::uint64_t>(std::min(a, b)),
               high = static_cast<std::uint64_t>(std::max(a, b));
    std::uint64_t mixed = (low << 32 | high) * 0x9e3779b97f4a7c15u ^ std::bit_cast<std::uint64_t>(t);
    mixed ^= mixed >> 29;
    sum += mixed * 0xbf58476d1ce4e5b9u;
    ++pairs;
  }
  bool operator==(const Answer&) const = default;
};

/// One point of a sweep.
struct Setting {
  const char* sweep;
  PaperScene scene;
};

/// A setting's objects, in the form that the methods need.
struct Objects {
  explicit Objects(const PaperScene& paper)
      : workload(paper_workload(paper, "paper")), pages(workload.layout) {
    auto made = std::make_shared<Scene>();
    made->name = "objects";
    made->layout = workload.layout;
    made->rows = workload.rows;
    for (std::size_t i = 0; i < workload.count; ++i) made->ids.push_back(static_cast<std::int64_t>(i));
    scene = made;
  }
  JoinQuestion question(JoinMethod method) const {
    return {.a = scene, .h = workload.h, .method = method, .wants = {true, false, false}};
  }
  void load_tree() {
    make_tpr_tree(pages, workload.h)->bulk_load(scene->ids, workload.rows, never);
    tree = read_tree(pages, never);
  }

  Workload workload;
  std::shared_ptr<const Scene> scene;
  MemoryPages pages;
  TreeScene tree;
};

Answer by_join(const Objects& objects, JoinMethod method) {
  Answer answer;
  Join join(objects.question(method), never);
  for (auto rows = join.next(); !rows.empty(); rows = join.next())
    for (const JoinRow& row : rows) answer.add(row.a, row.b, row.contact.t);
  return answer;
}

Answer by_tree(const Objects& objects) {
  Answer answer;
  const TreeScene& tree = objects.tree;
  const Horizon horizon{0, objects.workload.h};
  const auto candidates = make_tree_join<3>(tree.bodies(), tree.levels, horizon, Vec<3>::zero(), never);
  const auto contact = make_contact(tree.bodies(), tree.bodies(), {.horizon = horizon}, "tree", "tree");
  std::vector<Pair> pairs, hits;
  std::vector<ContactTimes> times;
  for (; candidates->next(pairs); pairs.clear()) {
    hits.clear(), times.clear();
    contact->first_contacts(pairs, TimesWanted::starts, hits, times);
    for (std::size_t i = 0; i < hits.size(); ++i)
      answer.add(tree.ids[hits[i].a], tree.ids[hits[i].b], times[i].t);
  }
  return answer;
}

struct Method {
  const char* name;
  std::function<Answer(const Objects&)> run;
  int share;  ///< takes one turn in `share`
};

const Method methods[] = {
    {"gpcd", [](const Objects& o) { return by_join(o, JoinMethod::gpcd); }, 1},
    {"grid", [](const Objects& o) { return by_join(o, JoinMethod::grid); }, 1},
    {"sij-tpr", by_tree, 1},
    {"scan", [](const Objects& o) { return by_join(o, JoinMethod::scan); }, 4},
};
constexpr std::size_t method_count = std::size(methods);

struct Measured {
  Answer answer;
  double seconds[method_count];
  double load;
};

/// Throws Error if two methods disagree.
Measured measure(Objects& objects, int turns) {
  Measured measured{by_join(objects, JoinMethod::grid), {}, seconds_of([&] { objects.load_tree(); })};
  std::vector<double> seconds[method_count];
  for (int turn = -1; turn < turns; ++turn)  // the first only warms up
    for (std::size_t m = 0; m < method_count; ++m) {
      if (turn < 0 ? methods[m].share > 1 : turn % methods[m].share != 0) continue;
      Answer answer;
      const double taken = seconds_of([&] { answer = methods[m].run(objects); });
      if (answer != measured.answer) throw Error(std::string(methods[m].name) + " disagrees with the grid");
      if (turn >= 0) seconds[m].push_back(taken);
    }
  for (std::size_t m = 0; m < method_count; ++m) measured.seconds[m] = median(seconds[m]);
  return measured;
}

/// The columns that describe the setting.
void print_setting(std::FILE* file, const Setting& s) {
  std::fprintf(file, "%s,%s,%s,%g,%g,%g,%zu", s.sweep, name_of(s.scene.spread).c_str(),
               s.scene.accelerated ? "accelerated" : "linear", s.scene.h, s.scene.v_max,
               s.scene.accelerated ? s.scene.a_max : 0, s.scene.count);
}

class Report {
 public:
  explicit Report(const std::string& folder)
      : times_(open(folder + "/paper.csv")),
        stages_(open(folder + "/paper_stages.csv")),
        soldiers_(open(folder + "/paper_soldiers.csv")) {
    const char* setting = "sweep,spread,motion,h,v_max,a_max,n";
    std::fprintf(times_, "%s,pairs", setting);
    for (const Method& method : methods) std::fprintf(times_, ",%s_ms", method.name);
    std::fprintf(times_, ",load_ms\n");
    for (std::FILE* file : {stages_, soldiers_})
      std::fprintf(file, "%s,stage,before,after,prune_power,ms\n", setting);
  }
  ~Report() {
    std::fclose(times_);
    std::fclose(stages_);
    std::fclose(soldiers_);
  }
  Report(const Report&) = delete;
  Report& operator=(const Report&) = delete;

  void add(const Setting& setting, const Measured& measured, double pairs) {
    print_setting(times_, setting);
    std::fprintf(times_, ",%g", pairs);
    for (double seconds : measured.seconds) std::fprintf(times_, ",%.4f", 1e3 * seconds);
    std::fprintf(times_, ",%.4f\n", 1e3 * measured.load);
  }

  void add(const Setting& setting, const std::vector<ExplainRow>& rows) { add(stages_, setting, rows); }
  void add_soldiers(const Setting& setting, const std::vector<ExplainRow>& rows) {
    add(soldiers_, setting, rows);
  }

 private:
  static void add(std::FILE* file, const Setting& setting, const std::vector<ExplainRow>& rows) {
    for (const ExplainRow& row : rows) {
      print_setting(file, setting);
      std::fprintf(file, ",%s,%llu,%llu,%.4f,%.4f\n", row.stage, static_cast<unsigned long long>(row.before),
                   static_cast<unsigned long long>(row.after), row.prune_power().value_or(0),
                   1e3 * row.seconds);
    }
  }

  static std::FILE* open(const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (file == nullptr) throw Error("cannot write " + path);
    return file;
  }

  std::FILE *times_, *stages_, *soldiers_;
};

std::vector<ExplainRow> explain_boxes(const PaperScene& scene, Interrupt& interrupt) {
  return explain_join(Objects(scene).question(JoinMethod::gpcd), interrupt);
}

/// The stages of `count` scenes like this one, summed.
std::vector<ExplainRow> explain_many(PaperScene scene, std::uint64_t count, decltype(explain_boxes) explain) {
  std::vector<ExplainRow> sum;
  for (scene.seed = 0; scene.seed < count; ++scene.seed) {
    const std::vector<ExplainRow> rows = explain(scene, never);
    if (sum.empty()) sum.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      sum[i] = {rows[i].stage, sum[i].before + rows[i].before, sum[i].after + rows[i].after,
                sum[i].seconds + rows[i].seconds};
  }
  return sum;
}

/// Table 1's ranges: one parameter varies, the others stay at their defaults.
std::vector<Setting> settings(bool quick) {
  std::vector<Setting> all;
  const int step = quick ? 2 : 1;
  for (Spread spread : all_spreads)
    for (bool accelerated : {false, true}) {
      const PaperScene defaults{.spread = spread, .accelerated = accelerated};
      auto add = [&](const char* sweep, auto PaperScene::*parameter, auto value) {
        all.push_back({sweep, defaults});
        all.back().scene.*parameter = value;
      };
      for (int k = 1; k <= 5; k += step) add("h", &PaperScene::h, static_cast<double>(k));
      for (int k = 1; k <= 5; k += step) add("v_max", &PaperScene::v_max, static_cast<double>(k));
      for (int k = 1; k <= 5; k += step) add("n", &PaperScene::count, static_cast<std::size_t>(1000 * k));
      if (accelerated)
        for (int k = 0; k <= 4; k += step) add("a_max", &PaperScene::a_max, 0.5 * k);
    }
  return all;
}

int main_of(const Options& options) {
  const bool quick = options.has("--quick");
  const std::vector<std::string> folder = options.names({});
  if (folder.size() != 1) throw Error("write bench_paper [--quick] FOLDER");
  Report report(folder[0]);
  const std::vector<Setting> all = settings(quick);
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::fprintf(stderr, "\r%zu of %zu settings: %-8s %s      ", i + 1, all.size(), all[i].sweep,
                 name_of(all[i].scene.spread).c_str());
    const std::uint64_t scenes = quick ? 5 : 25;
    const std::vector<ExplainRow> stages = explain_many(all[i].scene, scenes, explain_boxes);
    report.add(all[i], stages);
    Objects objects(all[i].scene);
    report.add(all[i], measure(objects, quick ? 3 : 11),
               static_cast<double>(stages.back().after) / static_cast<double>(scenes));
  }
  for (Spread spread : all_spreads) {
    const Setting soldiers{"soldiers", {.spread = spread, .count = 5000}};
    report.add_soldiers(soldiers, explain_many(soldiers.scene, quick ? 5 : 25, explain_soldiers));
  }
  std::fprintf(stderr, "\n");
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
