#include "storage/nodes/id_map.h"

#include <utility>

#include "base/interrupt_steps.h"
#include "database/sqlite_api.h"

namespace foresee {
namespace {

// Log entries for the old value of stored_is_void_; they belong to no id.
constexpr std::int64_t was_void = -2, was_not_void = -3;

/// A leaf of a load has more objects than these.
constexpr std::size_t few = 8;

}  // namespace

const IdBlock& IdMap::block(std::int64_t id) {
  if (!has_block(id)) last_block_ = rows_->map().find(id);
  return *last_block_;
}

// --- changes

void IdMap::set(std::int64_t id, std::int64_t leaf) {
  join();
  unwritten_ids_.reset();
  if (!is_marked()) {
    leaves_.exchange(id, leaf);
    log_.started_empty = false;
    return;
  }
  constexpr std::size_t some = 64;
  if (log_.old.size() == log_.old.capacity()) log_.old.reserve(std::max(some, 2 * log_.old.size()));
  log_.old.push_back({id, leaves_.exchange(id, leaf)});
}

void IdMap::place(std::span<const std::int64_t> ids, std::int64_t leaf) {
  if (list_ && leaf <= PlacedIds::max_leaf) {
    list_->add(ids, leaf);
    if (filter_ && lists_new_) filter_->add(ids);
    return;
  }
  if (!filter_ && ids.size() >= few && has_no_ids()) filter_.emplace();
  for (const std::int64_t id : ids) leaves_.prefetch(id);
  for (const std::int64_t id : ids) set(id, leaf);
}

/// Logs everything that is unwritten, and that the stored map was valid or not if that changes.
void IdMap::log_all(bool voids) {
  join();
  if (!is_marked()) return;
  const std::vector<IdHashMap::Entry> unwritten = leaves_.known();
  log_.old.reserve(log_.old.size() + unwritten.size() + 1);
  log_.old.insert(log_.old.end(), unwritten.begin(), unwritten.end());
  if (voids || stored_is_void_) log_.old.push_back({0, stored_is_void_ ? was_void : was_not_void});
}

void IdMap::void_stored() {
  log_all(true);
  log_.started_empty &= is_marked();
  leaves_.reset();
  unwritten_ids_.reset();
  stored_is_void_ = true;
  filter_.reset();
}

// --- reading in order

std::shared_ptr<const IdMap::Ids> IdMap::unwritten_ids() {
  if (unwritten_ids_) return unwritten_ids_;
  auto ids = std::make_shared<Ids>();
  for (const IdHashMap::Entry& entry : leaves_.known())
    if (entry.value != erased) ids->push_back(entry.id);
  std::sort(ids->begin(), ids->end());
  unwritten_ids_ = std::move(ids);
  return unwritten_ids_;
}

std::optional<IdRange> IdMap::extent() {
  std::optional<IdRange> all;
  if (!stored_is_void_) all = rows_->map().read_extent();
  if (const auto ids = unwritten_ids(); !ids->empty()) {
    const IdRange stored = all.value_or(IdRange{ids->front(), ids->back()});
    all = IdRange{std::min(stored.first, ids->front()), std::max(stored.last, ids->back())};
  }
  return all;
}

// A batch is some rows. Ids that were placed since the last write are merged in; ids that are erased by now are left
// out.
bool IdWalk::next(std::vector<std::int64_t>& ids) {
  constexpr std::int64_t max_rows = 256;
  const bool ascend = order_ == IdOrder::ascending;
  ids.clear();
  while (ids.empty() && !rest_.is_empty()) {
    IdRange batch = rest_;
    rest_ = map_->stored_is_void_ ? IdRange{1, 0} : map_->rows_->map().read_ids(rest_, order_, rows_, ids);
    rows_ = std::min(max_rows, 4 * rows_ + 4);
    if (!rest_.is_empty()) (ascend ? batch.last : batch.first) = ascend ? rest_.first - 1 : rest_.last + 1;
    if (map_->has_unwritten())
      std::erase_if(ids, [&](std::int64_t id) { return map_->find_unwritten(id) == IdMap::erased; });
    const auto first = std::lower_bound(placed_->begin(), placed_->end(), batch.first);
    const auto last = std::upper_bound(first, placed_->end(), batch.last);
    if (first == last) continue;
    if (!ascend) std::reverse(ids.begin(), ids.end());
    const auto stored = static_cast<std::ptrdiff_t>(ids.size());
    ids.insert(ids.end(), first, last);
    std::inplace_merge(ids.begin(), ids.begin() + stored, ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    if (!ascend) std::reverse(ids.begin(), ids.end());
  }
  return !ids.empty();
}

// --- writing

void IdMap::write(Interrupt& interrupt) {
  if (!has_unwritten()) return;
  ++writes_;
  if (stored_is_void_) rows_->map().erase_all();
  std::vector<IdHashMap::Entry> changes = leaves_.known();
  Steps step(interrupt);
  std::sort(changes.begin(), changes.end(), [&](const IdHashMap::Entry& a, const IdHashMap::Entry& b) {
    step();
    return a.id < b.id;
  });
  if (filter_) add_to_filter(changes);
  rows_->write_map(changes);
  note_written();
}

void IdMap::add_to_filter(std::span<const IdHashMap::Entry> changes) {
  std::vector<std::int64_t> ids;
  ids.reserve(changes.size());
  for (const IdHashMap::Entry& change : changes)
    if (change.value != erased) ids.push_back(change.id);
  filter_->add(ids);
}

/// Logs that all changes are written. What was logged since nothing was unwritten, after the newest mark, cancels
/// itself: a statement that erases millions of rows would log each of them.
void IdMap::log_write() {
  join();
  std::size_t newest = 0;
  for_each_position([&](std::size_t position) { newest = std::max(newest, position); });
  if (log_.empty_at && *log_.empty_at >= newest)
    log_.old.resize(*log_.empty_at);
  else
    log_all(false);
  IdHashMap prepared;
  for (const IdHashMap::Entry& entry : log_.old) prepared.prepare(entry.id);
  leaves_ = std::move(prepared);
  log_.empty_at = log_.old.size();
}

void IdMap::note_written() {
  if (!is_marked()) return clear();
  last_block_.reset();
  log_write();
  stored_is_void_ = false;
  unwritten_ids_.reset();
  held_after_writing_ = held();
}

void IdMap::start_list(std::span<const std::int64_t> new_ids) {
  start_list_of_new(new_ids.size());
  if (filter_) filter_->add(new_ids);
  lists_new_ = false;
}

void IdMap::start_list_of_new(std::size_t count) {
  join();
  if (!filter_ && has_no_ids()) filter_.emplace(count);
  list_.emplace();
  lists_new_ = true;
}

void IdMap::keep_list(Interrupt& interrupt) {
  std::optional<PlacedIds> list = std::exchange(list_, std::nullopt);
  list->for_each_chunk([&](std::span<const IdHashMap::Entry> chunk) {
    interrupt.check();
    for (const IdHashMap::Entry& entry : chunk) set(entry.id, entry.value);
  });
}

void IdMap::write_list(const std::optional<IdSum>& expected, Interrupt& interrupt) {
  if (expected && list_->sum() != *expected)
    throw StoreError(SQLITE_IOERR,
                     name_.table +
                         ": the objects changed while they were read twice: another program writes to "
                         "the database or to the temporary file; roll back");
  ++writes_;
  write(interrupt);
  list_->for_each_chunk([&](std::span<const IdHashMap::Entry> chunk) {
    interrupt.check();
    rows_->write_map(chunk);
  });
  list_.reset();
  last_block_.reset();
}

// --- rollbacks

std::size_t IdMap::keep() {
  if (!has_unwritten())
    log_.empty_at = log_.old.size();
  else if (log_.empty_at == log_.old.size())
    log_.empty_at.reset();
  return log_.old.size();
}

void IdMap::rewind(std::size_t position) noexcept {
  forget_stored();
  list_.reset();
  unwritten_ids_.reset();
  if (position == 0 && log_.started_empty) return clear();  // fast path: a bulk load is rolled back
  if (log_.empty_at && *log_.empty_at > position) log_.empty_at.reset();
  for (; log_.old.size() > position; log_.old.pop_back()) {
    const IdHashMap::Entry& before = log_.old.back();
    if (before.value == was_void || before.value == was_not_void)
      stored_is_void_ = before.value == was_void;
    else
      leaves_.set(before.id, before.value);
  }
  held_after_writing_ = std::min(held_after_writing_, held());
}

void IdMap::forget() noexcept {
  log_.old.clear();
  log_.empty_at.reset();
  log_.started_empty = !has_unwritten();
  held_after_writing_ = std::min(held_after_writing_, held());
}

void IdMap::clear() noexcept {
  leaves_.clear();
  unwritten_ids_.reset();
  log_.old.clear();
  log_.empty_at.reset();
  held_after_writing_ = 0;
  stored_is_void_ = false;
  log_.started_empty = true;
  last_block_.reset();
}

void IdMap::end(Journal::Ended how) noexcept {
  clear();
  list_.reset();
  if (how == Journal::Ended::rolled_back) filter_.reset();
}

}  // namespace foresee
