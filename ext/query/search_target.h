// What is searched for objects: a whole scene, or a tree as it was at one moment.
//
//   SearchTarget ships{"ships", scene, nullptr};             // every object is looked at
//   SearchTarget quays{"quays", nullptr, snapshot};          // nodes are read as the question needs them
//
// Both give the same rows. Exactly one of the two is set.
#pragma once

#include <memory>
#include <string>

#include "index/pages.h"
#include "query/scene.h"

namespace foresee {

struct SearchTarget {
  std::string name;  ///< what messages call it
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<NodeSource> tree;

  const Layout& layout() const { return scene ? scene->layout : tree->layout(); }
};

}  // namespace foresee
