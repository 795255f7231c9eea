// Who may touch one object? A join about one id looks into the tree instead of at everything.
//
//   auto near = objects_near(*one, *tree, "ships", {now, h}, contact->reach(), interrupt,
//                            [](std::int64_t id) { return id != 42; });
//
// Guarantee: every object of the tree that `keep` accepts and that touches the object in `one` (a scene of
// one row, or of none) during the horizon is in the answer, once; others may be too. Cost: the nodes whose
// bounds meet the object's way. Memory: the answer.
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
