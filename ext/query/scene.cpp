#include "query/scene.h"

#include <algorithm>

#include "shape/chunk_item.h"

namespace foresee {

void Scene::add(std::int64_t id, const double* record, std::span<const Leg> legs) {
  const Offsets stored = record_offsets(layout), at = row_offsets(layout);
  const auto row_size = static_cast<std::size_t>(at.size);
  if (first_rows.empty()) first_rows.push_back(0);
  std::vector<double> row(row_size);
  row_from_record(layout, record, row.data());
  const auto add_row = [&] {
    if (!legs_during.meet(row[static_cast<std::size_t>(at.t)], row[static_cast<std::size_t>(at.until)]))
      return;
    ids.push_back(id);
    rows.insert(rows.end(), row.begin(), row.end());
  };
  if (legs.empty()) add_row();
  const double end = record[stored.until];
  for (const Leg& leg : legs) {
    if (end < leg.t) break;
    write_leg(at, layout.axes, leg, row.data());
    row[static_cast<std::size_t>(at.until)] = std::min(leg.until, end);
    add_row();
  }
  if (ids.size() > first_rows.back()) first_rows.push_back(static_cast<std::uint32_t>(ids.size()));
}

void Scene::find_movers() {
  first_rows.clear();
  if (!layout.has_plan) return;
  for (std::uint32_t row = 0; row < ids.size(); ++row)
    if (row == 0 || ids[row] != ids[row - 1]) first_rows.push_back(row);
  first_rows.push_back(static_cast<std::uint32_t>(ids.size()));
}

}  // namespace foresee
