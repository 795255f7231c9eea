// Candidates for one object: a join of a single id searches the tree instead of scanning all objects.
//
//   auto near = objects_near(*one, {"ships", nullptr, tree}, {now, h}, contact->reach(), interrupt,
//                            [](std::int64_t id) { return id != 42; });
//
// Guarantee: every object of the tree that `keep` accepts and that touches the object in `one` during the
// horizon is in the result, once; others may be too. Those that may not meet it (shape/kinds.h) are not.
// `one` is a scene of at most one object. Of objects with plans the result has the legs that may touch, and others.
// Cost: the nodes whose bounds intersect the moving boxes of the object's legs. Memory: the result.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/error.h"
#include "contact/contact.h"
#include "index/pages.h"
#include "query/join/question.h"
#include "query/table_source.h"

namespace foresee {

/// `others`: with a tree.
std::shared_ptr<const Scene> objects_near(const Scene& one, const SearchTarget& others,
                                          const Horizon& horizon, const Contact::Reach& reach,
                                          Interrupt& interrupt,
                                          const std::function<bool(std::int64_t)>& keep);

/// The ids that a query requires in columns a and b.
struct QueriedIds {
  std::optional<std::int64_t> a = {}, b = {};
};

/// Sets one side to the queried object and the other to the objects that may touch it. Requires: an id.
/// Throws Error as require_valid() does.
void take_object_and_near(const JoinedTables& tables, const QueriedIds& ids, JoinQuestion& question,
                          Interrupt& interrupt);

}  // namespace foresee
