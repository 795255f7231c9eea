// The stages of the GPCD grid, from swept boxes to candidates, with counters for tests and benchmarks.
//
//   step 1  beams: moving_source.h, stripes.h
//   step 2  cell size: cell_size.h
//   step 3  enter: stripes.h, giants.h
//   step 4, 5a, 5c  share a stripe and overlap, in space and in time: lanes.h, scan.h
//
// Other modules use gpcd_grid.h. A Grid holds the entered objects. A GridVisit visits a range of its stripes,
// one after another. In each stripe it gathers the boxes into lanes and then scans them: with one another, or
// with those of the other side. Then it scans the giants that cross the stripe with its boxes. Boxes that a
// giant covers come first, then the others. Pairs of giants come before the first stripe. Several threads
// may visit stripes of one grid at the same time.
#pragma once

#include <memory>
#include <vector>

#include "index/candidates.h"
#include "index/gpcd_grid/giants.h"
#include "index/gpcd_grid/lanes.h"
#include "index/gpcd_grid/scan.h"
#include "index/gpcd_grid/stripes.h"

namespace foresee::gpcd {

template <int D>
class Grid {
 public:
  /// The objects of one side of the join.
  struct Side {
    /// Enters every object of `source` into the stripes that its box meets, or among the giants.
    Side(const MovingSource<D>& source, const FloatFrame<D>& frame, Columns columns,
         const Partition<D>& partition, GridSpace::Side& memory, std::size_t helpers, Interrupt& interrupt)
        : rows(source.count(), columns, source.objects(), source.kinds(), memory.rows),
          stripes(source, frame, partition, rows, memory, helpers, interrupt),
          giants(partition, stripes, interrupt) {}
    FloatRows<D> rows;
    Stripes<D> stripes;
    Giants<D> giants;
  };

  /// Enters the objects of `a`, or of both if `b` is not null. The bodies are not needed afterwards; their numbers are
  /// kept in `space`, or in memory of the grid's own if that is null. `helpers` is the number of threads beside this
  /// one; the grid is the same for any number of them.
  Grid(const MovingBoxes<D>& a, const MovingBoxes<D>* b, std::shared_ptr<GridSpace> space,
       std::size_t helpers, Interrupt& interrupt);

  /// 1 or 2.
  std::size_t side_count() const { return sides_.size(); }
  Side& side(std::size_t i) { return *sides_[i]; }
  GridSpace& space() { return *space_; }
  const Partition<D>& partition() const { return partition_; }
  /// Entries in all stripes: at least one for each box inside the grid.
  std::size_t entry_count() const;
  std::size_t giant_count() const;
  /// Estimated cost of visiting each stripe, in boxes: its own, and giants that are compared with them.
  std::vector<std::size_t> work_by_stripe() const;
  std::string describe() const;

 private:
  std::shared_ptr<GridSpace> space_;
  Partition<D> partition_;
  double stripe_height_[D] = {};  // in the table's units
  std::vector<std::unique_ptr<Side>> sides_;
};

template <int D>
class GridVisit final : public Candidates {
 public:
  /// Visits the stripes [first, last). A visit that includes stripe 0 also compares giants with giants.
  /// `interrupt` must outlive the visit.
  GridVisit(std::shared_ptr<Grid<D>> grid, std::size_t first, std::size_t last, Interrupt& interrupt);
  /// Visits all stripes.
  GridVisit(const std::shared_ptr<Grid<D>>& grid, Interrupt& interrupt)
      : GridVisit(grid, 0, grid->partition().stripes(), interrupt) {}

  /// A batch of at most about 500 pairs, or the pairs found in about a millisecond; in the order of the
  /// stripes.
  bool next(std::vector<Pair>& out) override;
  bool touching() const override { return touching_; }
  std::string describe() const override { return grid_->describe(); }
  /// The number of steps of the scan kernel so far.
  std::size_t steps_taken() const { return steps_taken_; }

 private:
  /// The boxes of one side in the open stripe: those entered, and the giants that cross it.
  struct Gathered {
    Gathered(const Giants<D>& giants, GridSpace::Visit::LaneMemory& inside,
             GridSpace::Visit::LaneMemory& crossing)
        : giants(giants), inside(inside), crossing(crossing) {}
    Giants<D> giants;
    Lanes<D> inside, crossing;
  };

  /// The other side of the join; in a self-join the one side itself.
  std::size_t other_side(std::size_t i) const { return sides_.size() - 1 - i; }
  /// Adds the scan of giants with one another, or of the giants of both sides.
  void open_giants();
  /// Adds the scans of a stripe: together they report each pair that belongs to the stripe (lanes.h) once.
  void open_stripe(std::size_t number);
  /// Adds the scan of giants with the boxes of a stripe. If they cover many boxes, adds two scans: of the
  /// covered boxes, then of the others.
  void scan_giants(const LaneView<D>& crossing, const LaneView<D>& inside, bool swap);

  std::shared_ptr<Grid<D>> grid_;
  GridSpace::Visits::Taken memory_;
  Interrupt& interrupt_;
  std::vector<Gathered> sides_;
  const ScanKernel<D> run_ = scan_kernel<D>();
  std::vector<Scan<D>> scans_;  // of the open stripe, or of giants with giants
  std::size_t scan_ = 0;
  bool touching_ = false;  // of the last batch
  bool giants_met_;
  std::size_t next_stripe_, last_stripe_;
  Pair* batch_;
  std::size_t steps_taken_ = 0;
};

}  // namespace foresee::gpcd
