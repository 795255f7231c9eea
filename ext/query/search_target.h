// The objects that a query searches: all objects of a scene, or a snapshot of a tree.
//
//   SearchTarget ships{"ships", scene, nullptr};             // every object is tested
//   SearchTarget quays{"quays", nullptr, snapshot};          // nodes are read as the query needs them
//
// Both give the same rows. Exactly one of the two is set.
#pragma once

#include <memory>
#include <string>

#include "index/pages.h"
#include "query/scene.h"

namespace foresee {

struct SearchTarget {
  std::string name;  ///< of the table, for messages
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<NodeSource> tree;

  const Layout& layout() const { return scene ? scene->layout : tree->layout(); }
};

}  // namespace foresee
