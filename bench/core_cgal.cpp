#include <CGAL/box_intersection_d.h>

#include "core_emitter.h"

namespace foresee::bench {
namespace {

template <int D>
using CgalBox = CGAL::Box_intersection_d::Box_with_info_d<double, D, std::uint32_t>;

template <int D>
std::vector<CgalBox<D>> cgal_boxes(const Workload& w) {
  const std::vector<Box<D>> swept = boxes_swept_by<D>(w);
  std::vector<CgalBox<D>> boxes;
  boxes.reserve(swept.size());
  for (std::uint32_t i = 0; i < swept.size(); ++i) {
    Box<D> box = swept[i];  // its constructor takes pointers to mutable coordinates
    boxes.emplace_back(box.lower.data(), box.upper.data(), i);
  }
  return boxes;
}

}  // namespace

Answer by_cgal(const Workload& w) {
  return typed(w, [&](auto axes) {
    constexpr int D = axes;
    PlainEmitter emitter(w);
    const auto take = [&](const CgalBox<D>& a, const CgalBox<D>& b) { emitter.take(a.info(), b.info()); };
    std::vector<CgalBox<D>> boxes = cgal_boxes<D>(w);
    if (w.other) {
      std::vector<CgalBox<D>> others = cgal_boxes<D>(*w.other);
      CGAL::box_intersection_d(boxes.begin(), boxes.end(), others.begin(), others.end(), take);
    } else {
      CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), take);
    }
    return emitter.finish();
  });
}

}  // namespace foresee::bench
