// Reference implementation of the paper's uniform grid, GPCD steps 1 to 4, for comparison with the production
// grid (Yu and Wong, "GPCD: Grid-based Predictive Collision Detection for Large-scale Environments in
// Computer Games").
//
//   PaperGrid<2> grid(boxes, interrupt);                  // swept boxes: the projected intervals of step 1
//   grid.figures().cell[0];                               // step 2: their plain mean on the x axis, c = 1
//   while (grid.next(pairs)) { …; pairs.clear(); }        // step 4: pairs that share a cell
//
// Step 3 enters every box into each cell that it meets. A pair shares a rectangle of cells and is reported in
// the one with the smallest numbers (the reference point). So it is reported once without a lookup.
//
// Guarantee: reports exactly the pairs whose boxes meet a common cell, which includes all pairs whose boxes
// meet. Cost: as in the paper. One huge object coarsens all cells and enters many of them; objects in one
// cell are compared pair by pair. gpcd_grid/ is the production grid.
//
// The paper does not say how to bound memory. This implementation doubles the cells until there are at most
// 64 entries per object. An axis has at most 2^21 cells; if a double cannot hold the mean, one cell spans the
// axis.
#pragma once

#include <array>
#include <cstdint>

#include "index/candidates.h"

namespace foresee {

template <int D>
class PaperGrid final : public Candidates {
 public:
  /// Pairs among `boxes`, or between two sides. `interrupt` must outlive the grid; the boxes need not.
  PaperGrid(std::span<const Box<D>> boxes, Interrupt& interrupt);
  PaperGrid(std::span<const Box<D>> boxes_a, std::span<const Box<D>> boxes_b, Interrupt& interrupt);

  bool next(std::vector<Pair>& out) override;
  std::string describe() const override;

  struct Figures {
    Vec<D> cell;              ///< sizes; infinite where one cell spans the axis
    double doubled = 1;       ///< factor between these cells and the paper's; 1: as in the paper
    std::size_t entries = 0;  ///< in all cells
    std::size_t cells = 0;    ///< that are not empty
  };
  const Figures& figures() const { return figures_; }

 private:
  using Place = std::array<std::uint32_t, D>;  ///< position of a cell, from 0 on each axis
  struct Entry {
    std::uint64_t cell;
    std::uint32_t object, side;
  };
  struct Cuts {
    Vec<D> from, per_unit;
    Place place(const Vec<D>& x) const;
  };
  using Sides = std::array<std::span<const Box<D>>, 2>;

  void build(const Sides& sides);
  Cuts choose_cells(const Sides& sides);
  double entry_count(const Sides& sides, const Cuts& cuts);
  void enter(const Sides& sides, const Cuts& cuts);
  void group_entries();
  bool open_cell();
  static std::uint64_t number_of(const Place& place);
  bool is_reference(const Entry& a, const Entry& b) const;

  Interrupt& interrupt_;
  bool between_;
  Figures figures_;
  std::vector<Place> first_[2];  ///< the first cell that an object meets, on every axis
  std::vector<Entry> entries_;   ///< sorted by cell, then by side
  std::size_t end_ = 0;          ///< of the current cell
  std::size_t from_ = 0;         ///< where side b starts in it, in a join between two sides
  std::size_t a_ = 0, a_end_ = 0, b_ = 0;
};

/// The grid of the swept boxes of `a`, or of `a` and `b` if `between`.
template <int D>
std::unique_ptr<PaperGrid<D>> make_paper_grid(const Bodies& a, const Bodies& b, bool between,
                                              const Horizon& horizon, const Vec<D>& margin,
                                              Interrupt& interrupt);

}  // namespace foresee
