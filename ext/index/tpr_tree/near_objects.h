// Which objects of two leaves can overlap at all? Side by side, one box each around where an object is while
// it can meet the other leaf: most pairs are told apart by these without looking at how they move.
#pragma once

#include <array>
#include <vector>

#include "index/tpr_tree/moving_box.h"

namespace foresee {

template <int D>
struct NearObjects {
  std::vector<std::uint32_t> rows;
  std::array<std::vector<double>, D> lower, upper;

  void clear() {
    rows.clear();
    for (int axis = 0; axis < D; ++axis) lower[axis].clear(), upper[axis].clear();
  }

  /// Faces are straight lines, so each is farthest out at an end of the span. The rounding of that is part of
  /// what moving_box.h pads for. Requires: the span is not empty.
  void add(std::uint32_t row, const MovingBox<D>& box, const TimeSpan& span) {
    const Vec<D> least = (box.lower + box.v_lower * span.begin).min(box.lower + box.v_lower * span.end),
                 most = (box.upper + box.v_upper * span.begin).max(box.upper + box.v_upper * span.end);
    rows.push_back(row);
    for (int axis = 0; axis < D; ++axis)
      lower[axis].push_back(least[axis]), upper[axis].push_back(most[axis]);
  }

  /// Writes the positions, from `first` on, of those whose box meets that of others[i]; returns how many
  /// there are. `out` has room for all. No branches: which ones meet cannot be foretold.
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

}  // namespace foresee
