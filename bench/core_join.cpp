// The join without SQL: ours with exact contact against the joins of core_rivals.h with a textbook's contact
// in plain double, each emitting (a, b, t). Objects lie in native memory, one thread, warm.
//
//   bench_core_join [--quick] [--csv FILE] [workload ...]
//
// Prints nanoseconds of processor time per object (medians) and ratios to ours of the same repetition.
// A short run follows another of the same method, so that caches hold its own data and not that of the method
// before. After a run of seconds, during which the machine may have changed, ours is run again, and the ratio
// is to that.
//
// "foresee" is the library call of query/join/join.h with method 'auto': it plans, and cuts long horizons
// into slabs. "one grid" is the grid over the whole horizon, one stage after another; "at rest" is ours with
// h = 0. On large scenes ours by the clock follows, alone and with helper threads. The program fails if
// methods differ in a pair; time stepping, which misses pairs, must not have more of them. Stepping is left
// out unless all objects are boxes.
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

#include "contact/contact.h"
#include "core_rivals.h"
#include "exact_answer.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "measure.h"
#include "program.h"
#include "query/join/join.h"

namespace foresee::bench {
namespace {

NeverInterrupt never;
const auto space = std::make_shared<GridSpace>();

struct Stages {
  double enter = 0, candidates = 0, contact = 0;
};

template <int D>
Answer by_grid(const Workload& w, double h, Stages& stages) {
  std::unique_ptr<Candidates> grid;
  const Workload& other = w.second();
  const auto contact = make_contact(w.bodies(), other.bodies(), {.horizon = {0, h}}, w.name, other.name);
  stages = {};
  stages.enter = seconds_of([&] {
    const MovingBoxes<D> others{other.bodies(), {0, h}, Vec<D>::zero()};
    grid = make_gpcd_grid<D>({w.bodies(), {0, h}, Vec<D>::zero()}, w.other ? &others : nullptr, never, space);
  });
  const double begin = cpu_seconds();
  const Answer answer = exact_answer(*grid, *contact, &stages.contact);
  stages.candidates = cpu_seconds() - begin - stages.contact;
  return answer;
}

Answer by_grid(const Workload& w, double h, Stages& stages) {
  return w.layout.axes == 2 ? by_grid<2>(w, h, stages) : by_grid<3>(w, h, stages);
}

std::shared_ptr<const Scene> scene_of(const Workload& w) {
  auto scene = std::make_shared<Scene>();
  scene->name = w.name, scene->layout = w.layout, scene->rows = w.rows;
  for (std::size_t i = 0; i < w.count; ++i) scene->ids.push_back(static_cast<std::int64_t>(i));
  return scene;
}

/// The two sides of a join; b is null for pairs within a.
struct Sides {
  explicit Sides(const Workload& w) : a(scene_of(w)), b(w.other ? scene_of(*w.other) : nullptr) {}
  std::shared_ptr<const Scene> a, b;
};

Answer by_join(const Sides& sides, double h, std::size_t helpers) {
  Answer answer;
  Join join({.a = sides.a,
             .b = sides.b,
             .h = h,
             .wants = {.ends = false, .approach = false},
             .helpers = helpers,
             .space = space},
            never);
  for (auto rows = join.next(); !rows.empty(); rows = join.next())
    for (const JoinRow& row : rows)
      answer.add({static_cast<std::uint32_t>(row.a), static_cast<std::uint32_t>(row.b)}, row.contact.t);
  return answer;
}

/// False if the helpers change the answer.
bool compare_helpers(const Workload& w, const Sides& sides, int repetitions) {
  constexpr std::size_t max_helpers = 2;
  std::vector<double> seconds[max_helpers + 1], processor[max_helpers + 1];
  const Answer alone = by_join(sides, w.h, 0);
  for (int i = 0; i < repetitions; ++i)
    for (std::size_t helpers = 0; helpers <= max_helpers; ++helpers) {
      const auto begin = std::chrono::steady_clock::now();
      const double processor_begin = cpu_seconds();
      if (!by_join(sides, w.h, helpers).same_as(alone)) return false;
      processor[helpers].push_back(cpu_seconds() - processor_begin);
      seconds[helpers].push_back(
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
  for (std::size_t helpers = 0; helpers <= max_helpers; ++helpers)
    std::printf(
        "    %zu helpers: %8.1f ms by the clock (%.2fx as fast as alone), %8.1f ms of processor time\n",
        helpers, 1000 * median(seconds[helpers]), median(seconds[0]) / median(seconds[helpers]),
        1000 * median(processor[helpers]));
  std::printf("\n");
  return true;
}

struct Method {
  const char* name;
  std::function<Answer()> join;
  enum Kind { same_pairs, at_rest, misses_pairs } kind = same_pairs;
  std::vector<double> seconds = {}, ratios = {};
  Answer answer = {};
  double warm_up = 0;  // time of the first run
};

/// Ours first. Methods that would take minutes are left out.
std::vector<Method> methods_for(const Workload& w, const Sides& sides, Stages& stages, bool quick) {
  std::vector<Method> methods{
      {"foresee", [&] { return by_join(sides, w.h, 0); }},
      {"at rest", [&] { return by_join(sides, 0, 0); }, Method::at_rest},
      {"one grid", [&] { return by_grid(w, w.h, stages); }},
      {"boost rtree", [&] { return by_boost(w); }},
  };
  if (quick && w.h > 30) methods.pop_back();
#ifdef FORESEE_CGAL
  if (!quick || w.h <= 30) methods.push_back({"cgal boxes", [&] { return by_cgal(w); }});
#endif
  if (w.objects() <= 5000) methods.push_back({"brute force", [&] { return by_brute_force(w); }});
  const bool steps = w.layout.shape == Shape::box && !w.other;
  if (!steps || w.h > 3 || w.count > 100000) return methods;
  methods.push_back({"steps of 1", [&] { return by_stepping(w, 1); }, Method::misses_pairs});
  methods.push_back({"steps of 0.1", [&] { return by_stepping(w, 0.1); }, Method::misses_pairs});
  if (!quick && !w.name.starts_with("M-"))
    methods.push_back({"steps of 0.01", [&] { return by_stepping(w, 0.01); }, Method::misses_pairs});
  return methods;
}

void print(const Workload& w, const std::vector<Method>& methods, const Stages& s, std::FILE* csv) {
  const auto count = static_cast<double>(w.objects());
  const Answer &ours = methods[0].answer, &one_grid = methods[2].answer;
  std::printf("%-16s %5.2f pairs, %7.2f candidates an object\n", w.name.c_str(),
              static_cast<double>(ours.pairs) / count, static_cast<double>(one_grid.candidates) / count);
  for (const Method& method : methods) {
    const double ns = median(method.seconds) * 1e9 / count, ratio = median(method.ratios);
    const double missed =
        method.kind != Method::misses_pairs || ours.pairs == 0
            ? 0
            : 1 - static_cast<double>(method.answer.pairs) / static_cast<double>(ours.pairs);
    std::printf("    %-14s %9.0f ns per object %8.2fx", method.name, ns, ratio);
    if (method.kind == Method::misses_pairs) std::printf("   misses %.2f %% of the pairs", 100 * missed);
    std::printf("\n");
    if (csv)
      std::fprintf(csv, "%s,%s,%zu,%g,%zu,%zu,%.1f,%.3f,%.6f\n", w.name.c_str(), method.name, w.objects(),
                   w.h, method.answer.candidates, method.answer.pairs, ns, ratio, missed);
  }
  std::printf("    one grid:      enter %.0f, candidates %.0f, contact %.0f\n\n", s.enter * 1e9 / count,
              s.candidates * 1e9 / count, s.contact * 1e9 / count);
  std::fflush(stdout);
}

/// Small blocks that one method has freed are merged by the allocator when the next method requests a large
/// one. Stepping leaves half a second of that work to the method after it.
void settle_allocator() {
  const std::unique_ptr<char[]> large(new char[100000]);
  *const_cast<volatile char*>(large.get()) = 1;
}

double seconds_of_join(Method& method) {
  settle_allocator();
  return seconds_of([&] { method.answer = method.join(); });
}

constexpr double short_run = 0.05, long_run = 2;  // seconds

std::size_t max_runs(const Method& method) {
  constexpr std::size_t enough = 3, unlimited = -1;
  return method.kind == Method::misses_pairs ? 1 : method.warm_up > long_run ? enough : unlimited;
}

/// The median of some runs.
double seconds_now(Method& method) {
  std::vector<double> seconds;
  for (int i = 0; i < 5; ++i) seconds.push_back(seconds_of_join(method));
  return median(seconds);
}

/// False if two methods disagree.
bool compare(const Workload& w, int repetitions, bool quick, std::FILE* csv) {
  Stages stages;
  const Sides sides(w);
  std::vector<Method> methods = methods_for(w, sides, stages, quick);
  for (int repetition = 0; repetition <= repetitions; ++repetition) {  // the first is a warm-up
    for (Method& method : methods) {
      if (method.seconds.size() >= max_runs(method)) continue;
      if (repetition > 0 && method.warm_up < short_run) seconds_of_join(method);
      const double seconds = seconds_of_join(method);
      const Answer& ours = methods[0].answer;
      if (method.kind == Method::same_pairs && !method.answer.same_as(ours)) return false;
      if (method.kind == Method::misses_pairs && method.answer.pairs > ours.pairs) return false;
      if (repetition == 0) method.warm_up = seconds;
      const bool warms_up = repetition == 0 && (seconds < long_run || method.kind == Method::misses_pairs);
      if (warms_up) continue;
      method.seconds.push_back(seconds);
      method.ratios.push_back(seconds /
                              (seconds < long_run ? methods[0].seconds.back() : seconds_now(methods[0])));
    }
  }
  print(w, methods, stages, csv);
  return w.objects() < 100000 || compare_helpers(w, sides, repetitions);
}

int main_of(Options options) {
  const bool quick = options.has("--quick");
  const auto csv_path = options.value("--csv");
  std::FILE* csv = csv_path ? std::fopen(csv_path->c_str(), "w") : nullptr;
  if (csv) std::fprintf(csv, "workload,method,n,h,candidates,pairs,ns_per_object,ratio_to_foresee,missed\n");
  using Names = std::vector<std::string>;
  const Names usual = quick
                          ? Names{"P-zipf-5000", "S-10000",  "S-100000", "L-30",
                                  "M-100000",    "D-100000", "C-100000", "X-100000"}
                          : Names{"P-uniform-2000", "P-zipf-5000", "P-city-5000", "P-cube-100000", "S-10000",
                                  "S-100000",       "S-1000000",   "K-1000000",   "M-100000",      "L-30",
                                  "L-300",          "D-100000",    "C-100000",    "X-100000"};
  for (const std::string& name : options.names(usual)) {
    const Workload w = make_workload(name);
    const int repetitions = quick ? 3 : w.objects() <= 10000 ? 25 : 5;
    if (compare(w, repetitions, quick, csv)) continue;
    std::fprintf(stderr, "%s: the methods disagree\n", name.c_str());
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
