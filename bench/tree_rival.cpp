// libspatialindex's TPR-tree beside ours: the same objects in uniform motion, inserted one by one, the same
// windows, and the self-join. The rival can do the join only by one probe per object, as its selfJoinQuery is
// not implemented.
//
//   bench_tree_rival [objects]
//
// Built only where libspatialindex is installed (Debian: libspatialindex-dev). Times are processor time of
// one thread; both must find the same pairs, or the program fails.
#include <spatialindex/SpatialIndex.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "index/memory_pages.h"
#include "index/tpr_tree/search/tree_join.h"
#include "index/tpr_tree/search/window_walk.h"
#include "index/tpr_tree/tpr_tree.h"
#include "measure.h"
#include "scenes.h"

namespace foresee::bench {
namespace {

using testing::Random;
namespace rival = SpatialIndex;

constexpr double h = 3, horizon = 20, half = 0.5, unbounded = 1e6;
constexpr std::size_t windows = 200;
NeverInterrupt never;

struct Object {
  double x[2], v[2];
};

std::vector<Object> make_objects(std::size_t count) {
  Random random(count);
  const double side = std::sqrt(14 * static_cast<double>(count));
  std::vector<Object> objects(count);
  for (Object& object : objects)
    for (int axis = 0; axis < 2; ++axis)
      object.x[axis] = random.in(0, side), object.v[axis] = random.in(-3, 3);
  return objects;
}

struct Figures {
  double insert, window, join;  ///< seconds in all
  std::size_t found = 0, pairs = 0;
};

rival::MovingRegion region(const Object& object, double reach, double end) {
  const double low[] = {object.x[0] - reach, object.x[1] - reach},
               high[] = {object.x[0] + reach, object.x[1] + reach};
  return rival::MovingRegion(low, high, object.v, object.v, 0, end, 2);
}

struct Counter final : rival::IVisitor {
  void visitNode(const rival::INode&) override {}
  void visitData(const rival::IData& data) override { found += data.getIdentifier() > above; }
  void visitData(std::vector<const rival::IData*>&) override {}
  rival::id_type above = -1;
  std::size_t found = 0;
};

Figures measure_rival(const std::vector<Object>& objects) {
  Figures figures{};
  const std::unique_ptr<rival::IStorageManager> memory(
      rival::StorageManager::createNewMemoryStorageManager());
  rival::id_type index;
  const std::unique_ptr<rival::ISpatialIndex> tree(
      rival::TPRTree::createNewTPRTree(*memory, 0.7, 32, 50, 2, rival::TPRTree::TPRV_RSTAR, horizon, index));
  figures.insert = seconds_of([&] {
    for (std::size_t i = 0; i < objects.size(); ++i)
      tree->insertData(0, nullptr, region(objects[i], half, unbounded), static_cast<rival::id_type>(i));
  });
  Counter in_windows, joined;
  figures.window = seconds_of([&] {
    for (std::size_t i = 0; i < windows; ++i) {
      const Object window{{objects[i].x[0], objects[i].x[1]}, {0, 0}};
      tree->intersectsWithQuery(region(window, 15, h), in_windows);
    }
  });
  figures.join = seconds_of([&] {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      joined.above = static_cast<rival::id_type>(i);
      tree->intersectsWithQuery(region(objects[i], half, h), joined);
    }
  });
  figures.found = in_windows.found, figures.pairs = joined.found;
  return figures;
}

Figures measure_ours(const std::vector<Object>& objects) {
  Figures figures{};
  MemoryPages pages({.axes = 2, .law = Law::uniform, .shape = Shape::ball});
  const auto tree = make_tpr_tree(pages, horizon);
  figures.insert = seconds_of([&] {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Object& object = objects[i];
      const double record[] = {object.x[0], object.x[1], object.v[0], object.v[1], half};
      tree->insert(static_cast<std::int64_t>(i), record);
    }
  });
  const Horizon queried{0, h};
  const Vec<2> still = Vec<2>::Zero();
  figures.window = seconds_of([&] {
    for (std::size_t i = 0; i < windows; ++i) {
      const Vec<2> at(objects[i].x[0], objects[i].x[1]);
      WindowWalk<2> walk(pages, moving_window<2>(at - 15, at + 15, still, queried), queried, still, never);
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
  const auto objects = make_objects(count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 20000);
  const Figures ours = measure_ours(objects), theirs = measure_rival(objects);
  std::printf("%zu objects                     ours  libspatialindex\n", objects.size());
  print("insert, an object", ours.insert, theirs.insert, objects.size());
  print("window", ours.window, theirs.window, windows);
  print("self-join, an object", ours.join, theirs.join, objects.size());
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
