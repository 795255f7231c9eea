#include "base/interrupt_steps.h"
#include "index/tpr_tree/bulk_load/bulk_load.h"
#include "index/tpr_tree/bulk_load/leaf_order_items.h"

namespace foresee {
namespace {

template <int D, bool timed>
class Division final : public SpacePartitioning {
 public:
  using Item = OrderItem<D, timed>;

  Division(const TreeState<D>& state, std::span<const double> sample, std::size_t partitions,
           Interrupt& interrupt)
      : items_(state, sample), partitions_(partitions), cuts_(partitions) {
    const std::size_t size = state.reader.record_size();
    std::vector<Item> drawn(sample.size() / size);
    Steps step(interrupt);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      step();
      drawn[i] = items_.of(sample.data() + i * size, static_cast<std::uint32_t>(i));
    }
    cut(0, partitions, drawn, step);
  }

  std::size_t partition_of(const double* record) override {
    const Item item = items_.of(record, 0);
    std::size_t first = 0, last = partitions_;
    while (last - first > 1) {
      const std::size_t middle = first + (last - first) / 2;
      Cut& cut = cuts_[middle];
      const float place = item.place[cut.along];
      const bool is_before = place != cut.at ? place < cut.at : ++cut.on_it % 2 == 0;
      (is_before ? last : first) = middle;
    }
    return first;
  }

 private:
  /// The cut between partitions [first, middle) and [middle, last).
  struct Cut {
    std::size_t along = 0;
    float at = 0;
    std::size_t on_it = 0;  ///< the number of objects exactly on the cut so far
  };

  void cut(std::size_t first, std::size_t last, std::span<Item> drawn, Steps& step) {
    if (last - first < 2 || drawn.empty()) return;
    const std::size_t middle = first + (last - first) / 2;
    const std::size_t nth = drawn.size() * (middle - first) / (last - first);
    Cut& between = cuts_[middle];
    between.along = items_.widest_axis(drawn);
    std::nth_element(drawn.begin(), drawn.begin() + static_cast<std::ptrdiff_t>(nth), drawn.end(),
                     [&](const Item& a, const Item& b) {
                       step();
                       return a.place[between.along] < b.place[between.along];
                     });
    between.at = drawn[nth].place[between.along];
    cut(first, middle, drawn.first(nth), step);
    cut(middle, last, drawn.subspan(nth), step);
  }

  OrderItems<D, timed> items_;
  std::size_t partitions_;
  std::vector<Cut> cuts_;  ///< by the first partition behind the cut
};

}  // namespace

template <int D>
std::unique_ptr<SpacePartitioning> divide_space(TreeState<D>& state, std::span<const double> sample,
                                                std::size_t partitions, Interrupt& interrupt) {
  start_clock(state, sample);
  if (state.reader.ends()) return std::make_unique<Division<D, true>>(state, sample, partitions, interrupt);
  return std::make_unique<Division<D, false>>(state, sample, partitions, interrupt);
}

template std::unique_ptr<SpacePartitioning> divide_space<1>(TreeState<1>&, std::span<const double>,
                                                            std::size_t, Interrupt&);
template std::unique_ptr<SpacePartitioning> divide_space<2>(TreeState<2>&, std::span<const double>,
                                                            std::size_t, Interrupt&);
template std::unique_ptr<SpacePartitioning> divide_space<3>(TreeState<3>&, std::span<const double>,
                                                            std::size_t, Interrupt&);

}  // namespace foresee
