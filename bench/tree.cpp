// Cost of the tree without SQL: building, updating and querying it. A tree that grew object by object, or
// whose objects have moved on, is compared with one that was loaded at once.
//
//   bench_tree [--horizon seconds] [--quick] [workload ...]
//
// Objects lie in MemoryPages; times are processor time of one thread. --horizon is the look-ahead for which
// the tree is tuned (60, as for tables); queries use the workload's own horizon. --rival adds
// libspatialindex's TPR-tree, if it was there when this was built, on at most 20,000 objects.
#include <cmath>
#include <cstdio>
#include <string>

#include "contact/contact.h"
#include "index/memory_pages.h"
#include "index/tpr_tree/search/nearest_walk.h"
#include "index/tpr_tree/search/tree_join.h"
#include "index/tpr_tree/search/window_walk.h"
#include "index/tpr_tree/tpr_tree.h"
#include "measure.h"
#include "program.h"
#include "scenes.h"
#include "workloads.h"

namespace foresee::bench {
namespace {

using testing::Random;

NeverInterrupt never;
constexpr std::size_t k = 10;

/// The workload's objects as records of a table that declares t, and a clock.
struct Scene {
  explicit Scene(const Workload& w) : workload(w), layout(w.layout) {
    layout.has_t = true;
    size = static_cast<std::size_t>(record_offsets(layout).size);
    for (std::size_t i = 0; i < w.count; ++i) {
      ids.push_back(static_cast<std::int64_t>(i + 1));
      records.push_back(0);
      records.insert(records.end(), w.bodies().row(i), w.bodies().row(i) + size - 1);
    }
  }
  std::span<const double> record(std::size_t i) const { return {records.data() + i * size, size}; }

  /// The position of object i at `now`, by its last motion.
  std::vector<double> at(std::size_t i, double now) const {
    const Offsets at = record_offsets(layout);
    std::vector<double> moved(record(i).begin(), record(i).end());
    const double s = now - moved[0];
    moved[0] = now;
    for (int axis = 0; axis < layout.axes; ++axis) {
      const auto x = static_cast<std::size_t>(at.x + axis), v = static_cast<std::size_t>(at.v + axis);
      moved[x] += moved[v] * s;
    }
    return moved;
  }

  const Workload& workload;
  Layout layout;
  std::size_t size = 0;
  std::vector<std::int64_t> ids;
  std::vector<double> records;
};

struct Tree {
  Tree(const Scene& scene, double horizon)
      : pages(scene.layout), tree(make_tpr_tree(pages, horizon)), now(0) {}

  MemoryPages pages;
  std::unique_ptr<TprTree> tree;
  double now;  ///< of the queries
};

void print(const char* what, double seconds, std::size_t count, const char* unit) {
  std::printf("    %-28s %9.0f ns %s\n", what, seconds * 1e9 / static_cast<double>(count), unit);
}

/// The side of a square or cube that holds about `wanted` of evenly spread objects.
double side_for(const Scene& scene, double wanted) {
  double lower = 1e300, upper = -1e300;
  const Bodies bodies = scene.workload.bodies();
  for (std::size_t i = 0; i < bodies.count; ++i) {
    lower = std::min(lower, bodies.row(i)[bodies.at.x]), upper = std::max(upper, bodies.row(i)[bodies.at.x]);
  }
  return (upper - lower) * std::sqrt(wanted / static_cast<double>(bodies.count));
}

template <int D>
Vec<D> somewhere(const Scene& scene, Random& random) {
  const Bodies bodies = scene.workload.bodies();
  return Vec<D>::at(bodies.row(random.below(bodies.count)) + bodies.at.x);
}

template <int D>
void query_windows(const Scene& scene, Tree& tree) {
  constexpr std::size_t questions = 500;
  Random random(7);
  const Horizon horizon{tree.now, scene.workload.h};
  const double half = 0.5 * std::max(0.0, side_for(scene, 100) - 2 * scene.workload.h);
  std::size_t found = 0, leaves = 0;
  const double seconds = seconds_of([&] {
    for (std::size_t i = 0; i < questions; ++i) {
      const Vec<D> at = somewhere<D>(scene, random), still = Vec<D>::zero();
      WindowWalk<D> walk(tree.pages, moving_window<D>(at - half, at + half, still, horizon), horizon, still,
                         never);
      for (LeafHits hits; walk.next(hits); ++leaves) found += hits.slots.size();
    }
  });
  print("window", seconds, questions, "");
  std::printf("%42.1f found in %.1f leaves\n", static_cast<double>(found) / questions,
              static_cast<double>(leaves) / questions);
}

/// The minimum distance between a point and an object that moves along a chord of its path.
template <int D>
double distance(const LeafHits& hits, std::uint32_t slot, const Scene& scene, const Vec<D>& point,
                const Horizon& horizon) {
  const Offsets at = record_offsets(scene.layout);
  const double* record = hits.leaf->values.data() + slot * scene.size;
  const double s = horizon.now - record[at.t];
  const Vec<D> x = Vec<D>::at(record + at.x), v = Vec<D>::at(record + at.v);
  const Vec<D> gap = x + v * s - point;
  const double squared = v.square().sum(), closest = squared > 0 ? -(gap * v).sum() / squared : 0;
  return std::sqrt((gap + v * std::clamp(closest, 0.0, horizon.h)).square().sum());
}

template <int D>
void query_nearest(const Scene& scene, Tree& tree, double h) {
  constexpr std::size_t questions = 500;
  Random random(9);
  const Horizon horizon{tree.now, h};
  std::size_t measured = 0, leaves = 0;
  const double seconds = seconds_of([&] {
    std::vector<double> best;
    for (std::size_t i = 0; i < questions; ++i) {
      const Vec<D> point = somewhere<D>(scene, random);
      NearestWalk<D> walk(tree.pages, point, Vec<D>::zero(), horizon, never);
      double reach = std::numeric_limits<double>::infinity();
      best.clear();
      for (LeafHits hits; walk.next(reach, hits); ++leaves)
        for (std::size_t hit = 0; hit < hits.slots.size() && hits.distances[hit] <= reach;
             ++hit, ++measured) {
          best.push_back(distance<D>(hits, hits.slots[hit], scene, point, horizon));
          std::push_heap(best.begin(), best.end());
          if (best.size() > k) std::pop_heap(best.begin(), best.end()), best.pop_back();
          if (best.size() == k) reach = best.front();
        }
    }
  });
  print(h == 0 ? "nearest 10, at an instant" : "nearest 10, over the horizon", seconds, questions, "");
  std::printf("%42.1f measured in %.1f leaves\n", static_cast<double>(measured) / questions,
              static_cast<double>(leaves) / questions);
}

template <int D>
void join(const Scene& scene, Tree& tree) {
  const TreeScene rows = read_tree(tree.pages, never);
  const Horizon horizon{tree.now, scene.workload.h};
  const auto contact = make_contact(rows.bodies(), rows.bodies(), {.horizon = horizon}, "a", "a");
  std::size_t candidates = 0, pairs = 0;
  double deciding = 0;
  const double seconds = seconds_of([&] {
    const auto walk = make_tree_join<D>(rows.bodies(), rows.levels, horizon, Vec<D>::zero(), never);
    std::vector<Pair> hits;
    std::vector<ContactTimes> times;
    for (std::vector<Pair> batch; walk->next(batch); batch.clear()) {
      candidates += batch.size();
      hits.clear(), times.clear();
      deciding += seconds_of([&] { contact->first_contacts(batch, TimesWanted::starts, hits, times); });
      pairs += hits.size();
    }
  });
  const std::size_t count = scene.ids.size();
  print("self-join", seconds, count, "an object");
  print("    of which the walk", seconds - deciding, count, "an object");
  std::printf("%42zu pairs of %zu candidates\n", pairs, candidates);
}

template <int D>
void run_queries(const char* name, const Scene& scene, Tree& tree) {
  std::printf("  %s: %zu nodes\n", name, tree.pages.node_count());
  query_windows<D>(scene, tree);
  query_nearest<D>(scene, tree, 0);
  query_nearest<D>(scene, tree, scene.workload.h);
  join<D>(scene, tree);
}

void insert_all(const Scene& scene, Tree& tree) {
  for (std::size_t i = 0; i < scene.ids.size(); ++i) tree.tree->insert(scene.ids[i], scene.record(i));
}

/// Random objects report the motion that they already have: no object has to move in the tree.
void update_in_place(const Scene& scene, Tree& tree) {
  constexpr std::size_t updates = 100000;
  Random random(3);
  const double seconds = seconds_of([&] {
    for (std::size_t i = 0; i < updates; ++i) {
      const std::size_t which = random.below(scene.ids.size());
      tree.tree->update(scene.ids[which], scene.record(which));
    }
  });
  print("update in place", seconds, updates, "");
}

/// 100,000 random objects report, one after another over two horizons of the tree, their current position and
/// a velocity that is half new.
void drift(const Scene& scene, Tree& tree, double duration) {
  constexpr std::size_t updates = 100000;
  const auto v = static_cast<std::size_t>(record_offsets(scene.layout).v);
  Random random(5);
  double seconds = 0;
  Scene moved = scene;
  for (std::size_t i = 0; i < updates; ++i) {
    tree.now = duration * static_cast<double>(i) / updates;
    const std::size_t which = random.below(scene.ids.size());
    std::vector<double> record = moved.at(which, tree.now);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.layout.axes); ++axis)
      record[v + axis] = 0.5 * record[v + axis] + random.in(-1.5, 1.5);
    std::copy(record.begin(), record.end(),
              moved.records.begin() + static_cast<std::ptrdiff_t>(which * scene.size));
    seconds += seconds_of([&] { tree.tree->update(scene.ids[which], record); });
  }
  print("update, drifting", seconds, updates, "(clock calls included)");
}

template <int D>
void measure(const Workload& w, double horizon, bool quick) {
  const Scene scene(w);
  std::printf("%s, tree for %g s, queries about %g s\n", w.name.c_str(), horizon, w.h);
  {
    Tree loaded(scene, horizon);
    std::vector<double> seconds;
    for (int i = 0; i < 3; ++i)
      seconds.push_back(seconds_of([&] { loaded.tree->bulk_load(scene.ids, scene.records, never); }));
    print("load", median(seconds), scene.ids.size(), "an object");
    run_queries<D>("loaded", scene, loaded);
    update_in_place(scene, loaded);
  }
  if (quick) return;
  {
    Tree grown(scene, horizon);
    print("insert", seconds_of([&] { insert_all(scene, grown); }), scene.ids.size(), "an object");
    run_queries<D>("grown", scene, grown);
  }
  for (const bool from_load : {true, false}) {
    Tree drifted(scene, horizon);
    from_load ? drifted.tree->bulk_load(scene.ids, scene.records, never) : insert_all(scene, drifted);
    drift(scene, drifted, 30);
    run_queries<D>(from_load ? "loaded, drifted" : "grown, drifted", scene, drifted);
    if (from_load) continue;
    drifted.tree->rebuild(never);
    run_queries<D>("drifted, rebuilt", scene, drifted);
  }
}

int main_of(Options options) {
  const bool quick = options.has("--quick");
  const double horizon = std::stod(options.value("--horizon").value_or("60"));
  for (const std::string& name : options.names({"S-100000"})) {
    const Workload w = make_workload(name);
    w.layout.axes == 2 ? measure<2>(w, horizon, quick) : measure<3>(w, horizon, quick);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
