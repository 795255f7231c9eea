// Search targets from seeded scenes: each as a scene, and as a tree over pages in memory.
#pragma once

#include "query/join_cases.h"
#include "query/scene.h"
#include "tests/index/tpr_tree/tree_model.h"

namespace foresee::testing {

/// Needs no snapshot: the pages do not change while a test queries them.
inline std::shared_ptr<NodeSource> tree_of(const RandomScene& scene) {
  struct Held {
    explicit Held(const RandomScene& scene) : model(scene.layout, 5, 8) { model.load(scene); }
    TreeModel model;
  };
  auto held = std::make_shared<Held>(scene);
  return {held, &held->model.pages};
}

inline SearchTarget as_scene(const RandomScene& scene) {
  return {"ships", scene_of(scene), nullptr};
}

inline SearchTarget as_tree(const RandomScene& scene) {
  return {"ships", nullptr, tree_of(scene)};
}

/// The scene with every reference time, and the scene's now, `later`.
inline RandomScene shifted(RandomScene scene, double later) {
  const auto shift = [&](std::vector<double>& numbers, const Offsets& at) {
    for (std::size_t row = 0; row < scene.size(); ++row)
      for (int place : {at.t, at.until})
        if (place != Offsets::absent)
          numbers[row * static_cast<std::size_t>(at.size) + static_cast<std::size_t>(place)] += later;
  };
  shift(scene.records, record_offsets(scene.layout));
  shift(scene.rows, row_offsets(scene.layout));
  if (scene.layout.has_t) scene.now += later;
  return scene;
}

}  // namespace foresee::testing
