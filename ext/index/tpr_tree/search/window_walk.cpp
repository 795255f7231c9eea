#include "index/tpr_tree/search/window_walk.h"

namespace foresee {

template <int D>
WindowWalk<D>::WindowWalk(NodeSource& source, const MovingBox<D>& query, const Horizon& horizon,
                          const Vec<D>& margin, Interrupt& interrupt, const std::optional<KindTest>& test)
    : source_(source),
      interrupt_(interrupt),
      reader_(source.layout()),
      horizon_(horizon),
      query_(query),
      test_(test) {
  query_.lower = lower_end<D>(query.lower - margin, (query.lower.abs() + margin) * rounding_pad);
  query_.upper = upper_end<D>(query.upper + margin, (query.upper.abs() + margin) * rounding_pad);
  if (source.find_root() != 0) open_.push_back(unread_root(source));
}

template <int D>
bool WindowWalk<D>::next(LeafHits& hits) {
  hits.slots.clear();
  while (!open_.empty()) {
    interrupt_.check();
    const Unread open = open_.back();
    open_.pop_back();
    auto node = read(source_, open);
    if (!node->is_leaf()) {
      open_children(open.number, *node);
      continue;
    }
    const bool plain = !test_ && reader_.is_plain();
    plain ? find_in_leaf<true>(*node, hits.slots) : find_in_leaf<false>(*node, hits.slots);
    if (!hits.slots.empty()) {
      hits.leaf = std::move(node);
      return true;
    }
  }
  hits.leaf = nullptr;
  return false;
}

/// Whether some of these lives may share a time with the query. Cheaper than a box, whose span is the same.
template <int D>
bool WindowWalk<D>::exists(const Times& lives) const {
  return !shared_span(span_between(lives.t_min, lives.until_max, horizon_), query_.span).is_empty();
}

template <int D>
[[gnu::flatten]] void WindowWalk<D>::open_children(NodeNumber number, const Node& inner) {
  for (std::size_t slot = 0; slot < inner.size(); ++slot) {
    if (test_ && !test_->accepts(kinds_at(inner, slot))) continue;
    if (reader_.ends() && !exists(times_at<D>(inner, slot))) continue;
    const MovingBox<D> box = child_box<D>(inner, slot, horizon_);
    SharedInterval span = shared_span(box, query_);
    if (!span.is_empty() && narrow_to_contact(box, query_, span))
      open_.push_back(unread_child(number, inner, slot));
  }
}

template <int D>
template <bool plain>
[[gnu::flatten]] void WindowWalk<D>::find_in_leaf(const Node& leaf, std::vector<std::uint32_t>& slots) const {
  for (std::size_t slot = 0; slot < leaf.size(); ++slot) {
    const double* record = reader_.record(leaf, slot);
    if constexpr (!plain) {
      if (test_ && !test_->accepts(reader_.kinds(record))) continue;
      if (reader_.is_head(record)) continue;
    }
    if (reader_.ends() && !exists({reader_.t(record), reader_.t(record), reader_.own_until(record)}))
      continue;
    const MovingBox<D> box =
        (plain ? Mover<D>::plain(reader_, record) : Mover<D>(reader_, record)).box(horizon_, Vec<D>::zero());
    SharedInterval span = shared_span(box, query_);
    if (!span.is_empty() && narrow_to_contact(box, query_, span))
      slots.push_back(static_cast<std::uint32_t>(slot));
  }
}

template class WindowWalk<1>;
template class WindowWalk<2>;
template class WindowWalk<3>;

}  // namespace foresee
