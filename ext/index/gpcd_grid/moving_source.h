// The beams of one side of the join, computed from its bodies.
#pragma once

#include <vector>

#include "index/gpcd_grid/float_box.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "index/gpcd_grid/object_rows.h"
#include "shape/beam.h"
#include "shape/swept_boxes.h"

namespace foresee::gpcd {

template <int D>
class MovingSource {
 public:
  /// `boxes` must outlive the source. Neither a horizon of length 0 nor bodies at rest need a time test;
  /// otherwise the lifetime of every object is read once.
  MovingSource(const MovingBoxes<D>& boxes, Interrupt& interrupt) : boxes_(boxes) {
    columns_.travel = boxes.horizon.h > 0 && boxes.bodies.layout.law != Law::rest;
    columns_.life = columns_.travel && !all_exist_throughout(boxes.bodies, boxes.horizon, interrupt);
  }
  std::size_t count() const { return boxes_.bodies.count; }
  /// The columns that read() fills in beside the boxes.
  Columns columns() const { return columns_; }
  /// Reads at most BeamLanes::width beams, from row `first` on. Thread-safe.
  void read(std::size_t first, std::size_t count, BeamLanes<D>& out) const {
    beams<D>(boxes_.bodies, first, count, boxes_.horizon, boxes_.margin, out);
  }
  /// Appends the beams of these rows.
  void sample(std::span<const std::size_t> rows, std::vector<Beam<D>>& out) const {
    std::vector<double> some;
    for (std::size_t i : rows)
      some.insert(some.end(), boxes_.bodies.row(i), boxes_.bodies.row(i) + boxes_.bodies.at.size);
    const Bodies bodies(boxes_.bodies.layout, some.data(), rows.size());
    BeamLanes<D> lanes;
    for (std::size_t first = 0; first < rows.size(); first += lanes.width) {
      const std::size_t count = std::min(lanes.width, rows.size() - first);
      beams<D>(bodies, first, count, boxes_.horizon, boxes_.margin, lanes);
      for (std::size_t l = 0; l < count; ++l) out.push_back(beam_at(lanes, l));
    }
  }
  /// True if all objects with a box exist at the start of the horizon.
  bool all_start(Interrupt& interrupt) const {
    return all_exist_at_start(boxes_.bodies, boxes_.horizon, interrupt);
  }
  /// The core of row i: any box inside it touches the object at the start of the horizon.
  Box<D> core(std::size_t i) const { return core_box<D>(boxes_.bodies, i, boxes_.horizon.now); }
  /// By row; null: all may meet.
  const Kinds* kinds() const { return boxes_.kinds; }
  ObjectRows objects() const {
    return {reinterpret_cast<const char*>(boxes_.bodies.rows),
            static_cast<std::size_t>(boxes_.bodies.at.size) * sizeof(double)};
  }

 private:
  const MovingBoxes<D>& boxes_;
  Columns columns_;
};

}  // namespace foresee::gpcd
