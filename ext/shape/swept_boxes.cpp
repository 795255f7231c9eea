#include "shape/swept_boxes.h"

#include "base/float_environment.h"

namespace foresee {
namespace {

constexpr std::size_t objects_per_check = 4096;

}  // namespace

template <int D>
std::vector<Box<D>> swept_boxes(const Bodies& bodies, const Horizon& horizon, const Vec<D>& margin,
                                Interrupt& interrupt) {
  const FloatEnvironment environment;
  std::vector<Box<D>> boxes;
  boxes.reserve(bodies.count);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    if (i % objects_per_check == 0) interrupt.check();
    boxes.push_back(swept_box<D>(bodies, i, horizon, margin));
  }
  return boxes;
}

template std::vector<Box<1>> swept_boxes<1>(const Bodies&, const Horizon&, const Vec<1>&, Interrupt&);
template std::vector<Box<2>> swept_boxes<2>(const Bodies&, const Horizon&, const Vec<2>&, Interrupt&);
template std::vector<Box<3>> swept_boxes<3>(const Bodies&, const Horizon&, const Vec<3>&, Interrupt&);

}  // namespace foresee
