// A tree with a plain map of the objects that it should hold, and exact positions of objects.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "index/memory_pages.h"
#include "index/tpr_tree/search/window_walk.h"
#include "index/tpr_tree/tpr_tree.h"
#include "shape/swept_boxes.h"
#include "tests/scenes.h"

namespace foresee::testing {

/// The layout of most trees in these tests.
inline constexpr Layout boats{.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true};

struct TreeModel {
  TreeModel(const Layout& layout, double horizon, std::size_t capacity = 6)
      : pages(layout, capacity, capacity), tree(make_tpr_tree(pages, horizon)) {}

  void insert(std::int64_t id, std::vector<double> record) {
    tree->insert(id, record);
    objects[id] = std::move(record);
  }
  void update(std::int64_t id, std::vector<double> record) {
    EXPECT_TRUE(tree->update(id, record));
    objects[id] = std::move(record);
  }
  void erase(std::int64_t id) {
    EXPECT_TRUE(tree->erase(id));
    objects.erase(id);
  }
  /// Whether the tree took the new object in the place of the other one.
  bool replace(std::int64_t id, std::int64_t new_id, std::vector<double> record) {
    if (!tree->replace(id, new_id, record)) return false;
    objects.erase(id);
    objects[new_id] = std::move(record);
    return true;
  }
  void load(const RandomScene& scene) {
    const std::size_t size = scene.records.size() / scene.size();
    objects.clear();
    for (std::size_t i = 0; i < scene.size(); ++i)
      objects[scene.ids[i]].assign(scene.records.begin() + static_cast<std::ptrdiff_t>(i * size),
                                   scene.records.begin() + static_cast<std::ptrdiff_t>((i + 1) * size));
    tree->bulk_load(scene.ids, scene.records, never);
  }

  /// Merges `count` objects, some of which the tree has, with records of `scene`.
  void merge(const RandomScene& scene, std::size_t count, Random& random) {
    const std::size_t size = scene.records.size() / scene.size();
    std::map<std::int64_t, std::vector<double>> batch;
    while (batch.size() < count) {
      const auto from =
          scene.records.begin() + static_cast<std::ptrdiff_t>(random.below(scene.size()) * size);
      batch[static_cast<std::int64_t>(1 + random.below(2 * scene.size()))].assign(
          from, from + static_cast<std::ptrdiff_t>(size));
    }
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    for (const auto& [id, record] : batch) {
      ids.push_back(id);
      records.insert(records.end(), record.begin(), record.end());
      objects[id] = record;
    }
    tree->merge(ids, records, never);
  }

  /// Erases a share of the objects, drawn at random.
  void erase_share(double share, std::size_t max_leaves, Random& random) {
    std::vector<std::int64_t> ids;
    for (const auto& [id, record] : objects)
      if (random.in(0, 1) < share) ids.push_back(id);
    for (const std::int64_t id : ids) objects.erase(id);
    tree->erase_all(ids, max_leaves, never);
  }

  /// Adds the objects of `scene` as a run, with other ids.
  void add_run(const RandomScene& scene) { tree->add_run(add_new(scene), scene.records, never); }
  /// The same by merge_new().
  void merge_new(const RandomScene& scene) { tree->merge_new(add_new(scene), scene.records, never); }
  /// Gives the objects of `scene` other ids; the model has them.
  std::vector<std::int64_t> add_new(const RandomScene& scene) {
    const std::size_t size = scene.records.size() / scene.size();
    const std::int64_t last = objects.empty() ? 0 : objects.rbegin()->first;
    std::vector<std::int64_t> ids;
    for (std::size_t i = 0; i < scene.size(); ++i) {
      const auto from = scene.records.begin() + static_cast<std::ptrdiff_t>(i * size);
      ids.push_back(last + 1 + static_cast<std::int64_t>(i));
      objects[ids.back()].assign(from, from + static_cast<std::ptrdiff_t>(size));
    }
    return ids;
  }

  /// Inserts, updates and erases at random with records of `scene`, whose t advance with `clock`.
  void churn(const RandomScene& scene, int steps, Random& random, double& clock) {
    const std::size_t size = scene.records.size() / scene.size();
    const Offsets at = record_offsets(scene.layout);
    for (int step = 0; step < steps; ++step, clock += 0.01) {
      const auto from = static_cast<std::ptrdiff_t>(random.below(scene.size()) * size);
      std::vector<double> record(scene.records.begin() + from,
                                 scene.records.begin() + from + static_cast<std::ptrdiff_t>(size));
      const double t_before = at.t == Offsets::absent ? 0 : record[static_cast<std::size_t>(at.t)];
      if (at.t != Offsets::absent) record[static_cast<std::size_t>(at.t)] = clock + random.in(-0.1, 0.1);
      if (at.until != Offsets::absent && at.t != Offsets::absent)
        record[static_cast<std::size_t>(at.until)] += record[static_cast<std::size_t>(at.t)] - t_before;
      const auto id = static_cast<std::int64_t>(1 + random.below(2 * scene.size()));
      if (!objects.contains(id))
        insert(id, record);
      else if (random.below(3) == 0)
        erase(id);
      else
        update(id, record);
    }
  }

  /// Expects that the tree's invariants hold and that it holds the model's objects, bit for bit.
  void expect_sound() {
    const TreeReport report = check_tree(pages, never);
    EXPECT_TRUE(report.problems.empty()) << report.problems.front();
    ASSERT_EQ(report.objects, objects.size());
    EXPECT_EQ(pages.object_count(), objects.size());
    EXPECT_EQ(pages.node_count(), report.nodes);
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    collect_objects(pages, ids, records, never);
    const std::size_t size = ids.empty() ? 0 : records.size() / ids.size();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      ASSERT_TRUE(objects.contains(ids[i]));
      ASSERT_TRUE(std::equal(objects[ids[i]].begin(), objects[ids[i]].end(), records.data() + i * size));
    }
    double newest = objects.empty() ? 0 : -std::numeric_limits<double>::infinity();
    const Offsets at = record_offsets(pages.layout());
    for (const auto& [id, record] : objects)
      newest = std::max(newest, at.t == Offsets::absent ? 0 : record[static_cast<std::size_t>(at.t)]);
    EXPECT_EQ(read_newest_t(pages), newest);
  }

  NeverInterrupt never;
  MemoryPages pages;
  std::unique_ptr<TprTree> tree;
  std::map<std::int64_t, std::vector<double>> objects;
};

/// Counts the leaves that a walk reads.
class CountedLeaves final : public NodeSource {
 public:
  explicit CountedLeaves(NodeSource& nodes) : nodes_(nodes) {}

  const Layout& layout() const override { return nodes_.layout(); }
  NodeNumber find_root() override { return nodes_.find_root(); }
  std::shared_ptr<const Node> read(NodeNumber number) override {
    auto node = nodes_.read(number);
    count += node->is_leaf();
    return node;
  }

  std::size_t count = 0;

 private:
  NodeSource& nodes_;
};

/// The leaves that windows of a twentieth of the side read, and those of them with an object that may meet the window.
struct LeavesInWindows {
  double read = 0, with_hits = 0;
};

inline LeavesInWindows leaves_in_windows(TreeModel& model, double side, double now) {
  Random random(8);
  CountedLeaves leaves(model.pages);
  LeavesInWindows all;
  for (int i = 0; i < 100; ++i) {
    const Vec<2> lower(random.in(0, side), random.in(0, side)), still = Vec<2>::zero();
    const Horizon horizon{now, 0};
    WindowWalk<2> walk(leaves, moving_window<2>(lower, lower + side / 20, still, horizon), horizon, still,
                       model.never);
    for (LeafHits hits; walk.next(hits);) ++all.with_hits;
  }
  all.read = static_cast<double>(leaves.count);
  return all;
}

/// The same as multiples of those of a tree built from the same objects, which the model has from then on.
inline LeavesInWindows leaves_against_packed(TreeModel& model, double side, double now) {
  const LeavesInWindows before = leaves_in_windows(model, side, now);
  model.tree->rebuild(model.never);
  const LeavesInWindows packed = leaves_in_windows(model, side, now);
  return {before.read / packed.read, before.with_hits / packed.with_hits};
}

/// The box of an object at a time, computed in long double without code of the tree; false if it does not
/// exist then.
template <int D>
bool box_at(const Layout& layout, const std::vector<double>& record, long double time,
            long double (&lower)[D], long double (&upper)[D]) {
  std::vector<double> row(static_cast<std::size_t>(row_offsets(layout).size));
  row_from_record(layout, record.data(), row.data());
  const Bodies body(layout, row.data(), 1);
  const Motion<D> motion = motion_of<D>(body, 0);
  const Extents<D> extents = extents_of<D>(body, 0);
  if (time < motion.t || time > motion.until) return false;
  const long double s = time - motion.t;
  for (int axis = 0; axis < D; ++axis) {
    const long double centre = motion.x[axis] + motion.v[axis] * s + motion.a[axis] * s * s / 2;
    lower[axis] = centre + extents.lower[axis], upper[axis] = centre + extents.upper[axis];
  }
  return true;
}

}  // namespace foresee::testing
