// Where the grid reads beams from: bodies in motion, or boxes at rest.
#pragma once

#include <vector>

#include "index/gpcd_grid/float_box.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "index/gpcd_grid/object_rows.h"
#include "shape/beam.h"
#include "shape/lives.h"

namespace foresee::index::gpcd {

template <int D>
class BeamSource {
 public:
  virtual ~BeamSource() = default;
  virtual std::size_t count() const = 0;
  /// What read() fills in beyond boxes.
  virtual Columns columns() const = 0;
  /// At most BeamLanes::width, from row `first` on. By several threads at a time.
  virtual void read(std::size_t first, std::size_t count, BeamLanes<D>& out) const = 0;
  /// Appends the beams of some rows.
  virtual void sample(std::span<const std::size_t> rows, std::vector<Beam<D>>& out) const = 0;
  /// Whether all that have a box are there when the horizon begins.
  virtual bool all_begin(Interrupt& interrupt) const = 0;
  /// What row i covers then: all that lies in it touches the row.
  virtual Box<D> core(std::size_t i) const = 0;
  virtual ObjectRows objects() const { return {}; }
};

template <int D>
class MovingSource final : public BeamSource<D> {
 public:
  /// `boxes` must outlive the source. A horizon of no length, or bodies that only rest, need no test of time;
  /// else every life is looked at once.
  MovingSource(const MovingBoxes<D>& boxes, Interrupt& interrupt) : boxes_(boxes) {
    columns_.travel = boxes.horizon.h > 0 && boxes.bodies.layout.law != Law::rest;
    columns_.life = columns_.travel && !all_exist_throughout(boxes.bodies, boxes.horizon, interrupt);
  }
  std::size_t count() const override { return boxes_.bodies.count; }
  Columns columns() const override { return columns_; }
  void read(std::size_t first, std::size_t count, BeamLanes<D>& out) const override {
    beams<D>(boxes_.bodies, first, count, boxes_.horizon, boxes_.margin, out);
  }
  void sample(std::span<const std::size_t> rows, std::vector<Beam<D>>& out) const override {
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
  bool all_begin(Interrupt& interrupt) const override {
    return all_exist_at_begin(boxes_.bodies, boxes_.horizon, interrupt);
  }
  Box<D> core(std::size_t i) const override { return core_box<D>(boxes_.bodies, i, boxes_.horizon.now); }
  ObjectRows objects() const override {
    return {reinterpret_cast<const char*>(boxes_.bodies.rows),
            static_cast<std::size_t>(boxes_.bodies.at.size) * sizeof(double)};
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
  void read(std::size_t first, std::size_t count, BeamLanes<D>& out) const override {
    for (std::size_t l = 0; l < count; ++l) put(beam(first + l), out, l);
  }
  void sample(std::span<const std::size_t> rows, std::vector<Beam<D>>& out) const override {
    for (std::size_t i : rows) out.push_back(beam(i));
  }
  bool all_begin(Interrupt&) const override { return true; }
  Box<D> core(std::size_t i) const override { return boxes_[i]; }

 private:
  Beam<D> beam(std::size_t i) const {
    return {boxes_[i].is_empty() ? Box<D>::empty() : boxes_[i], Vec<D>::Zero(), 0, 1};
  }

  std::span<const Box<D>> boxes_;
};

}  // namespace foresee::index::gpcd
