#include "query/scene.h"

#include <algorithm>

namespace foresee::query {

double newest_t(const Scene& scene) {
  const Bodies bodies = scene.bodies();
  if (bodies.count == 0 || bodies.at.t == Offsets::absent) return 0;
  double newest = bodies.row(0)[bodies.at.t];
  for (std::size_t i = 1; i < bodies.count; ++i) newest = std::max(newest, bodies.row(i)[bodies.at.t]);
  return newest;
}

}  // namespace foresee::query
