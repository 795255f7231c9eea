// All objects of one side as rows of floats, in the order of their row numbers: GPCD step 1.
//
//   FloatRows<2> rows(count, columns, objects, memory);
//   rows.write(first, lanes, 64);                        // step by step
//   FloatBox<2> box = rows.box(7);                       // of the object in row 7
//
// A row is lower ends, upper ends, then travel and life if the columns say so. So one object is one or two
// cache lines.
#pragma once

#include "index/gpcd_grid/float_lanes.h"
#include "index/gpcd_grid/object_rows.h"
#include "index/gpcd_grid/work_space.h"

namespace foresee::gpcd {

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

}  // namespace foresee::gpcd
