#include "index/tpr_tree/search/tree_join.h"

#include <array>
#include <vector>

#include "index/tpr_tree/moving_box.h"
#include "shape/swept_boxes.h"

namespace foresee {

// The objects of a leaf that can meet another leaf, with the box that each covers while it can. The boxes are
// stored in columns. They separate most pairs before the motions are compared.

template <int D>
struct NearObjects {
  std::vector<std::uint32_t> rows;
  std::array<std::vector<double>, D> lower, upper;

  void clear() {
    rows.clear();
    for (int axis = 0; axis < D; ++axis) {
      lower[axis].clear();
      upper[axis].clear();
    }
  }

  /// Faces are linear in time, so each is farthest out at an end of the span. The padding of moving_box.h
  /// covers the rounding error. Requires: the span is not empty.
  void add(std::uint32_t row, const MovingBox<D>& box, const SharedInterval& span) {
    const Vec<D> low = (box.lower + box.v_lower * span.begin).min(box.lower + box.v_lower * span.end),
                 high = (box.upper + box.v_upper * span.begin).max(box.upper + box.v_upper * span.end);
    rows.push_back(row);
    for (int axis = 0; axis < D; ++axis) {
      lower[axis].push_back(low[axis]);
      upper[axis].push_back(high[axis]);
    }
  }

  /// Writes the positions, from `first` on, of the boxes that meet the box of others[i]; returns their
  /// number. `out` is large enough for all. There are no branches, because the result is not predictable.
  std::size_t overlapping(const NearObjects& others, std::size_t i, std::size_t first, std::size_t last,
                          std::uint32_t* out) const {
    std::array<double, D> from, to;
    for (int axis = 0; axis < D; ++axis) from[axis] = others.lower[axis][i], to[axis] = others.upper[axis][i];
    std::size_t count = 0;
    for (std::size_t j = first; j < last; ++j) {
      bool meets = true;
      for (int axis = 0; axis < D; ++axis) {
        meets &= lower[axis][j] <= to[axis];
        meets &= from[axis] <= upper[axis][j];
      }
      out[count] = static_cast<std::uint32_t>(j);
      count += meets;
    }
    return count;
  }
};

// One side of a tree join: the moving boxes of its objects and nodes during this horizon.

template <int D>
class JoinSide {
 public:
  /// `kinds`: of the rows; null if all may meet.
  JoinSide(const Bodies& bodies, const TreeLevels& levels, const Horizon& horizon, const Vec<D>& margin,
           Interrupt& interrupt, const Kinds* kinds)
      : starts_(levels.starts) {
    if (kinds) add_kinds(kinds, bodies.count);
    boxes_.resize(starts_.size() + 1);
    boxes_[0].reserve(bodies.count);
    for (std::size_t i = 0; i < bodies.count; ++i) {
      if (i % 1024 == 0) interrupt.check();
      boxes_[0].push_back(moving_box<D>(bodies, i, horizon, margin));
    }
    for (std::size_t level = 0; level < starts_.size(); ++level)
      for (std::size_t i = 0; i + 1 < starts_[level].size(); ++i)
        boxes_[level + 1].push_back(around(level, i));
    for (std::size_t kind = 0; kind < std::min<std::size_t>(2, boxes_.size()); ++kind)
      for (std::uint32_t i = 0; i < boxes_[kind].size(); ++i)
        swept_[kind].add(i, boxes_[kind][i], boxes_[kind][i].span);
  }

  /// Level 0: leaves.
  std::size_t levels() const { return starts_.size(); }
  const MovingBox<D>& node(std::size_t level, std::uint32_t i) const { return boxes_[level + 1][i]; }
  const MovingBox<D>& object(std::uint32_t row) const { return boxes_[0][row]; }
  bool has_kinds() const { return !kinds_.empty(); }
  /// The kinds of all objects beneath a node, or-ed. Requires: kinds.
  Kinds node_kinds(std::size_t level, std::uint32_t i) const { return kinds_[level + 1][i]; }
  Kinds object_kinds(std::uint32_t row) const { return kinds_[0][row]; }
  /// The boxes of objects, and of leaves, over the whole horizon.
  const NearObjects<D>& swept_objects() const { return swept_[0]; }
  const NearObjects<D>& swept_leaves() const { return swept_[1]; }
  /// The children of node i: rows for a leaf, otherwise nodes one level down.
  std::uint32_t first(std::size_t level, std::uint32_t i) const { return starts_[level][i]; }
  std::uint32_t last(std::size_t level, std::uint32_t i) const { return starts_[level][i + 1]; }
  /// The boxes of the children of nodes on this level.
  const std::vector<MovingBox<D>>& held(std::size_t level) const { return boxes_[level]; }

 private:
  void add_kinds(const Kinds* kinds, std::size_t count) {
    kinds_.resize(starts_.size() + 1);
    kinds_[0].assign(kinds, kinds + count);
    for (std::size_t level = 0; level < starts_.size(); ++level)
      for (std::size_t i = 0; i + 1 < starts_[level].size(); ++i) {
        Kinds all = Kinds::none();
        for (std::uint32_t child = starts_[level][i]; child < starts_[level][i + 1]; ++child)
          all.include(kinds_[level][child]);
        kinds_[level + 1].push_back(all);
      }
  }

  MovingBox<D> around(std::size_t level, std::size_t i) const {
    const Vec<D> infinity = Vec<D>::constant(std::numeric_limits<double>::infinity());
    MovingBox<D> all{infinity, -infinity, infinity, -infinity, {infinity[0], -infinity[0]}};
    for (std::uint32_t child = starts_[level][i]; child < starts_[level][i + 1]; ++child) {
      const MovingBox<D>& box = boxes_[level][child];
      if (box.span.is_empty()) continue;
      all.lower = all.lower.min(box.lower), all.upper = all.upper.max(box.upper);
      all.v_lower = all.v_lower.min(box.v_lower), all.v_upper = all.v_upper.max(box.v_upper);
      all.span = {std::min(all.span.begin, box.span.begin), std::max(all.span.end, box.span.end)};
    }
    return all;
  }

  std::vector<std::vector<std::uint32_t>> starts_;
  NearObjects<D> swept_[2];
  std::vector<std::vector<MovingBox<D>>> boxes_;  ///< [0]: objects, [k + 1]: nodes of level k
  std::vector<std::vector<Kinds>> kinds_;         ///< the same, or empty if all may meet
};

namespace {

constexpr std::size_t batch_size = 4096;

template <int D>
class TreeJoin final : public Candidates {
 public:
  /// If `b` is null: pairs within a.
  TreeJoin(std::unique_ptr<JoinSide<D>> a, std::unique_ptr<JoinSide<D>> b, Interrupt& interrupt)
      : own_a_(std::move(a)),
        own_b_(std::move(b)),
        a_(*own_a_),
        b_(own_b_ ? *own_b_ : *own_a_),
        self_(!own_b_),
        kinds_(a_.has_kinds() && b_.has_kinds()),
        interrupt_(interrupt) {
    if (a_.levels() > 0 && b_.levels() > 0)
      open_if_meeting(a_.levels() - 1, 0, b_.levels() - 1, 0, everything());
  }

  bool next(std::vector<Pair>& out) override {
    const std::size_t before = out.size();
    while (!open_.empty() && out.size() - before < batch_size) {
      if (++steps_ % 64 == 0) interrupt_.check();
      const NodePair pair = open_.back();
      open_.pop_back();
      if (pair.level_a == 0 && pair.level_b == 0)
        join_leaves(pair, out);
      else
        open_children(pair);
    }
    return out.size() > before || !open_.empty();
  }

 private:
  /// Two nodes, and the interval in which their boxes can meet.
  struct NodePair {
    std::size_t level_a, level_b;
    std::uint32_t a, b;
    SharedInterval span;
  };

  static SharedInterval everything() { return {0, std::numeric_limits<double>::infinity()}; }

  /// Narrows `span` to the interval in which two boxes can meet; false if they cannot.
  static bool meet(const MovingBox<D>& a, const MovingBox<D>& b, SharedInterval& span) {
    span.begin = std::max({span.begin, a.span.begin, b.span.begin});
    span.end = std::min({span.end, a.span.end, b.span.end});
    return !span.is_empty() && narrow_to_contact(a, b, span);
  }

  void open_if_meeting(std::size_t level_a, std::uint32_t a, std::size_t level_b, std::uint32_t b,
                       SharedInterval span) {
    if (kinds_ && !may_meet(a_.node_kinds(level_a, a), b_.node_kinds(level_b, b))) return;
    if (meet(a_.node(level_a, a), b_.node(level_b, b), span)) open_.push_back({level_a, level_b, a, b, span});
  }

  /// Opens the higher node of a pair, or both.
  void open_children(const NodePair& pair) {
    if (self_ && pair.a == pair.b && pair.level_a == pair.level_b) return open_within(pair);
    const bool open_a = pair.level_a >= pair.level_b, open_b = pair.level_b >= pair.level_a;
    const std::size_t level_a = pair.level_a - open_a, level_b = pair.level_b - open_b;
    const std::uint32_t first_a = open_a ? a_.first(pair.level_a, pair.a) : pair.a,
                        last_a = open_a ? a_.last(pair.level_a, pair.a) : pair.a + 1,
                        first_b = open_b ? b_.first(pair.level_b, pair.b) : pair.b,
                        last_b = open_b ? b_.last(pair.level_b, pair.b) : pair.b + 1;
    for (std::uint32_t a = first_a; a < last_a; ++a) {
      SharedInterval span = pair.span;
      if (kinds_ && !may_meet(a_.node_kinds(level_a, a), b_.node_kinds(pair.level_b, pair.b))) continue;
      if (!meet(a_.node(level_a, a), b_.node(pair.level_b, pair.b), span)) continue;
      for (std::uint32_t b = first_b; b < last_b; ++b) open_if_meeting(level_a, a, level_b, b, span);
    }
  }

  void open_within(const NodePair& pair) {
    const std::size_t level = pair.level_a - 1;
    const std::uint32_t first = a_.first(pair.level_a, pair.a), last = a_.last(pair.level_a, pair.a);
    for (std::uint32_t a = first; a < last; ++a) {
      const SharedInterval span = a_.node(level, a).span;
      const bool meets = !kinds_ || may_meet(a_.node_kinds(level, a), a_.node_kinds(level, a));
      if (!span.is_empty() && meets) open_.push_back({level, level, a, a, span});
      for (std::uint32_t b = a + 1; b < last; ++b) open_if_meeting(level, a, level, b, pair.span);
    }
  }

  void join_leaves(const NodePair& pair, std::vector<Pair>& out) {
    const bool within = self_ && pair.a == pair.b;
    gather(a_, pair.a, b_, pair.b, pair.span, near_a_);
    if (!within) gather(b_, pair.b, a_, pair.a, pair.span, near_b_);
    const NearObjects<D>& near_b = within ? near_a_ : near_b_;
    overlapping_.resize(near_b.rows.size());
    for (std::size_t i = 0; i < near_a_.rows.size(); ++i) {
      const std::uint32_t a = near_a_.rows[i];
      const std::size_t count =
          near_b.overlapping(near_a_, i, within ? i + 1 : 0, near_b.rows.size(), overlapping_.data());
      for (std::size_t hit = 0; hit < count; ++hit) {
        const std::uint32_t b = near_b.rows[overlapping_[hit]];
        if (kinds_ && !may_meet(a_.object_kinds(a), b_.object_kinds(b))) continue;
        SharedInterval span = pair.span;
        if (meet(a_.object(a), b_.object(b), span)) out.push_back({a, b});
      }
    }
  }

  /// Collects the objects of a leaf that can meet the other leaf's box, with their boxes during that time.
  void gather(const JoinSide<D>& side, std::uint32_t leaf, const JoinSide<D>& other_side, std::uint32_t other,
              const SharedInterval& when, NearObjects<D>& near) {
    const std::uint32_t first = side.first(0, leaf), last = side.last(0, leaf);
    overlapping_.resize(last - first);
    const std::size_t count =
        side.swept_objects().overlapping(other_side.swept_leaves(), other, first, last, overlapping_.data());
    near.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t row = overlapping_[i];
      if (kinds_ && !may_meet(side.object_kinds(row), other_side.node_kinds(0, other))) continue;
      SharedInterval span = when;
      if (meet(side.object(row), other_side.node(0, other), span)) near.add(row, side.object(row), span);
    }
  }

  std::unique_ptr<JoinSide<D>> own_a_, own_b_;
  const JoinSide<D>&a_, &b_;
  bool self_, kinds_;
  Interrupt& interrupt_;
  std::size_t steps_ = 0;
  std::vector<NodePair> open_;
  NearObjects<D> near_a_, near_b_;
  std::vector<std::uint32_t> overlapping_;
};

}  // namespace

template <int D>
std::unique_ptr<Candidates> make_tree_join(const Bodies& bodies, const TreeLevels& levels,
                                           const Horizon& horizon, const Vec<D>& margin, Interrupt& interrupt,
                                           const Kinds* kinds) {
  return std::make_unique<TreeJoin<D>>(
      std::make_unique<JoinSide<D>>(bodies, levels, horizon, margin, interrupt, kinds), nullptr, interrupt);
}

template <int D>
std::unique_ptr<Candidates> make_tree_join(const Bodies& bodies_a, const TreeLevels& levels_a,
                                           const Bodies& bodies_b, const TreeLevels& levels_b,
                                           const Horizon& horizon, const Vec<D>& margin, Interrupt& interrupt,
                                           const Kinds* kinds_a, const Kinds* kinds_b) {
  return std::make_unique<TreeJoin<D>>(
      std::make_unique<JoinSide<D>>(bodies_a, levels_a, horizon, margin, interrupt, kinds_a),
      std::make_unique<JoinSide<D>>(bodies_b, levels_b, horizon, margin, interrupt, kinds_b), interrupt);
}

#define FORESEE_OF_AXES(D)                                                                                 \
  template std::unique_ptr<Candidates> make_tree_join<D>(const Bodies&, const TreeLevels&, const Horizon&, \
                                                         const Vec<D>&, Interrupt&, const Kinds*);         \
  template std::unique_ptr<Candidates> make_tree_join<D>(const Bodies&, const TreeLevels&, const Bodies&,  \
                                                         const TreeLevels&, const Horizon&, const Vec<D>&, \
                                                         Interrupt&, const Kinds*, const Kinds*)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
