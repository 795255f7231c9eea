// 'rebuild' and 'optimize': all leaves anew, full, neighbours in space together.
#include <algorithm>

#include "storage/spatial_order.h"
#include "storage/store.h"
#include "storage/store_own_statements.h"

namespace foresee {

void Store::rebuild(Interrupt& interrupt) {
  pack(interrupt);
  const OwnStatements own(*this);
  if (has_auxiliaries()) rows().match_auxiliaries_to_map();
}

void Store::optimize(Interrupt& interrupt) {
  const std::vector<std::string> faults = check(interrupt);
  if (!faults.empty()) throw StoreError(SQLITE_CORRUPT_VTAB, faults.front());
  pack(interrupt);
}

void Store::pack(Interrupt& interrupt) {
  start_change({});
  flush();
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  const auto size = static_cast<std::size_t>(format_.at.size);
  read_leaves(interrupt, [&](const LeafView& leaf) {
    const std::size_t before = ids.size();
    ids.resize(before + static_cast<std::size_t>(leaf.count()));
    records.resize(ids.size() * size);
    leaf.copy_ids(ids.data() + before);
    leaf.copy_records(records.data() + before * size);
  });
  std::vector<std::int64_t> sorted = ids;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    damaged("object " + std::to_string(*twice) + " is in two leaves");
  const std::vector<std::uint32_t> order = spatial_order(format_.layout, records.data(), ids.size());
  interrupt.check();
  half_packed_ = true;
  write_packed(ids, records, order);
  half_packed_ = false;
  changed_ = true;
}

// Between the first erase and the last write the tables are not whole: see half_packed_.
void Store::write_packed(const std::vector<std::int64_t>& ids, const std::vector<double>& records,
                         const std::vector<std::uint32_t>& order) {
  const OwnStatements own(*this);
  std::vector<IdChange> map;
  map.reserve(ids.size());
  rows_->erase_all_nodes();
  rows_->erase_map();
  std::int64_t number = 0;
  for (std::size_t begin = 0; begin < order.size(); begin += format_.leaf_capacity) {
    LeafNode leaf(format_);
    ++number;
    for (std::size_t i = begin; i < std::min(begin + format_.leaf_capacity, order.size()); ++i) {
      leaf.put(ids[order[i]], records.data() + order[i] * static_cast<std::size_t>(format_.at.size));
      map.push_back({ids[order[i]], number});
    }
    rows_->write_node(number, leaf.sealed(number));
  }
  std::sort(map.begin(), map.end(), [](const IdChange& a, const IdChange& b) { return a.id < b.id; });
  rows_->write_map(map);
}

}  // namespace foresee
