#include "index/gpcd_grid/gpcd_grid.h"

#include <algorithm>

#include "index/gpcd_grid/grid.h"

namespace foresee {
namespace {

template <int D>
class DividedGrid final : public DividedCandidates {
 public:
  explicit DividedGrid(std::shared_ptr<gpcd::Grid<D>> grid) : grid_(std::move(grid)) {
    // Each partition copies the giants, so it has enough work to be worth the copy.
    const std::size_t work_per_part = std::max<std::size_t>(8192, 8 * grid_->giant_count());
    std::size_t stripe = 0, work = 0;
    for (std::size_t of_stripe : grid_->work_by_stripe()) {
      if (ends_.empty() || work >= work_per_part) {
        ends_.push_back(stripe);
        work = 0;
      }
      work += of_stripe;
      ends_.back() = ++stripe;
    }
  }

  std::size_t parts() const override { return ends_.size(); }
  std::unique_ptr<Candidates> part(std::size_t i, Interrupt& interrupt) override {
    return std::make_unique<gpcd::GridVisit<D>>(grid_, i == 0 ? 0 : ends_[i - 1], ends_[i], interrupt);
  }

 private:
  std::shared_ptr<gpcd::Grid<D>> grid_;
  std::vector<std::size_t> ends_;  // one past the last stripe of each partition
};

}  // namespace

template <int D>
std::unique_ptr<Candidates> make_gpcd_grid(const MovingBoxes<D>& a, const MovingBoxes<D>* b,
                                           Interrupt& interrupt, std::shared_ptr<GridSpace> space) {
  const auto grid = std::make_shared<gpcd::Grid<D>>(a, b, std::move(space), 0, interrupt);
  return std::make_unique<gpcd::GridVisit<D>>(grid, interrupt);
}

template <int D>
std::unique_ptr<DividedCandidates> make_divided_grid(const MovingBoxes<D>& a, const MovingBoxes<D>* b,
                                                     std::size_t helpers, Interrupt& interrupt,
                                                     std::shared_ptr<GridSpace> space) {
  return std::make_unique<DividedGrid<D>>(
      std::make_shared<gpcd::Grid<D>>(a, b, std::move(space), helpers, interrupt));
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
