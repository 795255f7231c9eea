#include "index/tpr_tree/search/nearest_walk.h"

#include <algorithm>
#include <cmath>

namespace foresee {
namespace {

/// The gap between two boxes along each axis at one time, and its rate of change; 0 where they overlap.
template <int D>
struct Gap {
  Vec<D> width, speed;

  Gap(const MovingBox<D>& a, const MovingBox<D>& b, double tau) {
    const Vec<D> left_speed = a.v_lower - b.v_upper, right_speed = b.v_lower - a.v_upper;
    const Vec<D> left = a.lower - b.upper + left_speed * tau, right = b.lower - a.upper + right_speed * tau;
    width = (left > 0).select(left, (right > 0).select(right, 0.0));
    speed = (left > 0).select(left_speed, (right > 0).select(right_speed, 0.0));
  }
  double squared() const { return width.square().sum(); }
  double growth() const { return 2 * (width * speed).sum(); }
};

/// Along each axis the gap is the max of two linear functions and 0, so its min is at an end of the span, or
/// 0.
template <int D>
Vec<D> min_gaps(const MovingBox<D>& a, const MovingBox<D>& b, const SharedInterval& span) {
  const Vec<D> left = a.lower - b.upper, right = b.lower - a.upper;
  const Vec<D> left_speed = a.v_lower - b.v_upper, right_speed = b.v_lower - a.v_upper;
  auto min_gap = [&](const Vec<D>& gap, const Vec<D>& speed) -> Vec<D> {
    const Vec<D> first = gap + speed * span.begin, last = gap + speed * span.end;
    return (first > 0 && last > 0).select(first.min(last), 0.0);
  };
  return min_gap(left, left_speed).max(min_gap(right, right_speed));
}

inline constexpr double shrink = 1 - 0x1p-44;  // exceeds the rounding error of the numbers it is applied to

/// A lower bound of the squared distance, which is a convex function of time and so is above its tangents.
/// The span is halved towards the minimum some times; then the tangents at both ends cross at a lower bound.
/// Slopes so small that their products may have underflowed give no bound. The same holds for slopes of 0;
/// then the gaps along each axis give the bound.
template <int D>
double tangent_bound(const MovingBox<D>& a, const MovingBox<D>& b, SharedInterval span) {
  constexpr int halvings = 5;
  constexpr double min_slope = 1e-290;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (span.begin + span.end);
    (Gap<D>(a, b, middle).growth() > 0 ? span.end : span.begin) = middle;
  }
  const Gap<D> first(a, b, span.begin), last(a, b, span.end);
  const double f = first.squared(), down = first.growth(), g = last.squared(), up = last.growth();
  if (std::abs(down) < min_slope || std::abs(up) < min_slope) return 0;
  if (down >= 0) return f * shrink;
  if (up <= 0) return g * shrink;
  const double tau = (g - f - up * (span.end - span.begin)) / (down - up);
  return f + down * tau - (f + g - down * tau + up * (span.end - span.begin)) * 0x1p-44;
}

/// True if one box passes the other as a whole, farther than its width. Only then are tangents better than
/// the gaps along each axis.
template <int D>
bool moves_far(const MovingBox<D>& a, const MovingBox<D>& b, const SharedInterval& span) {
  const Vec<D> speed = (a.v_lower - b.v_upper) + (a.v_upper - b.v_lower);
  const Vec<D> width = (a.upper - a.lower) + (b.upper - b.lower);
  return (speed.abs() * (0.5 * (span.end - span.begin)) > width).any();
}

}  // namespace

template <int D>
double min_distance(const MovingBox<D>& a, const MovingBox<D>& b, const SharedInterval& span) {
  const Vec<D> gaps = min_gaps(a, b, span);
  const double by_axis = gaps.square().sum(), widest = gaps.largest();
  double squared = by_axis * shrink;
  if (D > 1 && moves_far(a, b, span)) squared = std::max(squared, tangent_bound(a, b, span));
  // Squares outside the range of doubles give no bound; the widest gap always does.
  return squared > 1e-280 && squared < 1e280 ? std::sqrt(squared) * shrink : widest * shrink;
}

/// The distance of the two chords, less the max deviation of both centres from their chords. All faces of
/// `point` move alike. The rounding error, including that of tau, is about 10 units of magnitudes; `off` is
/// padded by 32 of them.
template <int D>
double min_point_distance(const MovingBox<D>& point, const MovingBox<D>& query) {
  const Vec<D> gap = 0.5 * point.lower - 0.5 * query.lower + (0.5 * point.upper - 0.5 * query.upper);
  const Vec<D> off = 0.5 * point.upper - 0.5 * point.lower + (0.5 * query.upper - 0.5 * query.lower);
  const Vec<D> speed = point.v_lower - query.v_lower;
  const double fastest = speed.abs().largest(),
               farthest = (gap.abs() + speed.abs() * point.span.end).largest();
  const bool squares_fit = farthest < 1e140 && fastest < 1e140 && (fastest > 1e-140 || fastest == 0);
  if (!squares_fit) return min_distance(point, query, point.span);
  double tau = point.span.begin;
  if (fastest > 0)
    tau = std::clamp(-(gap * speed).sum() / speed.square().sum(), point.span.begin, point.span.end);
  const double distance = std::sqrt((gap + speed * tau).square().sum()) - std::sqrt(off.square().sum());
  return distance > 1e-140 ? distance * shrink : 0;  // an underflowed square gives no bound
}

template <int D>
NearestWalk<D>::NearestWalk(NodeSource& source, const Vec<D>& point, const Vec<D>& velocity,
                            const Horizon& horizon, Interrupt& interrupt, const std::optional<KindTest>& test,
                            DistanceTo to)
    : source_(source),
      interrupt_(interrupt),
      reader_(source.layout()),
      horizon_(horizon),
      query_(moving_window<D>(point, point, velocity, horizon)),
      test_(test),
      to_(to) {
  if (source.find_root() != 0) open_.push_back({0, unread_root(source)});
}

template <int D>
bool NearestWalk<D>::next(double reach, LeafHits& hits) {
  hits.slots.clear();
  hits.distances.clear();
  while (!open_.empty() && open_.front().distance <= reach) {
    interrupt_.check();
    std::pop_heap(open_.begin(), open_.end());
    const Unread open = open_.back().node;
    open_.pop_back();
    auto node = read(source_, open);
    if (!node->is_leaf()) {
      open_children(open.number, *node, reach);
      continue;
    }
    find_in_leaf(*node, reach, hits);
    if (!hits.slots.empty()) {
      hits.leaf = std::move(node);
      return true;
    }
  }
  hits.leaf = nullptr;
  return false;
}

template <int D>
[[gnu::flatten]] void NearestWalk<D>::open_children(NodeNumber number, const Node& inner, double reach) {
  for (std::size_t slot = 0; slot < inner.size(); ++slot) {
    if (test_ && !test_->accepts(kinds_at(inner, slot))) continue;
    const Times lives = times_at<D>(inner, slot);  // cheaper than a box, whose span is the same
    if (reader_.ends() && span_between(lives.t_min, lives.until_max, horizon_).is_empty()) continue;
    const MovingBox<D> box = child_box<D>(inner, slot, horizon_);
    if (box.span.is_empty()) continue;
    const double distance = min_distance(box, query_, box.span);
    if (distance > reach) continue;
    open_.push_back({distance, unread_child(number, inner, slot)});
    std::push_heap(open_.begin(), open_.end());
  }
}

template <int D>
template <bool plain, bool to_centre>
[[gnu::flatten]] void NearestWalk<D>::find_near(const Node& leaf, double reach) {
  for (std::size_t slot = 0; slot < leaf.size(); ++slot) {
    const double* record = reader_.record(leaf, slot);
    if constexpr (!plain) {
      if (test_ && !test_->accepts(reader_.kinds(record))) continue;
      if (reader_.is_head(record)) continue;
    }
    const Motion<D> motion = reader_.own_motion(record);
    const Extents<D> extents = to_centre ? Extents<D>::none() : reader_.own_extents(record);
    const MovingBox<D> box = moving_box<D>(motion, extents, horizon_, Vec<D>::zero());
    if (box.span.is_empty()) continue;
    const double distance = to_centre ? min_point_distance(box, query_) : min_distance(box, query_, box.span);
    if (distance <= reach) near_.emplace_back(distance, static_cast<std::uint32_t>(slot));
  }
}

template <int D>
void NearestWalk<D>::find_in_leaf(const Node& leaf, double reach, LeafHits& hits) {
  near_.clear();
  const bool plain = !test_ && reader_.is_plain();
  const bool to_centres = to_ == DistanceTo::centres;
  if (plain && to_centres) find_near<true, true>(leaf, reach);
  if (plain && !to_centres) find_near<true, false>(leaf, reach);
  if (!plain && to_centres) find_near<false, true>(leaf, reach);
  if (!plain && !to_centres) find_near<false, false>(leaf, reach);
  std::sort(near_.begin(), near_.end());
  for (const auto& [distance, slot] : near_) {
    hits.slots.push_back(slot);
    hits.distances.push_back(distance);
  }
}

#define FORESEE_OF_AXES(D)                                                                          \
  template double min_distance<D>(const MovingBox<D>&, const MovingBox<D>&, const SharedInterval&); \
  template double min_point_distance<D>(const MovingBox<D>&, const MovingBox<D>&);                  \
  template class NearestWalk<D>
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
