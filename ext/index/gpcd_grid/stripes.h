// Stripes of the grid, GPCD step 3: every box is entered into the stripes that it meets.
//
//   Stripes<2> stripes(source, frame, partition, rows, memory, helpers, interrupt);
//   for (Key key : stripes.entries(7)) …                 // the boxes that meet stripe 7, by row number
//
// Each thread reads its range of objects and collects rows, entries and the number of entries per stripe.
// Then each thread writes its entries behind those of the ranges before its own. So the stripes are the same
// for any number of threads. A box is entered a handful of times at most, because giants are not entered but
// listed separately. Memory: a float box and about 20 bytes per entry.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "index/gpcd_grid/float_lanes.h"
#include "index/gpcd_grid/moving_source.h"
#include "index/gpcd_grid/object_rows.h"
#include "index/gpcd_grid/sort_keys.h"
#include "index/gpcd_grid/work_space.h"

namespace foresee::gpcd {

// All objects of one side as rows of floats, by row number: GPCD step 1.
//
//   FloatRows<2> rows(count, columns, objects, nullptr, memory);
//   rows.write(first, lanes, 64);                        // step by step
//   FloatBox<2> box = rows.box(7);                       // of the object in row 7
//
// A row holds the lower ends and the upper ends, then travel and life if `columns` has them. So one object
// takes one or two cache lines.
template <int D>
class FloatRows {
 public:
  FloatRows(std::size_t count, Columns columns, const ObjectRows& objects, const Kinds* kinds,
            Buffer<float>& memory)
      : columns_(columns),
        objects_(objects),
        kinds_(kinds),
        width_(static_cast<std::size_t>(width(columns))),
        count_(count),
        values_(memory.room(count * width_)) {}

  std::size_t count() const { return count_; }
  Columns columns() const { return columns_; }
  /// The location of the same objects in full.
  const ObjectRows& objects() const { return objects_; }
  /// The kinds of the same objects; null: all may meet.
  const Kinds* kinds() const { return kinds_; }
  /// The number of floats in a row.
  static constexpr int width(Columns columns) {
    return 2 * D + (columns.travel ? D : 0) + (columns.life ? 2 : 0);
  }
  const float* row(std::size_t i) const { return values_ + i * width_; }
  FloatBox<D> box(std::size_t i) const {
    FloatBox<D> box;
    std::copy_n(row(i), D, box.lower);
    std::copy_n(row(i) + D, D, box.upper);
    return box;
  }

  /// Writes the first `count` lanes to the rows from `first` on.
  void write(std::size_t first, const FloatLanes<D>& lanes, std::size_t count);

 private:
  Columns columns_;
  ObjectRows objects_;
  const Kinds* kinds_;
  std::size_t width_, count_;
  float* values_;
};

/// The first and last stripe number of a box on one axis, both inclusive.
struct StripeRange {
  int first, last;
};

template <int D>
StripeRange stripe_range(const Partition<D>& partition, const FloatBox<D>& box, int axis) {
  return {partition.axis[axis].index(box.lower[axis]), partition.axis[axis].index(box.upper[axis])};
}

template <int D>
class Stripes {
 public:
  /// Enters all objects of the source and writes all rows. Each box is entered into every stripe that it
  /// meets, or listed as a giant; empty boxes are not entered. Requires: source.count() < 2^32; rows and
  /// memory outlive the stripes. Throws Error if there are more than 2^32 entries.
  Stripes(const MovingSource<D>& source, const FloatFrame<D>& frame, const Partition<D>& partition,
          FloatRows<D>& rows, GridSpace::Side& memory, std::size_t helpers, Interrupt& interrupt);

  const FloatRows<D>& rows() const { return rows_; }
  /// Row numbers of the giants, the boxes outside the grid.
  const std::vector<std::uint32_t>& giants() const { return giants_; }
  /// The boxes in one stripe, not sorted.
  std::span<const Key> entries(std::size_t stripe) const {
    return {keys_ + starts_[stripe], starts_[stripe + 1] - starts_[stripe]};
  }
  std::size_t entry_count() const { return entry_count_; }

 private:
  /// The entries that one thread has collected.
  struct Part {
    Key* keys = nullptr;
    std::uint32_t *stripes = nullptr, *counts = nullptr;
    std::size_t size = 0;
    std::vector<std::uint32_t> giants;
  };

  /// Computes the boxes of the objects [begin, end), writes them as rows, and adds the entries of each.
  void collect_entries(const MovingSource<D>& source, const FloatFrame<D>& frame, std::size_t begin,
                       std::size_t end, GridSpace::Part& memory, Part& part, Interrupt& interrupt);
  /// Adds the boxes in these lanes to the part, in their order: each with an entry per stripe that it meets, or as a
  /// giant.
  void add_entries(const FloatLanes<D>& lanes, std::size_t first, std::size_t count, GridSpace::Part& memory,
                   Part& part) const;
  /// Computes where each stripe starts in keys_, and within it each part's entries, part after part.
  void add_up(std::span<Part> parts);
  /// Writes a part's entries where add_up() has computed; several threads may do so in parallel.
  void place(Part& part, Interrupt& interrupt);

  Partition<D> partition_;
  FloatRows<D>& rows_;
  std::vector<std::uint32_t> giants_;
  std::uint32_t* starts_;  // where each stripe starts in keys_; one more at the end
  Key* keys_ = nullptr;
  std::size_t entry_count_ = 0;
};

}  // namespace foresee::gpcd
