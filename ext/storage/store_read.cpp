// Reading: what is pending first, then the tables.
#include <cstring>
#include <limits>

#include "storage/check.h"
#include "storage/store.h"

namespace foresee {

void Store::require_sound(std::int64_t number, std::span<const std::byte> blob) const {
  const char* fault = number < 1 ? "nodes are numbered from 1" : leaf_fault(format_, blob, number);
  if (fault) damaged("node " + std::to_string(number) + " is damaged: " + fault);
}

std::optional<std::int64_t> Store::leaf_of(std::int64_t id) {
  const std::int64_t leaf = pending_.ids.find(id);
  if (leaf == IdChanges::unknown) return rows().leaf_of(id);
  return leaf == IdChanges::erased ? std::nullopt : std::optional(leaf);
}

bool Store::contains(std::int64_t id) {
  const std::int64_t leaf = pending_.ids.find(id);
  if (leaf != IdChanges::unknown) return leaf != IdChanges::erased;
  // Ascending new ids, the common case, are larger than any known one.
  const bool may_ask = in_transaction_ && (largest_known_ || pending_.ids.size() == 0);
  if (may_ask) {
    const std::optional<std::int64_t>& largest = largest_known_ ? largest_ : largest_id();
    if (!largest || *largest < id) return false;
  }
  return rows().leaf_of(id).has_value();
}

std::optional<std::vector<double>> Store::read(std::int64_t id) {
  const std::optional<std::int64_t> number = leaf_of(id);
  if (!number) return std::nullopt;
  std::vector<double> record(static_cast<std::size_t>(format_.at.size));
  const auto copy_from = [&](const LeafView& leaf) {
    const int i = leaf.find(id);
    if (i < 0) damaged("node " + std::to_string(*number) + " lacks object " + std::to_string(id));
    leaf.copy_record(i, record.data());
  };
  if (const PendingLeaf* leaf = pending_.find(*number)) {
    copy_from(leaf->leaf);
    return record;
  }
  const bool found = rows().read_node(*number, [&](std::span<const std::byte> blob) {
    require_sound(*number, blob);
    copy_from(LeafView(format_, blob));
  });
  if (!found) damaged("node " + std::to_string(*number) + " of object " + std::to_string(id) + " is missing");
  return record;
}

// Every leaf by ascending number, the pending ones in place of the stored.
void Store::read_leaves(Interrupt& interrupt, const std::function<void(const LeafView&)>& use) {
  const PendingLeaf* next = pending_.next_after(0);
  const auto use_pending_up_to = [&](std::int64_t number) {
    for (; next && next->number <= number; next = pending_.next_after(next->number)) use(next->leaf);
  };
  unsigned leaves = 0;
  rows().read_all_nodes([&](std::int64_t number, std::span<const std::byte> blob) {
    if (++leaves % 16 == 0) interrupt.check();
    use_pending_up_to(number);
    if (pending_.find(number)) return;
    require_sound(number, blob);
    use(LeafView(format_, blob));
  });
  use_pending_up_to(std::numeric_limits<std::int64_t>::max());
}

void Store::load(std::vector<std::int64_t>& ids, std::vector<double>& rows, Interrupt& interrupt) {
  const auto expected = static_cast<std::size_t>(count());
  const auto row_size = static_cast<std::size_t>(row_offsets(format_.layout).size);
  const bool rows_are_records = format_.layout.law != Law::forced;
  std::vector<double> record(static_cast<std::size_t>(format_.at.size));
  ids.clear();
  rows.clear();
  ids.reserve(expected);
  rows.reserve(expected * row_size);
  read_leaves(interrupt, [&](const LeafView& leaf) {
    const std::size_t before = ids.size(), more = static_cast<std::size_t>(leaf.count());
    ids.resize(before + more);
    rows.resize((before + more) * row_size);
    leaf.copy_ids(ids.data() + before);
    double* row = rows.data() + before * row_size;
    if (rows_are_records) return leaf.copy_records(row);
    for (int i = 0; i < leaf.count(); ++i, row += row_size) {
      leaf.copy_record(i, record.data());
      row_from_record(format_.layout, record.data(), row);
    }
  });
  if (ids.size() != expected)
    damaged("the leaves hold " + std::to_string(ids.size()) + " objects, the map " +
            std::to_string(expected));
}

std::int64_t Store::next_leaf(std::int64_t after, std::vector<std::int64_t>& ids,
                              std::vector<double>& records) {
  ids.clear();
  records.clear();
  std::int64_t result = 0;
  const auto take = [&](std::int64_t number, const LeafView& leaf) {
    ids.resize(static_cast<std::size_t>(leaf.count()));
    records.resize(ids.size() * static_cast<std::size_t>(format_.at.size));
    leaf.copy_ids(ids.data());
    leaf.copy_records(records.data());
    result = number;
  };
  const PendingLeaf* pending = pending_.next_after(after);
  bool more = true;
  while (result == 0 && more) {
    more = rows().read_node_after(after, [&](std::int64_t number, std::span<const std::byte> blob) {
      after = number;
      if (pending && pending->number <= number) return take(pending->number, pending->leaf);
      if (pending_.find(number)) return;  // emptied
      require_sound(number, blob);
      take(number, LeafView(format_, blob));
    });
  }
  if (result == 0 && pending) take(pending->number, pending->leaf);
  return result;
}

void Store::result_auxiliary(sqlite3_context* context, std::int64_t id, int column) {
  rows().result_auxiliary(context, id, column);
}

std::int64_t Store::count() {
  const std::int64_t stored = rows().count();
  if (!pending_.map_half_written) return stored + pending_.more;
  std::int64_t more = 0;
  for (const IdChange& change : pending_.ids.sorted())
    more += (change.leaf != IdChanges::erased) - rows().leaf_of(change.id).has_value();
  return stored + more;
}

std::vector<std::string> Store::check(Interrupt& interrupt) {
  flush();
  return check_tables(rows(), format_, name_, has_auxiliaries(), interrupt);
}

}  // namespace foresee
