// The join without SQL: our grid, Boost.Geometry's R-tree and all pairs, each followed by the same exact
// contact, each emitting (a, b, t). Objects lie in native memory, one thread, warm.
//
//   bench_core_join [--quick] [workload ...]
//
// Prints nanoseconds of processor time an object (medians), ratios to the grid, and where the grid's time
// goes. "join" is the library call of query/join.h with method 'auto': it plans, and cuts long horizons into
// slabs. On large scenes its time by the clock follows, alone and with one and two helper threads. Methods
// must agree on the pairs and their times, or the program fails.
#include <bit>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <string>

#include "contact/contact.h"
#include "index/all_pairs.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "measure.h"
#include "query/join.h"
#include "workloads.h"

namespace foresee::bench {
namespace {

NeverInterrupt never;
const auto space = std::make_shared<GridSpace>();

/// What a join has answered, as a count and a sum that does not depend on the order.
struct Answer {
  std::size_t candidates = 0, pairs = 0;
  std::uint64_t sum = 0;

  void add(const Pair& pair, double t) {
    const std::uint64_t low = std::min(pair.a, pair.b), high = std::max(pair.a, pair.b);
    std::uint64_t mixed = (low << 32 | high) * 0x9e3779b97f4a7c15u ^ std::bit_cast<std::uint64_t>(t);
    mixed ^= mixed >> 29;
    sum += mixed * 0xbf58476d1ce4e5b9u;
    ++pairs;
  }
  bool same_as(const Answer& other) const { return pairs == other.pairs && sum == other.sum; }
};

struct Stages {
  double enter = 0, candidates = 0, contact = 0;
};

/// Contact for one batch of candidates after another.
class Emitter {
 public:
  explicit Emitter(const Workload& w)
      : contact_(make_contact(w.bodies(), w.bodies(), {.horizon = {0, w.h}}, w.name, w.name)) {}

  void take(std::vector<Pair>& candidates) {
    answer.candidates += candidates.size();
    hits_.clear(), times_.clear();
    stages.contact +=
        seconds_of([&] { contact_->first_contacts(candidates, TimesWanted::begins, hits_, times_); });
    for (std::size_t i = 0; i < hits_.size(); ++i) answer.add(hits_[i], times_[i].t);
    candidates.clear();
  }

  Answer answer;
  Stages stages;

 private:
  std::unique_ptr<Contact> contact_;
  std::vector<Pair> hits_;
  std::vector<ContactTimes> times_;
};

template <int D>
Answer by_grid(const Workload& w, Stages& stages) {
  Emitter emitter(w);
  std::unique_ptr<Candidates> grid;
  stages.enter = seconds_of([&] {
    grid = make_gpcd_grid<D>({w.bodies(), {0, w.h}, Vec<D>::Zero()}, nullptr, never, space);
  });
  const double begin = cpu_seconds();
  for (std::vector<Pair> batch; grid->next(batch);) emitter.take(batch);
  stages.contact = emitter.stages.contact;
  stages.candidates = cpu_seconds() - begin - stages.contact;
  return emitter.answer;
}

std::shared_ptr<const Scene> scene_of(const Workload& w) {
  auto scene = std::make_shared<Scene>();
  scene->name = w.name, scene->layout = w.layout, scene->rows = w.rows;
  for (std::size_t i = 0; i < w.count; ++i) scene->ids.push_back(static_cast<std::int64_t>(i));
  return scene;
}

Answer by_join(const std::shared_ptr<const Scene>& scene, double h, std::size_t helpers) {
  Answer answer;
  Join join(
      {.a = scene, .h = h, .wants = {.ends = false, .approach = false}, .helpers = helpers, .space = space},
      never);
  for (auto rows = join.next(); !rows.empty(); rows = join.next())
    for (const JoinRow& row : rows)
      answer.add({static_cast<std::uint32_t>(row.a), static_cast<std::uint32_t>(row.b)}, row.contact.t);
  return answer;
}

/// False if the helpers change the answer.
bool compare_helpers(const Workload& w, const std::shared_ptr<const Scene>& scene, int repetitions) {
  constexpr std::size_t most = 2;
  std::vector<double> seconds[most + 1], processor[most + 1];
  const Answer alone = by_join(scene, w.h, 0);
  for (int i = 0; i < repetitions; ++i)
    for (std::size_t helpers = 0; helpers <= most; ++helpers) {
      const auto begin = std::chrono::steady_clock::now();
      const double processor_begin = cpu_seconds();
      if (!by_join(scene, w.h, helpers).same_as(alone)) return false;
      processor[helpers].push_back(cpu_seconds() - processor_begin);
      seconds[helpers].push_back(
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
  for (std::size_t helpers = 0; helpers <= most; ++helpers)
    std::printf(
        "    %zu helpers: %8.1f ms by the clock (%.2fx as fast as alone), %8.1f ms of processor time\n",
        helpers, 1000 * median(seconds[helpers]), median(seconds[0]) / median(seconds[helpers]),
        1000 * median(processor[helpers]));
  std::printf("\n");
  return true;
}

Answer by_all_pairs(const Workload& w) {
  Emitter emitter(w);
  const auto all = make_all_pairs(w.count, never);
  for (std::vector<Pair> batch; all->next(batch);) emitter.take(batch);
  return emitter.answer;
}

template <int D>
using BoostPoint = boost::geometry::model::point<double, D, boost::geometry::cs::cartesian>;
template <int D>
using BoostBox = boost::geometry::model::box<BoostPoint<D>>;

template <int D>
BoostPoint<D> boost_point(const Vec<D>& x) {
  if constexpr (D == 2)
    return {x[0], x[1]};
  else
    return {x[0], x[1], x[2]};
}

/// A packed R-tree of the swept boxes, asked with every box.
template <int D>
Answer by_boost(const Workload& w) {
  namespace index = boost::geometry::index;
  using Value = std::pair<BoostBox<D>, std::uint32_t>;
  Emitter emitter(w);
  const std::vector<Box<D>> boxes = swept_boxes<D>(w.bodies(), {0, w.h}, Vec<D>::Zero(), never);
  std::vector<Value> values;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    values.push_back({{boost_point<D>(boxes[i].lower), boost_point<D>(boxes[i].upper)}, i});
  const index::rtree<Value, index::rstar<16>> tree(values);
  std::vector<Pair> batch;
  for (const Value& value : values) {
    for (auto hit = tree.qbegin(index::intersects(value.first)); hit != tree.qend(); ++hit)
      if (value.second < hit->second) batch.push_back({value.second, hit->second});
    if (batch.size() >= 4096) emitter.take(batch);
  }
  emitter.take(batch);
  return emitter.answer;
}

struct Method {
  const char* name;
  std::vector<double> seconds, ratios;
};

void print(const Workload& w, const Answer& answer, const std::vector<Method>& methods, const Stages& s) {
  const double per_object = 1e9 / static_cast<double>(w.count);
  std::printf("%-16s %5.2f pairs, %7.2f candidates an object\n", w.name.c_str(),
              static_cast<double>(answer.pairs) / static_cast<double>(w.count),
              static_cast<double>(answer.candidates) / static_cast<double>(w.count));
  for (const Method& method : methods)
    std::printf("    %-12s %9.0f ns an object %8.2fx\n", method.name, median(method.seconds) * per_object,
                median(method.ratios));
  std::printf("    the grid:    enter %.0f, candidates %.0f, contact %.0f\n\n", s.enter * per_object,
              s.candidates * per_object, s.contact * per_object);
}

/// False if two methods disagree.
template <int D>
bool compare(const Workload& w, int repetitions) {
  std::vector<Method> methods{{"grid", {}, {}}, {"boost rtree", {}, {}}, {"join", {}, {}}};
  const auto scene = scene_of(w);
  if (w.count <= 5000) methods.push_back({"all pairs", {}, {}});
  Answer first;
  Stages stages;
  for (int repetition = 0; repetition <= repetitions; ++repetition) {  // the first only warms up
    double grid_seconds = 0;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      Answer answer;
      const double seconds = seconds_of([&] {
        answer = m == 0   ? by_grid<D>(w, stages)
                 : m == 1 ? by_boost<D>(w)
                 : m == 2 ? by_join(scene, w.h, 0)
                          : by_all_pairs(w);
      });
      if (m == 0) grid_seconds = seconds, first = answer;
      if (!answer.same_as(first)) return false;
      if (repetition == 0) continue;
      methods[m].seconds.push_back(seconds);
      methods[m].ratios.push_back(seconds / grid_seconds);
    }
  }
  print(w, first, methods, stages);
  return w.count < 100000 || compare_helpers(w, scene, repetitions);
}

int main_of(int count, char** arguments) {
  bool quick = false;
  std::vector<std::string> names;
  for (int i = 1; i < count; ++i)
    std::strcmp(arguments[i], "--quick") == 0 ? void(quick = true) : names.push_back(arguments[i]);
  if (names.empty() && quick) names = {"P-zipf-5000", "S-10000", "S-100000"};
  if (names.empty())
    names = {"P-uniform-2000", "P-zipf-5000", "P-city-5000",   "S-10000",  "S-100000",
             "S-1000000",      "K-1000000",   "P-cube-100000", "M-100000", "L-30"};
  for (const std::string& name : names) {
    const Workload w = make_workload(name);
    const int repetitions = quick ? 3 : w.count <= 10000 ? 25 : 5;
    if (w.layout.axes == 2 ? compare<2>(w, repetitions) : compare<3>(w, repetitions)) continue;
    std::fprintf(stderr, "%s: the methods disagree\n", name.c_str());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  try {
    return foresee::bench::main_of(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
