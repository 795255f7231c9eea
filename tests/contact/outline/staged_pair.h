// The input of the stages for a scene of outlines: rows, times, pieces, and the memory for the tests of a
// pair.
#pragma once

#include <optional>

#include "contact/certified/union_pair.h"
#include "contact/outline/flat_traits.h"
#include "contact/outline/outline_scenes.h"

namespace foresee::testing_by_hand {

struct StagedScene {
  explicit StagedScene(const OutlineScene& scene)
      : row_a(scene.a.row.row()),
        row_b(scene.b.row.row()),
        setup{{scene.a.row.layout, row_a.data(), 1},
              {scene.b.row.layout, row_b.data(), 1},
              scene.question.horizon,
              PairRule(scene.a.row.layout, scene.b.row.layout)},
        lifetime(pair_lifetime_of(setup, row_a.data(), row_b.data())),
        cut_a(convex_pieces(scene.a.outline)),
        cut_b(convex_pieces(scene.b.outline)) {
    a.take(cut_a);
    b.take(cut_b);
  }
  StagedScene(const StagedScene&) = delete;

  UnionPair<FlatTraits<2, 1>> pair(bool times_wanted) {
    context.emplace(PairInput<ObjectPieces>{setup, row_a.data(), row_b.data(), a, b, lifetime, any_time,
                                            times_wanted, steps});
    return {*context, space};
  }

  const std::vector<double> row_a, row_b;
  const Setup setup;
  const PairLifetime lifetime;
  const ConvexPieces cut_a, cut_b;
  ObjectPieces a, b;
  FlatSpace<1> space;
  NeverInterrupt never;
  Steps steps{never};
  std::optional<PairContext<FlatTraits<2, 1>>> context;  ///< of the last pair
};

}  // namespace foresee::testing_by_hand
