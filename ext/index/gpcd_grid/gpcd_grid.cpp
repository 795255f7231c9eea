#include "index/gpcd_grid/gpcd_grid.h"

#include "index/gpcd_grid/beam_sources.h"
#include "index/gpcd_grid/grid.h"

namespace foresee {
namespace {

template <int D>
class GridWithSpace final : public Candidates {
 public:
  GridWithSpace(const gpcd::BeamSource<D>& a, const gpcd::BeamSource<D>* b, std::shared_ptr<GridSpace> space,
                Interrupt& interrupt)
      : space_(space ? std::move(space) : std::make_shared<GridSpace>()), grid_(a, b, *space_, interrupt) {}

  bool next(std::vector<Pair>& out) override { return grid_.next(out); }
  std::string describe() const override { return grid_.describe(); }

 private:
  std::shared_ptr<GridSpace> space_;
  gpcd::Grid<D> grid_;
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
std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<D>> boxes, Interrupt& interrupt) {
  return std::make_unique<GridWithSpace<D>>(gpcd::RestingSource<D>(boxes), nullptr, nullptr, interrupt);
}

template <int D>
std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<D>> boxes_a, std::span<const Box<D>> boxes_b,
                                           Interrupt& interrupt) {
  const gpcd::RestingSource<D> b(boxes_b);
  return std::make_unique<GridWithSpace<D>>(gpcd::RestingSource<D>(boxes_a), &b, nullptr, interrupt);
}

#define FORESEE_GRID_OF_AXES(D)                                                                         \
  template std::unique_ptr<Candidates> make_gpcd_grid(const MovingBoxes<D>&, const MovingBoxes<D>*,     \
                                                      Interrupt&, std::shared_ptr<GridSpace>);          \
  template std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<D>>, Interrupt&);             \
  template std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<D>>, std::span<const Box<D>>, \
                                                      Interrupt&)
FORESEE_GRID_OF_AXES(1);
FORESEE_GRID_OF_AXES(2);
FORESEE_GRID_OF_AXES(3);
#undef FORESEE_GRID_OF_AXES

}  // namespace foresee
