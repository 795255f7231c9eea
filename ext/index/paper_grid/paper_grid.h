// The paper's grid to the letter, for comparison: GPCD steps 1 to 4 (Yu and Wong, "GPCD: Grid-based
// Predictive Collision Detection for Large-scale Environments in Computer Games").
//
//   PaperGrid<2> grid(boxes, interrupt);                  // swept boxes: the projected intervals of step 1
//   grid.figures().cell[0];                               // step 2: their plain mean on the x axis, c = 1
//   while (grid.next(pairs)) { …; pairs.clear(); }        // step 4: who shares a cell
//
// Step 3 enters every box into each cell that it meets. A pair shares a rectangle of cells; it is reported in
// the one with the least numbers (the reference point), so it comes once without a second look-up.
//
// Guarantee: exactly the pairs whose boxes meet a common cell, which includes all pairs whose boxes meet.
// Cost: as in the paper; one huge object coarsens the cells of all and enters many of them, and a crowd in
// one cell is looked at pair by pair. gpcd_grid/ is the grid for every day. What the paper does not say is
// how a scene is kept from exhausting memory: cells are doubled until there are no more than 64 entries an
// object, there are at most 2^21 cells along an axis, and where no double holds the mean one cell spans the
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
    double doubled = 1;       ///< how many times larger than the paper's; 1: to the letter
    std::size_t entries = 0;  ///< over all cells
    std::size_t cells = 0;    ///< that hold any
  };
  const Figures& figures() const { return figures_; }

 private:
  using Place = std::array<std::uint32_t, D>;  ///< of a cell, from 0 on each axis
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
  std::vector<Place> first_[2];  ///< the least cell that an object meets
  std::vector<Entry> entries_;   ///< cell after cell, within one by side
  std::size_t end_ = 0;          ///< of the current cell
  std::size_t from_ = 0;         ///< of side b in it, in a join between two
  std::size_t a_ = 0, a_end_ = 0, b_ = 0;
};

/// The grid of all bodies' swept boxes, within `a` or with `between` of `a` and `b`.
template <int D>
std::unique_ptr<PaperGrid<D>> make_paper_grid(const Bodies& a, const Bodies& b, bool between,
                                              const Horizon& horizon, const Vec<D>& margin,
                                              Interrupt& interrupt);

}  // namespace foresee
