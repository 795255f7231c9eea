#include "index/paper_grid/paper_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "base/repeatable_choice.h"

namespace foresee {
namespace {

constexpr double entries_per_object = 64;
constexpr double cells_per_axis = 1 << 21;  // three such numbers fit into 64 bits
constexpr std::size_t pairs_per_batch = 4096;
constexpr std::size_t steps_per_batch = 1 << 17;
constexpr std::size_t steps_per_check = 1 << 13;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The statistics of one axis for step 2.
struct AxisFigures {
  double sum = 0, lowest = infinity, highest = -infinity;
  std::size_t count = 0;

  void add(double lower, double upper) {
    sum += upper - lower;
    lowest = std::min(lowest, lower);
    highest = std::max(highest, upper);
    ++count;
  }
  double cell() const {
    if (count == 0) return infinity;
    const double mean = sum / static_cast<double>(count);
    const double size = std::max(mean, (highest - lowest) / (cells_per_axis - 1));
    return size > 0 && std::isfinite(1 / size) ? size : infinity;
  }
};

}  // namespace

template <int D>
PaperGrid<D>::PaperGrid(std::span<const Box<D>> boxes, Interrupt& interrupt)
    : interrupt_(interrupt), between_(false) {
  build({boxes, {}});
}

template <int D>
PaperGrid<D>::PaperGrid(std::span<const Box<D>> boxes_a, std::span<const Box<D>> boxes_b,
                        Interrupt& interrupt)
    : interrupt_(interrupt), between_(true) {
  build({boxes_a, boxes_b});
}

template <int D>
void PaperGrid<D>::build(const Sides& sides) {
  const Cuts cuts = choose_cells(sides);
  enter(sides, cuts);
  group_entries();
}

/// Never decreases as x increases, so boxes that meet share a cell despite rounding. Infinity times zero is
/// NaN, which std::max() replaces by 0.
template <int D>
typename PaperGrid<D>::Place PaperGrid<D>::Cuts::place(const Vec<D>& x) const {
  Place place;
  for (int k = 0; k < D; ++k)
    place[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(
        std::min(std::max(0.0, (x[k] - from[k]) * per_unit[k]), cells_per_axis - 1));
  return place;
}

/// Step 2, with the bound on memory.
template <int D>
typename PaperGrid<D>::Cuts PaperGrid<D>::choose_cells(const Sides& sides) {
  AxisFigures axis[D];
  for (const auto& boxes : sides)
    for (const Box<D>& box : boxes)
      if (!box.is_empty())
        for (int k = 0; k < D; ++k) axis[k].add(box.lower[k], box.upper[k]);
  Cuts cuts;
  for (int k = 0; k < D; ++k) {
    figures_.cell[k] = axis[k].cell();
    cuts.per_unit[k] = 1 / figures_.cell[k];
    cuts.from[k] = std::isfinite(axis[k].lowest) ? axis[k].lowest : 0;
  }
  const double limit = entries_per_object * static_cast<double>(sides[0].size() + sides[1].size() + 1);
  double count = entry_count(sides, cuts);
  for (; count > limit; count = entry_count(sides, cuts)) {
    cuts.per_unit /= 2;
    figures_.cell *= 2;
    figures_.doubled *= 2;
  }
  entries_.reserve(static_cast<std::size_t>(count));
  return cuts;
}

template <int D>
double PaperGrid<D>::entry_count(const Sides& sides, const Cuts& cuts) {
  interrupt_.check();
  double sum = 0;
  for (const auto& boxes : sides)
    for (const Box<D>& box : boxes) {
      if (box.is_empty()) continue;
      const Place first = cuts.place(box.lower), last = cuts.place(box.upper);
      double cells = 1;
      for (std::size_t k = 0; k < D; ++k) cells *= static_cast<double>(last[k] - first[k]) + 1;
      sum += cells;
    }
  return sum;
}

template <int D>
std::uint64_t PaperGrid<D>::number_of(const Place& place) {
  std::uint64_t number = 0;
  for (std::uint32_t along : place) number = number << 21 | along;
  return number;
}

/// Step 3.
template <int D>
void PaperGrid<D>::enter(const Sides& sides, const Cuts& cuts) {
  for (std::uint32_t side = 0; side < 2; ++side) {
    first_[side].resize(sides[side].size());
    for (std::uint32_t i = 0; i < sides[side].size(); ++i) {
      if (i % steps_per_check == 0) interrupt_.check();
      const Box<D>& box = sides[side][i];
      if (box.is_empty()) continue;
      const Place first = cuts.place(box.lower), last = cuts.place(box.upper);
      first_[side][i] = first;
      for (Place cell = first;;) {
        entries_.push_back({number_of(cell), i, side});
        std::size_t k = 0;
        while (k < D && cell[k] == last[k]) {
          cell[k] = first[k];
          ++k;
        }
        if (k == D) break;
        ++cell[k];
      }
    }
  }
  figures_.entries = entries_.size();
}

/// Groups entries by cell: a counting sort by hash bucket, then a sort within each bucket.
template <int D>
void PaperGrid<D>::group_entries() {
  const int bits = std::bit_width(entries_.size() | 1);
  auto bucket = [bits](const Entry& entry) { return entry.cell * by_golden_ratio >> (64 - bits); };
  std::vector<std::size_t> ends((std::size_t{1} << bits) + 1);
  for (const Entry& entry : entries_) ++ends[bucket(entry) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  interrupt_.check();
  std::vector<Entry> grouped(entries_.size());
  for (const Entry& entry : entries_) grouped[ends[bucket(entry)]++] = entry;
  entries_ = std::move(grouped);

  std::size_t steps = 0, begin = 0;
  for (std::size_t end : ends) {  // the end of each bucket; the end of the last one comes twice
    if (end - begin > 1)
      std::sort(entries_.data() + begin, entries_.data() + end, [&](const Entry& l, const Entry& r) {
        if (++steps % steps_per_check == 0) interrupt_.check();
        return l.cell != r.cell ? l.cell < r.cell : l.side != r.side ? l.side < r.side : l.object < r.object;
      });
    begin = end;
  }
  for (std::size_t i = 0; i < entries_.size(); ++i)
    figures_.cells += i == 0 || entries_[i].cell != entries_[i - 1].cell;
}

/// True if both boxes start at or before the cell and one of them starts there, on every axis.
template <int D>
bool PaperGrid<D>::is_reference(const Entry& a, const Entry& b) const {
  const Place &first_a = first_[a.side][a.object], &first_b = first_[b.side][b.object];
  Place shared;
  for (std::size_t k = 0; k < D; ++k) shared[k] = std::max(first_a[k], first_b[k]);
  return number_of(shared) == a.cell;
}

template <int D>
bool PaperGrid<D>::open_cell() {
  a_ = end_;
  if (a_ == entries_.size()) return false;
  while (end_ < entries_.size() && entries_[end_].cell == entries_[a_].cell) ++end_;
  from_ = a_;
  while (between_ && from_ < end_ && entries_[from_].side == 0) ++from_;
  a_end_ = between_ ? from_ : end_;
  b_ = between_ ? from_ : a_ + 1;
  return true;
}

/// Step 4. A batch may end within a cell.
template <int D>
bool PaperGrid<D>::next(std::vector<Pair>& out) {
  interrupt_.check();
  const std::size_t full = out.size() + pairs_per_batch;
  for (std::size_t steps = 0; steps < steps_per_batch && out.size() < full; ++steps) {
    if (a_ >= a_end_) {
      if (!open_cell()) return steps > 0;
    } else if (b_ >= end_) {
      ++a_;
      b_ = between_ ? from_ : a_ + 1;
    } else {
      const Entry &a = entries_[a_], &b = entries_[b_++];
      if (is_reference(a, b)) out.push_back({a.object, b.object});
    }
  }
  return true;
}

template <int D>
std::string PaperGrid<D>::describe() const {
  char text[64];
  std::string all = "cells of ";
  for (int k = 0; k < D; ++k) {
    std::snprintf(text, sizeof text, "%s%.4g", k > 0 ? " x " : "", figures_.cell[k]);
    all += text;
  }
  if (figures_.doubled > 1) {
    std::snprintf(text, sizeof text, " (%g times the mean intervals, to save memory)", figures_.doubled);
    all += text;
  }
  return all + ", " + std::to_string(figures_.entries) + " entries in " + std::to_string(figures_.cells) +
         " cells";
}

template <int D>
std::unique_ptr<PaperGrid<D>> make_paper_grid(const Bodies& a, const Bodies& b, bool between,
                                              const Horizon& horizon, const Vec<D>& margin,
                                              Interrupt& interrupt) {
  const std::vector<Box<D>> boxes_a = swept_boxes<D>(a, horizon, margin, interrupt);
  if (!between) return std::make_unique<PaperGrid<D>>(boxes_a, interrupt);
  const std::vector<Box<D>> boxes_b = swept_boxes<D>(b, horizon, margin, interrupt);
  return std::make_unique<PaperGrid<D>>(boxes_a, boxes_b, interrupt);
}

#define FORESEE_OF_AXES(D)                                                                                   \
  template class PaperGrid<D>;                                                                               \
  template std::unique_ptr<PaperGrid<D>> make_paper_grid(const Bodies&, const Bodies&, bool, const Horizon&, \
                                                         const Vec<D>&, Interrupt&)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
