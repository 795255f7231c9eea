// Where the grid reads beams from: bodies in motion, or boxes at rest.
#pragma once

#include "index/gpcd_grid/float_rows.h"
#include "index/gpcd_grid/gpcd_grid.h"

namespace foresee::gpcd {

/// A horizon of no length, or bodies that only rest, need no test of time.
template <int D>
class MovingSource final : public BeamSource<D> {
 public:
  MovingSource(const MovingBoxes<D>& boxes, Interrupt& interrupt) : boxes_(boxes) {
    columns_.travel = boxes.horizon.h > 0 && boxes.bodies.layout.law != Law::rest;
    columns_.life = columns_.travel && !all_exist_throughout(boxes.bodies, boxes.horizon, interrupt);
  }
  std::size_t count() const override { return boxes_.bodies.count; }
  Columns columns() const override { return columns_; }
  void read(std::size_t first, std::span<Beam<D>> out) const override {
    beams<D>(boxes_.bodies, first, boxes_.horizon, boxes_.margin, out);
  }

 private:
  const MovingBoxes<D>& boxes_;
  Columns columns_;
};

template <int D>
class RestingSource final : public BeamSource<D> {
 public:
  explicit RestingSource(std::span<const Box<D>> boxes) : boxes_(boxes) {}
  std::size_t count() const override { return boxes_.size(); }
  Columns columns() const override { return {}; }
  void read(std::size_t first, std::span<Beam<D>> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = {boxes_[first + i], Vec<D>::Zero(), 0, 1};
  }

 private:
  std::span<const Box<D>> boxes_;
};

}  // namespace foresee::gpcd
