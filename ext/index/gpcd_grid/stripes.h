// Which boxes lie in which stripe? GPCD step 3: every box is entered into the stripes that it meets.
//
//   Stripes<2> stripes(source, frame, partition, rows, memory, helpers, interrupt);
//   for (Key key : stripes.entries(7)) …                 // the boxes that meet stripe 7, by row number
//
// Each thread reads its part of the objects: rows, entries, and how many entries each stripe gets; then each
// puts its entries behind those of the parts before. So stripes are the same for any number of threads. Boxes
// are replicated a handful of times at most, because giants are left out and listed apart. Memory: a float
// box and about 20 bytes an entry.
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

// All objects of one side as rows of floats, in the order of their row numbers: GPCD step 1.
//
//   FloatRows<2> rows(count, columns, objects, memory);
//   rows.write(first, lanes, 64);                        // step by step
//   FloatBox<2> box = rows.box(7);                       // of the object in row 7
//
// A row is lower ends, upper ends, then travel and life if the columns say so. So one object is one or two
// cache lines.

template <int D>
class FloatRows {
 public:
  FloatRows(std::size_t count, Columns columns, const ObjectRows& objects, Buffer<float>& memory)
      : columns_(columns),
        objects_(objects),
        width_(static_cast<std::size_t>(width(columns))),
        count_(count),
        values_(memory.room(count * width_)) {}

  std::size_t count() const { return count_; }
  Columns columns() const { return columns_; }
  /// Where the same objects lie in full.
  const ObjectRows& objects() const { return objects_; }
  /// Floats in a row.
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

  /// The first `count` lanes become the rows from `first` on.
  void write(std::size_t first, const FloatLanes<D>& lanes, std::size_t count);

 private:
  Columns columns_;
  ObjectRows objects_;
  std::size_t width_, count_;
  float* values_;
};

/// Stripe numbers of a box on one axis, both ends included.
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
  /// Enters all objects of the source: each box into every stripe that it meets, or among the giants; empty
  /// ones nowhere. Writes all rows. Requires: source.count() < 2^32; rows and memory outlive the stripes.
  /// Throws Error if there are more entries than 2^32.
  Stripes(const MovingSource<D>& source, const Frame<D>& frame, const Partition<D>& partition,
          FloatRows<D>& rows, GridSpace::Side& memory, std::size_t helpers, Interrupt& interrupt);

  const FloatRows<D>& rows() const { return rows_; }
  /// Row numbers of the boxes outside the grid.
  const std::vector<std::uint32_t>& giants() const { return giants_; }
  /// The boxes in one stripe.
  std::span<const Key> entries(std::size_t stripe) const {
    return {keys_ + starts_[stripe], starts_[stripe + 1] - starts_[stripe]};
  }
  std::size_t entry_count() const { return entry_count_; }

 private:
  /// What one thread has read.
  struct Part {
    Key* keys = nullptr;
    std::uint32_t *stripes = nullptr, *counts = nullptr;
    std::size_t size = 0;
    std::vector<std::uint32_t> giants;
  };

  /// Writes the rows from `begin` to before `end` and collects what they enter, in their order.
  void read(const MovingSource<D>& source, const Frame<D>& frame, std::size_t begin, std::size_t end,
            GridSpace::Part& memory, Part& part, Interrupt& interrupt);
  /// Appends what these lanes enter to the part: one entry for each stripe of a box, or a giant.
  void enter(const FloatLanes<D>& lanes, std::size_t first, std::size_t count, GridSpace::Part& memory,
             Part& part) const;
  /// Gives each stripe its place in keys_, and each part's entries theirs in it, part after part.
  void add_up(std::span<Part> parts);
  /// Puts a part's entries where add_up() says; several threads may do so side by side.
  void place(Part& part, Interrupt& interrupt);

  Partition<D> partition_;
  FloatRows<D>& rows_;
  std::vector<std::uint32_t> giants_;
  std::uint32_t* starts_;  // of each stripe in keys_; one more at the end
  Key* keys_ = nullptr;
  std::size_t entry_count_ = 0;
};

}  // namespace foresee::gpcd
