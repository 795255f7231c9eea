// All objects of one side as rows of floats, in the order of their row numbers: GPCD step 1.
//
//   FloatRows<2> rows(source, frame, columns, memory, interrupt);
//   FloatBox<2> box = rows.box(7);                       // of the object in row 7
//
// A row is lower ends, upper ends, then travel and life if the columns say so; life is begin and end within
// [-1, 1], the middle of the horizon being 0. So one object is one or two cache lines.
#pragma once

#include "index/gpcd_grid/float_box.h"
#include "index/gpcd_grid/work_space.h"
#include "motion/error.h"

namespace foresee::gpcd {

/// Where the grid reads its objects from.
template <int D>
class BeamSource {
 public:
  virtual ~BeamSource() = default;
  virtual std::size_t count() const = 0;
  /// What read() fills in beyond boxes.
  virtual Columns columns() const = 0;
  /// By several threads at a time.
  virtual void read(std::size_t first, std::span<Beam<D>> out) const = 0;
};

template <int D>
class FloatRows {
 public:
  FloatRows(const BeamSource<D>& source, const Frame<D>& frame, Columns columns, Buffer<float>& memory,
            std::size_t helpers, Interrupt& interrupt);

  std::size_t count() const { return count_; }
  Columns columns() const { return columns_; }
  /// Floats in a row.
  static constexpr int width(Columns columns) {
    return 2 * D + (columns.travel ? D : 0) + (columns.life ? 2 : 0);
  }
  const float* row(std::size_t i) const { return values_ + i * static_cast<std::size_t>(width_); }
  FloatBox<D> box(std::size_t i) const {
    FloatBox<D> box;
    std::copy_n(row(i), D, box.lower);
    std::copy_n(row(i) + D, D, box.upper);
    return box;
  }

 private:
  void fill(const BeamSource<D>& source, const Frame<D>& frame, std::size_t begin, std::size_t end,
            float* out, Interrupt& interrupt) const;

  Columns columns_;
  int width_;
  std::size_t count_;
  const float* values_;
};

}  // namespace foresee::gpcd
