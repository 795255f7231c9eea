// The grid as a whole: GPCD steps 1 to 5a from swept boxes to candidates. gpcd_grid.h is the door; this
// header shows the parts and counters to tests and benchmarks.
//
//   step 1  swept boxes (motion)            step 3  enter: stripes.h, giants.h
//   step 2  cell size: cell_size.h          step 4, 5a  share a stripe and overlap: lanes.h, scan.h
//
// Stripes are visited one after another. At each, what lies in it is gathered into lanes, and up to three
// scans follow: its boxes among themselves (or of the two sides), and the giants that cross it against its
// boxes. Giants meet one another before the first stripe.
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
class Grid final : public Candidates {
 public:
  /// Pairs among the objects of `a`, or between them and those of `b` if that is not null. What is read from
  /// them is kept in `space`, which must outlive the grid; so must `interrupt`.
  Grid(const BeamSource<D>& a, const BeamSource<D>* b, GridSpace& space, Interrupt& interrupt);

  bool next(std::vector<Pair>& out) override;

  /// Entries in all stripes: at least one per box inside the grid.
  std::size_t entry_count() const;
  std::size_t giant_count() const;
  std::string describe() const override;
  /// Steps of the scan kernel so far.
  std::size_t steps_taken() const { return steps_taken_; }

 private:
  /// The objects of one side of the join and what is gathered of them.
  struct Side {
    Side(const BeamSource<D>& source, const Frame<D>& frame, Columns columns, const Partition<D>& partition,
         GridSpace::Side& memory, Interrupt& interrupt)
        : rows(source, frame, columns, memory.rows, interrupt),
          stripes(partition, rows, memory, interrupt),
          giants(partition, stripes, interrupt),
          inside(memory.inside),
          crossing(memory.crossing) {}
    FloatRows<D> rows;
    Stripes<D> stripes;
    Giants<D> giants;
    Lanes<D> inside, crossing;
  };

  Side& side(std::size_t i) { return *sides_[i]; }
  /// Puts the scans of the next stripe into scans_; false behind the last one.
  bool open_next();
  void open_giants();
  void open_stripe(std::size_t number);

  Interrupt& interrupt_;
  Partition<D> partition_;
  std::vector<std::unique_ptr<Side>> sides_;  // one side, or two
  std::vector<Scan<D>> scans_;
  std::size_t scan_ = 0;
  bool giants_met_ = false;
  std::size_t next_stripe_ = 0;
  Pair* batch_;
  std::size_t steps_taken_ = 0;
};

}  // namespace foresee::gpcd
