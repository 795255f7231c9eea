// Schedules of movers as records that exist for a limited time, and the number of nodes that windows read.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>

#include "index/memory_pages.h"
#include "index/tpr_tree/search/window_walk.h"
#include "motion/plan/plan.h"
#include "tests/never_interrupt.h"
#include "tests/scenes.h"

namespace foresee::testing {

inline constexpr Layout legs{
    .axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true, .has_until = true};

/// A source that counts the nodes read.
class CountedSource final : public NodeSource {
 public:
  explicit CountedSource(MemoryPages& pages) : pages_(pages) {}
  const Layout& layout() const override { return pages_.layout(); }
  NodeNumber find_root() override { return pages_.find_root(); }
  std::shared_ptr<const Node> read(NodeNumber number) override { return ++nodes_, pages_.read(number); }
  double nodes() const { return static_cast<double>(nodes_); }

 private:
  MemoryPages& pages_;
  std::size_t nodes_ = 0;
};

/// Movers that travel between random places of a square in `count` legs of `duration` each, one record per leg
/// that exists at some time of [from, to].
struct Schedule {
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  double side;

  Schedule(std::size_t movers, int count, double duration, double from = -no_end, double to = no_end)
      : side(std::sqrt(100.0 * static_cast<double>(movers))) {
    Random random(5);
    for (std::size_t mover = 0; mover < movers; ++mover) {
      double x = random.in(0, side), y = random.in(0, side), t = -duration * random.unit();
      for (int leg = 0; leg < count; ++leg, t += duration) {
        const double end_x = std::clamp(x + random.in(-10, 10), 0.0, side),
                     end_y = std::clamp(y + random.in(-10, 10), 0.0, side);
        if (t + duration >= from && t <= to) {
          ids.push_back(static_cast<std::int64_t>(ids.size() + 1));
          records.insert(records.end(),
                         {t, x, y, (end_x - x) / duration, (end_y - y) / duration, 1, t + duration});
        }
        x = end_x, y = end_y;
      }
    }
  }
  std::span<const double> record(std::size_t i) const { return {records.data() + 7 * i, 7}; }

  /// The order of one random permutation, or by t.
  std::vector<std::size_t> order(bool by_time) const {
    std::vector<std::size_t> order(ids.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Random random(3);
    for (std::size_t i = order.size(); i-- > 1;) std::swap(order[i], order[random.below(i + 1)]);
    if (by_time)
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return record(a)[0] < record(b)[0]; });
    return order;
  }
};

/// Mean number of nodes that windows of about ten objects read, at an instant in the middle of a schedule.
inline double nodes_of_windows(MemoryPages& pages, double side, double now, double h = 0) {
  constexpr int windows = 100;
  CountedSource source(pages);
  NeverInterrupt never;
  Random random(9);
  const Horizon horizon{now, h};
  const Vec<2> still = Vec<2>::zero();
  for (int i = 0; i < windows; ++i) {
    const Vec<2> lower(random.in(0, side), random.in(0, side));
    WindowWalk<2> walk(source, moving_window<2>(lower, lower + 30, still, horizon), horizon, still, never);
    for (LeafHits hits; walk.next(hits);) continue;
  }
  return source.nodes() / windows;
}

}  // namespace foresee::testing
