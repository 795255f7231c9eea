#include <algorithm>
#include <cmath>
#include <utility>

#include "base/axes.h"
#include "base/float_environment.h"
#include "index/tpr_tree/search/sweep_walk.h"
#include "query/join/join_scenes.h"
#include "query/sweep/sweep.h"
#include "query/tile/tile.h"

namespace foresee {
namespace {

constexpr std::size_t objects_per_check = 4096;
constexpr std::size_t worth_a_copy = 16;  // at most so many objects kept for each one left out

template <int D>
SweepWalk<D> walk_of(NodeSource& tree, const JoinQuestion& question, Interrupt& interrupt) {
  return {tree,
          question.tile->closed<D>(),
          {question.now, question.h},
          sweep_margin<D>(question.within, question.within_z),
          interrupt};
}

/// Computes the marks of objects; for objects well inside the tile without their exact box.
template <int D>
class Marker {
 public:
  explicit Marker(const JoinQuestion& question)
      : tile_(*question.tile),
        closed_(tile_.closed<D>()),
        horizon_{question.now, question.h},
        margin_(sweep_margin<D>(question.within, question.within_z)) {}

  [[gnu::flatten]] TileMarks operator()(const Bodies& bodies, std::size_t i) const {
    const Motion<D> motion = motion_of<D>(bodies, i);
    const Extents<D> extents = largest_extents<D>(bodies, i, horizon_);
    if (is_plainly_inside(motion, extents)) return Tile::owned;
    return tile_.marks(swept_box<D>(bodies, i, horizon_, margin_));
  }

 private:
  /// Whether a box around the swept box is inside the tile. Neither a turning point nor a shorter lifetime
  /// makes the swept box larger. swept_box() adds less than 128 units of 2^-53 of its operands for rounding,
  /// and nothing overflows below `largest`.
  bool is_plainly_inside(const Motion<D>& motion, const Extents<D>& extents) const {
    constexpr double rounding = 0x1p-46, largest = 1e300;
    const double reach = std::abs(horizon_.now - motion.t) + horizon_.h;
    const Vec<D> speed = motion.v.abs() + reach * motion.a.abs();
    const Vec<D> size = motion.x.abs() + reach_of(extents) + margin_ + reach * speed;
    const Vec<D> around = size - motion.x.abs() + (size * rounding + (reach + 0x1p20) * 0x1p-1020);
    return (motion.x - around >= closed_.lower && motion.x + around < closed_.upper && size < largest &&
            speed < largest)
               .all() &&
           !life_of(motion.t, motion.until, horizon_).none;
  }

  Tile tile_;
  Box<D> closed_;
  Horizon horizon_;
  Vec<D> margin_;
};

template <int D>
void read_tile(NodeSource& tree, const JoinQuestion& question, Interrupt& interrupt, Scene& scene) {
  const Marker<D> marks_of(question);
  SweepWalk<D> walk = walk_of<D>(tree, question, interrupt);
  LeafBodies leaf_bodies(scene.layout);
  while (const auto leaf = walk.next()) {
    const Bodies bodies = leaf_bodies.of(*leaf);
    for (std::size_t i = 0; i < bodies.count; ++i) {
      if (marks_of(bodies, i) & Tile::unneeded) continue;
      scene.ids.push_back(leaf->keys[i]);
      scene.rows.insert(scene.rows.end(), bodies.row(i), bodies.row(i) + bodies.at.size);
    }
  }
}

struct MarkedScene {
  std::vector<TileMarks> marks;
  std::size_t needed = 0;
  bool owns_all = true;
};

template <int D>
MarkedScene marked(const Scene& scene, const JoinQuestion& question, Interrupt& interrupt) {
  const Marker<D> marks_of(question);
  const Bodies bodies = scene.bodies();
  MarkedScene all;
  all.marks.resize(bodies.count);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    if (i % objects_per_check == 0) interrupt.check();
    const TileMarks marks = marks_of(bodies, i);
    all.marks[i] = marks;
    all.needed += !(marks & Tile::unneeded);
    all.owns_all &= marks == Tile::owned;
  }
  return all;
}

/// marked() of a scene with plans: legs have the marks of their mover, whose box contains all of its legs.
template <int D>
MarkedScene marked_movers(const Scene& scene, const JoinQuestion& question, Interrupt& interrupt) {
  const Horizon horizon{question.now, question.h};
  const Vec<D> margin = sweep_margin<D>(question.within, question.within_z);
  const Bodies bodies = scene.bodies();
  MarkedScene all;
  all.marks.resize(bodies.count);
  for (std::size_t mover = 0; mover + 1 < scene.first_rows.size(); ++mover) {
    interrupt.check();
    const Box<D> hull = swept_box_of<D>(bodies, scene.rows_of(mover), horizon, margin);
    const TileMarks marks = question.tile->marks(hull);
    const auto begin = all.marks.begin();
    std::fill(begin + scene.first_rows[mover], begin + scene.first_rows[mover + 1], marks);
    all.needed += marks & Tile::unneeded ? 0 : scene.first_rows[mover + 1] - scene.first_rows[mover];
    all.owns_all &= marks == Tile::owned;
  }
  return all;
}

template <int D>
MarkedScene marked_rows(const Scene& scene, const JoinQuestion& question, Interrupt& interrupt) {
  return scene.layout.has_plan ? marked_movers<D>(scene, question, interrupt)
                               : marked<D>(scene, question, interrupt);
}

/// The scene without unneeded objects, if that is worth a copy of the others. Levels of a tree and forms
/// refer to row numbers: such a scene keeps all rows, and marks exclude the unneeded ones.
std::shared_ptr<const Scene> without_unneeded(std::shared_ptr<const Scene> scene, MarkedScene& marked,
                                              Interrupt& interrupt) {
  const std::size_t unneeded = scene->size() - marked.needed;
  if (scene->levels || scene->forms || unneeded * worth_a_copy <= marked.needed) return scene;
  const auto row_size = static_cast<std::size_t>(row_offsets(scene->layout).size);
  auto needed = std::make_shared<Scene>();
  needed->name = scene->name;
  needed->layout = scene->layout;
  needed->legs_during = scene->legs_during;
  needed->ids.reserve(marked.needed);
  needed->rows.reserve(marked.needed * row_size);
  for (std::size_t i = 0; i < scene->size(); ++i) {
    if (i % objects_per_check == 0) interrupt.check();
    if (marked.marks[i] & Tile::unneeded) continue;
    marked.marks[needed->size()] = marked.marks[i];
    needed->ids.push_back(scene->ids[i]);
    const double* const row = scene->rows.data() + i * row_size;
    needed->rows.insert(needed->rows.end(), row, row + row_size);
  }
  marked.marks.resize(marked.needed);
  needed->find_movers();
  return needed;
}

template <int D>
void mark(JoinQuestion& question, Interrupt& interrupt) {
  const bool one_scene = !question.b || question.b == question.a;
  MarkedScene a = marked_rows<D>(*question.a, question, interrupt), b;
  if (!one_scene) b = marked_rows<D>(*question.b, question, interrupt);
  if (a.owns_all && b.owns_all) return;
  const bool itself = question.b == question.a;
  auto ownership = std::make_shared<Ownership>();
  ownership->needed_a = a.needed, ownership->needed_b = one_scene ? a.needed : b.needed;
  question.a = without_unneeded(question.a, a, interrupt);
  if (itself) question.b = question.a;
  if (!one_scene) question.b = without_unneeded(question.b, b, interrupt);
  ownership->a = std::move(a.marks), ownership->b = std::move(b.marks);
  question.own = std::move(ownership);
}

}  // namespace

std::shared_ptr<const Scene> scene_of_tile(NodeSource& tree, const std::string& name,
                                           const JoinQuestion& question, Interrupt& interrupt) {
  const FloatEnvironment environment;
  auto scene = std::make_shared<Scene>();
  scene->name = name, scene->layout = tree.layout();
  with_axes(scene->layout.axes, [&]<int D>(Axes<D>) { read_tile<D>(tree, question, interrupt, *scene); });
  scene->take_forms(tree.forms(), interrupt);
  return scene;
}

double share_in_tile(NodeSource& tree, const JoinQuestion& question, Interrupt& interrupt) {
  const FloatEnvironment environment;
  return with_axes(tree.layout().axes,
                   [&]<int D>(Axes<D>) { return walk_of<D>(tree, question, interrupt).likely_share(); });
}

JoinQuestion in_tile(JoinQuestion question, Interrupt& interrupt) {
  if (!question.tile) return question;
  const FloatEnvironment environment;
  with_axes(question.a->layout.axes, [&]<int D>(Axes<D>) { mark<D>(question, interrupt); });
  return question;
}

}  // namespace foresee
