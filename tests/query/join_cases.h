// Scenes and joins for the tests of query/join/join.h.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "query/join/join.h"
#include "scenes.h"

namespace foresee::testing {

/// The layout of most scenes made by hand.
inline constexpr Layout discs{.axes = 2, .law = Law::uniform, .shape = Shape::ball};

/// Times with dt > 0: pairs that touch at `now` are left out.
inline constexpr QueriedTimes after_now{std::numeric_limits<double>::denorm_min()};

inline std::shared_ptr<const Scene> scene_of(const RandomScene& random, const std::string& name = "ships") {
  auto scene = std::make_shared<Scene>();
  *scene = {name, random.layout, random.ids, random.rows};
  return scene;
}

inline std::shared_ptr<const Scene> scene_of(const Layout& layout, std::vector<std::int64_t> ids,
                                             std::vector<double> rows, const std::string& name = "ships") {
  auto scene = std::make_shared<Scene>();
  *scene = {name, layout, std::move(ids), std::move(rows)};
  return scene;
}

/// The query for which the scene was made.
inline JoinQuestion question_about(const RandomScene& scene) {
  return {.a = scene_of(scene), .now = scene.now, .h = scene.h, .within = scene.within};
}

/// All rows, as they come.
inline std::vector<JoinRow> rows_in_order(const JoinQuestion& question) {
  NeverInterrupt never;
  Join join(question, never);
  std::vector<JoinRow> all;
  for (auto rows = join.next(); !rows.empty(); rows = join.next())
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

/// All rows, by a and b.
inline std::vector<JoinRow> rows_of(const JoinQuestion& question) {
  std::vector<JoinRow> all = rows_in_order(question);
  std::sort(all.begin(), all.end(),
            [](const JoinRow& l, const JoinRow& r) { return std::pair(l.a, l.b) < std::pair(r.a, r.b); });
  return all;
}

using IdPairs = std::vector<std::pair<std::int64_t, std::int64_t>>;

inline IdPairs pairs_of(const JoinQuestion& question) {
  IdPairs pairs;
  for (const JoinRow& row : rows_of(question)) pairs.emplace_back(row.a, row.b);
  return pairs;
}

/// Every number of every row, so that equal means bit for bit (but 0 = -0).
inline std::vector<double> numbers_of(const std::vector<JoinRow>& rows) {
  std::vector<double> numbers;
  for (const JoinRow& row : rows)
    numbers.insert(numbers.end(),
                   {static_cast<double>(row.a), static_cast<double>(row.b), row.contact.t, row.contact.t_end,
                    row.contact.dt, row.contact.dt_end, row.approach.t, row.approach.dt, row.approach.d});
  return numbers;
}

}  // namespace foresee::testing
