#include <CGAL/box_intersection_d.h>

#include "core_emitter.h"

namespace foresee::bench {

Answer by_cgal(const Workload& w) {
  return typed(w, [&](auto axes, auto degree) {
    constexpr int D = axes;
    using CgalBox = CGAL::Box_intersection_d::Box_with_info_d<double, D, std::uint32_t>;
    PlainEmitter<axes, degree> emitter(w);
    const std::vector<Box<D>> swept = boxes_swept_by<D>(w);
    std::vector<CgalBox> boxes;
    boxes.reserve(swept.size());
    for (std::uint32_t i = 0; i < swept.size(); ++i) {
      Box<D> box = swept[i];  // its constructor asks for pointers to what it could change
      boxes.emplace_back(box.lower.data(), box.upper.data(), i);
    }
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const CgalBox& a, const CgalBox& b) {
      emitter.take(a.info(), b.info());
    });
    return emitter.finish();
  });
}

}  // namespace foresee::bench
