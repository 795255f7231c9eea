#include "index/gpcd_grid/gpcd_grid.h"

#include <algorithm>

#include "index/gpcd_grid/grid.h"
#include "index/gpcd_grid/moving_source.h"

namespace foresee {
namespace {

template <int D>
class GridWithSpace final : public Candidates {
 public:
  GridWithSpace(const gpcd::MovingSource<D>& a, const gpcd::MovingSource<D>* b,
                std::shared_ptr<GridSpace> space, Interrupt& interrupt)
      : space_(space ? std::move(space) : std::make_shared<GridSpace>()),
        grid_(a, b, *space_, 0, interrupt),
        visit_(grid_, space_->visit, interrupt) {}

  bool next(std::vector<Pair>& out) override { return visit_.next(out); }
  bool touching() const override { return visit_.touching(); }
  std::string describe() const override { return visit_.describe(); }

 private:
  std::shared_ptr<GridSpace> space_;
  gpcd::Grid<D> grid_;
  gpcd::GridVisit<D> visit_;
};

template <int D>
class DividedGrid final : public DividedCandidates {
 public:
  DividedGrid(const gpcd::MovingSource<D>& a, const gpcd::MovingSource<D>* b, std::size_t helpers,
              std::shared_ptr<GridSpace> space, Interrupt& interrupt)
      : space_(space ? std::move(space) : std::make_shared<GridSpace>()),
        grid_(a, b, *space_, helpers, interrupt) {
    // Each partition copies the giants, so it has enough work to be worth the copy.
    const std::size_t work_per_part = std::max<std::size_t>(8192, 8 * grid_.giant_count());
    std::size_t stripe = 0, work = 0;
    for (std::size_t of_stripe : grid_.work_by_stripe()) {
      if (ends_.empty() || work >= work_per_part) ends_.push_back(stripe), work = 0;
      work += of_stripe;
      ends_.back() = ++stripe;
    }
  }

  std::size_t parts() const override { return ends_.size(); }
  std::unique_ptr<Candidates> part(std::size_t i, Interrupt& interrupt) override {
    return std::make_unique<Part>(grid_, i == 0 ? 0 : ends_[i - 1], ends_[i], space_->visits, interrupt);
  }

 private:
  class Part final : public Candidates {
   public:
    Part(gpcd::Grid<D>& grid, std::size_t first, std::size_t last, GridSpace::Visits& visits,
         Interrupt& interrupt)
        : memory_(visits), visit_(grid, first, last, *memory_, interrupt) {}
    bool next(std::vector<Pair>& out) override { return visit_.next(out); }
    bool touching() const override { return visit_.touching(); }

   private:
    GridSpace::Visits::Taken memory_;
    gpcd::GridVisit<D> visit_;
  };

  std::shared_ptr<GridSpace> space_;
  gpcd::Grid<D> grid_;
  std::vector<std::size_t> ends_;  // one past the last stripe of each partition
};

}  // namespace

template <int D>
std::unique_ptr<Candidates> make_gpcd_grid(const MovingBoxes<D>& a, const MovingBoxes<D>* b,
                                           Interrupt& interrupt, std::shared_ptr<GridSpace> space) {
  const gpcd::MovingSource<D> first(a, interrupt);
  if (!b) return std::make_unique<GridWithSpace<D>>(first, nullptr, std::move(space), interrupt);
  const gpcd::MovingSource<D> second(*b, interrupt);
  return std::make_unique<GridWithSpace<D>>(first, &second, std::move(space), interrupt);
}

template <int D>
std::unique_ptr<DividedCandidates> make_divided_grid(const MovingBoxes<D>& a, const MovingBoxes<D>* b,
                                                     std::size_t helpers, Interrupt& interrupt,
                                                     std::shared_ptr<GridSpace> space) {
  const gpcd::MovingSource<D> first(a, interrupt);
  if (!b) return std::make_unique<DividedGrid<D>>(first, nullptr, helpers, std::move(space), interrupt);
  const gpcd::MovingSource<D> second(*b, interrupt);
  return std::make_unique<DividedGrid<D>>(first, &second, helpers, std::move(space), interrupt);
}

#define FORESEE_OF_AXES(D)                                                                          \
  template std::unique_ptr<Candidates> make_gpcd_grid(const MovingBoxes<D>&, const MovingBoxes<D>*, \
                                                      Interrupt&, std::shared_ptr<GridSpace>);      \
  template std::unique_ptr<DividedCandidates> make_divided_grid(                                    \
      const MovingBoxes<D>&, const MovingBoxes<D>*, std::size_t, Interrupt&, std::shared_ptr<GridSpace>)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
