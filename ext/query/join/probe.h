// Candidates for one object: a join of a single id searches the tree instead of scanning all objects.
//
//   auto near = objects_near(*one, *tree, "ships", {now, h}, contact->reach(), interrupt,
//                            [](std::int64_t id) { return id != 42; });
//
// Guarantee: every object of the tree that `keep` accepts and that touches the object in `one` during the
// horizon is in the result, once; others may be too. Those that may not meet it (shape/kinds.h) are not.
// `one` is a scene of at most one row. Cost: the nodes whose bounds intersect the object's moving box.
// Memory: the result.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/error.h"
#include "contact/contact.h"
#include "index/pages.h"
#include "query/scene.h"

namespace foresee {

std::shared_ptr<const Scene> objects_near(const Scene& one, NodeSource& tree, const std::string& name,
                                          const Horizon& horizon, const Contact::Reach& reach,
                                          Interrupt& interrupt,
                                          const std::function<bool(std::int64_t)>& keep);

}  // namespace foresee
