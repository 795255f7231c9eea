#include "core_rivals.h"

#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <unordered_set>

#include "boost_tree.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "index/resting_bodies.h"

namespace foresee::bench {
namespace {

/// The places of the boxes at time t.
template <int D>
void place_boxes(const Workload& w, double t, std::vector<Box<D>>& boxes) {
  const Bodies bodies = w.bodies();
  const Offsets& at = bodies.at;
  boxes.resize(w.count);
  for (std::size_t i = 0; i < w.count; ++i) {
    const double* row = bodies.row(i);
    for (int axis = 0; axis < D; ++axis) {
      const double a = at.a == Offsets::absent ? 0 : row[at.a + axis];
      const double x = row[at.x + axis] + t * (row[at.v + axis] + 0.5 * a * t);
      boxes[i].lower[axis] = x - row[at.half + axis];
      boxes[i].upper[axis] = x + row[at.half + axis];
    }
  }
}

}  // namespace

Answer by_brute_force(const Workload& w) {
  PlainEmitter emitter(w);
  const auto others = static_cast<std::uint32_t>(w.second().count);
  for (std::uint32_t a = 0; a < w.count; ++a)
    for (std::uint32_t b = w.other ? 0 : a + 1; b < others; ++b) emitter.take(a, b);
  return emitter.finish();
}

Answer by_boost(const Workload& w) {
  return typed(w, [&](auto axes) {
    constexpr int D = axes;
    PlainEmitter emitter(w);
    const BoostTree<D> tree(w);
    if (!w.other) tree.join(emitter);
    if (w.other)
      for (const auto& value : BoostTree<D>::values_of(*w.other))
        tree.probe(value, [&](std::uint32_t of_other, std::uint32_t hit) { emitter.take(hit, of_other); });
    return emitter.finish();
  });
}

Answer by_stepping(const Workload& w, double dt) {
  return typed(w, [&](auto axes) {
    constexpr int D = axes;
    NeverInterrupt never;
    Answer answer;
    std::unordered_set<std::uint64_t> seen;
    std::vector<Box<D>> boxes;
    std::vector<Pair> batch;
    const long steps = std::lround(std::floor(w.h / dt + 1e-9));
    for (long step = 0; step <= steps; ++step) {
      const double t = static_cast<double>(step) * dt;
      place_boxes<D>(w, t, boxes);
      const testing::RestingBodies<D> placed(boxes);
      const auto grid = make_gpcd_grid<D>(placed.side(), nullptr, never);
      for (; grid->next(batch); batch.clear())
        for (const Pair& pair : batch) {
          ++answer.candidates;
          const std::uint64_t low = std::min(pair.a, pair.b), high = std::max(pair.a, pair.b);
          // The grid rounds outward; the boxes themselves decide.
          if (boxes[pair.a].meets(boxes[pair.b]) && seen.insert(low << 32 | high).second) answer.add(pair, t);
        }
    }
    return answer;
  });
}

}  // namespace foresee::bench
