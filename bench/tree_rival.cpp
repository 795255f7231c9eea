// libspatialindex's TPR-tree (spatialindex_tree.h) beside ours: the objects of U-<n> inserted one by one, the
// same windows, and the self-join.
//
//   bench_tree_rival [objects]
//
// Built only where libspatialindex is installed (Debian: libspatialindex-dev). Times are processor time of
// one thread; both must find the same pairs, or the program fails.
#include <cstdio>
#include <cstdlib>

#include "index/memory_pages.h"
#include "index/tpr_tree/search/tree_join.h"
#include "index/tpr_tree/search/window_walk.h"
#include "index/tpr_tree/tpr_tree.h"
#include "measure.h"
#include "spatialindex_tree.h"

namespace foresee::bench {
namespace {

constexpr double horizon = 20, reach = 15;
constexpr std::size_t windows = 200;
NeverInterrupt never;

struct Figures {
  double insert, window, join;  ///< seconds in all
  std::size_t found = 0, pairs = 0;
};

Figures measure_rival(const Workload& w) {
  Figures figures{};
  SpatialindexTree tree(w, horizon);
  figures.insert = seconds_of([&] { tree.insert_all(); });
  figures.window = seconds_of([&] {
    for (std::size_t i = 0; i < windows; ++i) {
      const double* const x = w.bodies().row(i);
      figures.found += tree.count(x[0], x[1], reach);
    }
  });
  figures.join = seconds_of([&] { tree.join([&](std::uint32_t, std::uint32_t) { ++figures.pairs; }); });
  return figures;
}

Figures measure_ours(const Workload& w) {
  Figures figures{};
  MemoryPages pages(w.layout);
  const auto tree = make_tpr_tree(pages, horizon);
  const auto numbers = static_cast<std::size_t>(w.bodies().at.size);
  figures.insert = seconds_of([&] {
    for (std::size_t i = 0; i < w.count; ++i)
      tree->insert(static_cast<std::int64_t>(i), {w.bodies().row(i), numbers});
  });
  const Horizon queried{0, w.h};
  const Vec<2> still = Vec<2>::zero();
  figures.window = seconds_of([&] {
    for (std::size_t i = 0; i < windows; ++i) {
      const double* const x = w.bodies().row(i);
      const Vec<2> at(x[0], x[1]);
      WindowWalk<2> walk(pages, moving_window<2>(at - reach, at + reach, still, queried), queried, still,
                         never);
      for (LeafHits hits; walk.next(hits);) figures.found += hits.slots.size();
    }
  });
  figures.join = seconds_of([&] {
    const TreeScene scene = read_tree(pages, never);
    const auto join = make_tree_join<2>(scene.bodies(), scene.levels, queried, still, never);
    for (std::vector<Pair> batch; join->next(batch); batch.clear()) figures.pairs += batch.size();
  });
  return figures;
}

void print(const char* what, double ours, double theirs, std::size_t count) {
  const double scale = 1e9 / static_cast<double>(count);
  std::printf("%-24s %10.0f ns %12.0f ns %8.1fx\n", what, ours * scale, theirs * scale, theirs / ours);
}

int main_of(int count, char** arguments) {
  const Workload w = make_workload("U-" + std::string(count > 1 ? arguments[1] : "20000"));
  const Figures ours = measure_ours(w), theirs = measure_rival(w);
  std::printf("%zu objects                     ours  libspatialindex\n", w.count);
  print("insert, an object", ours.insert, theirs.insert, w.count);
  print("window", ours.window, theirs.window, windows);
  print("self-join, an object", ours.join, theirs.join, w.count);
  std::printf("found in windows %zu and %zu; pairs %zu and %zu\n", ours.found, theirs.found, ours.pairs,
              theirs.pairs);
  return ours.pairs == theirs.pairs && ours.found == theirs.found ? 0 : 1;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  try {
    return foresee::bench::main_of(count, arguments);
  } catch (Tools::Exception& error) {
    std::fprintf(stderr, "%s\n", error.what().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return 1;
}
