// Scene of the legs that a search in a tree of chunks has found: each object once, with those of its legs that exist
// during the horizon.
//
//   auto legs = legs_near<2>(ships, moving_window<2>(lower, upper, velocity, horizon), horizon, margin, interrupt);
//   for (std::size_t i = 0; i < legs->object_count(); ++i) decide(legs->rows_of(i));
//
// Guarantee: the scene has every leg whose object comes into the box with its shape during the horizon, and perhaps
// other legs. Chunks are read before the call returns, so the scene may outlive the tree. Cost: the nodes whose
// bounds meet the box, and some 10 ns per leg of the chunks found. Memory: the result.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "index/tpr_tree/moving_box.h"
#include "query/scene.h"
#include "shape/kinds.h"

namespace foresee {

/// The horizon as times of legs, rounded outward.
LegTimes leg_times_of(const Horizon& horizon);

/// The motion of a leg, as its plan says: the object may end earlier.
template <int D>
Motion<D> motion_of(const Leg& leg) {
  return {leg.t, vector_of<D>(leg.x), vector_of<D>(leg.v), vector_of<D>(leg.a), leg.until};
}

/// Those rows of an object that exist at some time of the horizon. Requires: `rows` are in order of time.
RowRange rows_during(const Bodies& bodies, RowRange rows, const Horizon& horizon);

/// The row of an object at `time`: at a joint the later leg. Nothing where it does not exist. Requires: as above.
std::optional<std::size_t> row_at(const Bodies& bodies, RowRange rows, double time);

/// Calls use() for each object with a plan that exists during the horizon, with a scene of its legs of that time and
/// without its outline or mesh. `layout`: of the objects. Memory: a number per chunk of the horizon, and one object.
void for_each_plan(ChunkSource& chunks, const Layout& layout, const Horizon& horizon, Interrupt& interrupt,
                   const std::function<void(const Scene& legs)>& use);

/// The legs of the chunks whose boxes, grown by `margin`, meet `box`, and whose objects `test` accepts; with their
/// outlines or meshes. Requires: the target has chunks.
template <int D>
std::shared_ptr<const Scene> legs_near(const SearchTarget& objects, const MovingBox<D>& box,
                                       const Horizon& horizon, const Vec<D>& margin, Interrupt& interrupt,
                                       const std::optional<KindTest>& test = {});

/// Appends what meets one of `boxes` and what `test` and `keep` accept, to a scene without forms: objects without a
/// plan, each once, and the legs of chunks. Requires: the target has a tree; scene.legs_during contains the horizon.
template <int D>
void add_objects_near(const SearchTarget& objects, std::span<const MovingBox<D>> boxes,
                      const Horizon& horizon, const Vec<D>& margin, Interrupt& interrupt,
                      const std::optional<KindTest>& test, const std::function<bool(std::int64_t id)>& keep,
                      Scene& scene);

}  // namespace foresee
