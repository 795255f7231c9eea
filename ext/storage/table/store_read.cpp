// Store: reads, from pending objects and dirty nodes first, then from the shadow rows.
#include <atomic>
#include <limits>

#include "storage/format/leaf_node.h"
#include "storage/rows/value_text.h"
#include "storage/table/integrity_check.h"
#include "storage/table/store.h"
#include "storage/table/store_change.h"

namespace foresee {
namespace {

constexpr std::int64_t no_number = std::numeric_limits<std::int64_t>::max();

/// Appends all objects of a leaf.
void append(const LeafView& leaf, std::size_t record_size, std::vector<std::int64_t>& ids,
            std::vector<double>& records) {
  const std::size_t before = ids.size();
  ids.resize(before + static_cast<std::size_t>(leaf.count()));
  records.resize(ids.size() * record_size);
  leaf.copy_ids(ids.data() + before);
  leaf.copy_records(records.data() + before * record_size);
}

void append(const Node& leaf, std::size_t, std::vector<std::int64_t>& ids, std::vector<double>& records) {
  ids.insert(ids.end(), leaf.keys.begin(), leaf.keys.end());
  records.insert(records.end(), leaf.values.begin(), leaf.values.end());
}

}  // namespace

// While this connection writes no other one can. At any other time another one may have written.
void Store::revalidate_cache() {
  if (version_.is_own()) return;
  const auto stamp = shadow_rows().read_stamp();
  if (!stamp) damaged("the stamp is missing");
  if (version_.seen() == stamp) return;
  cache_.forget_all();
  if (forms_) forms_->forget_all();
  version_.forget();
  totals_.change().count.stored = shadow_rows().read_objects();
  watches_.change().reset();
  origin_.change() = {};
  version_.read(*stamp);
}

const Frame& Store::frame() {
  if (!declaration_.frame.chooses_origin()) return frame_;
  revalidate_cache();
  if (!origin_->known) {
    const std::string stored = shadow_rows().meta().read("origin");
    const std::optional<LatLon> origin = parse_origin(stored);
    if (!origin && !stored.empty())
      damaged("the origin '" + without_nul(stored) + "' in _meta is no latitude and longitude");
    if (!origin && shadow_rows().read_root().value_or(0) != 0) damaged("the origin is missing in _meta");
    origin_.change() = {.known = true, .value = origin};
  }
  frame_.origin = origin_->value;
  return frame_;
}

const Frame& Store::frame_of_objects(StatementReadState* statement_state) {
  if (!declaration_.frame.chooses_origin()) return frame_;
  if (!version_.is_checked(statement_state) || !origin_->known) frame();
  version_.note_checked(statement_state);
  if (!origin_->value) damaged("the origin is missing in _meta");
  frame_.origin = origin_->value;
  return frame_;
}

ContentVersion Store::read_version() {
  revalidate_cache();
  const auto stamp = version_.is_own() ? shadow_rows().read_stamp() : version_.seen();
  if (!stamp) damaged("the stamp is missing");
  return version_.shown(*stamp);
}

std::optional<std::int64_t> Store::find_leaf(std::int64_t id) {
  return version_.is_own() ? nodes().find_leaf(id) : shadow_rows().map().find_leaf(id);
}

bool Store::contains(std::int64_t id) {
  if (pending_.find(id)) return true;
  // New ascending ids, the common case, are larger than any known id.
  const LargestId& largest = totals_->largest;
  if (largest.known && (!largest.id || *largest.id < id)) return false;
  return find_leaf(id).has_value();
}

std::optional<std::vector<double>> Store::read(std::int64_t id) {
  const auto size = static_cast<std::size_t>(format_.at.size);
  const double* found = pending_.find(id);
  if (!found && version_.is_own()) found = nodes().find_record(id);
  if (found) return std::vector<double>(found, found + size);
  std::vector<double> record;
  if (version_.is_own() || !read_stored(id, record)) return std::nullopt;
  return record;
}

std::span<const double> Store::find(std::int64_t id, StatementReadState& statement_state) {
  const auto size = static_cast<std::size_t>(format_.at.size);
  const auto found = [size](const double* record) { return std::span(record, record ? size : 0); };
  if (const double* record = pending_.find(id)) return found(record);
  if (version_.is_own()) return found(nodes().find_record(id));
  if (version_.is_checked(&statement_state)) {
    if (const double* record = nodes().find_record_in_memory(id)) return found(record);
    if (!cache_.find_leaf(id)) return found(nullptr);
  }
  // The first row after opening should not wait until one more statement is compiled.
  if (!version_.seen() && first_found_.empty())
    return read_stored(id, first_found_) ? found(first_found_.data()) : found(nullptr);
  // Also before a node is read: with uncommitted reads (shared cache) it may belong to another stamp.
  revalidate_cache();
  version_.note_checked(&statement_state);
  return found(cache_.find_record(id));
}

/// Reads without the cache.
bool Store::read_stored(std::int64_t id, std::vector<double>& record) {
  const std::optional<std::int64_t> number = shadow_rows().map().find_leaf(id);
  if (!number) return false;
  const std::string where = "node " + std::to_string(*number);
  record.resize(static_cast<std::size_t>(format_.at.size));
  int slot = -1;
  const bool found = shadow_rows().read_node(*number, [&](std::span<const std::byte> blob) {
    read_stored_leaf(*number, blob, [&](const LeafView& leaf) {
      slot = leaf.find(id);
      if (slot >= 0) leaf.copy_record(slot, record.data());
    });
  });
  if (!found) damaged(where + " of object " + std::to_string(id) + " is missing");
  if (slot < 0) damaged(where + " lacks object " + std::to_string(id));
  return true;
}

bool Store::read_stored_leaf(std::int64_t number, std::span<const std::byte> blob,
                             const std::function<void(const LeafView&)>& use) const {
  if (const char* fault = cache_.fault(number, blob))
    damaged("node " + std::to_string(number) + " is damaged: " + fault);
  if (blob[NodeFormat::level_at] != std::byte{0}) return false;
  use(LeafView(format_, blob));
  return true;
}

void Store::read_leaves(Interrupt& interrupt, const std::function<void(const LeafView&)>& stored,
                        const std::function<void(const Node&)>& dirty) {
  std::int64_t done = 0;
  const auto dirty_up_to = [&](std::int64_t end) {
    for (std::int64_t next; (next = cache_.next_dirty(done, end)) != 0; done = next)
      if (const auto node = *cache_.dirty_node(next); node && node->is_leaf()) dirty(*node);
    done = std::max(done, end - 1);
  };
  unsigned leaves = 0;
  shadow_rows().read_all_nodes([&](std::int64_t number, std::span<const std::byte> blob) {
    if (++leaves % 16 == 0) interrupt.check();
    dirty_up_to(number);
    if (!cache_.dirty_node(number)) read_stored_leaf(number, blob, stored);
  });
  dirty_up_to(no_number);
}

void Store::read_all(std::vector<std::int64_t>& ids, std::vector<double>& rows, Interrupt& interrupt) {
  merge_pending();
  ids.clear();
  rows.clear();
  const bool has_unwritten = cache_.has_unwritten();
  const auto expected = has_unwritten ? 0 : static_cast<std::size_t>(this->shadow_rows().map().count_ids());
  const auto row_size = static_cast<std::size_t>(row_offsets(format_.layout).size);
  const auto record_size = static_cast<std::size_t>(format_.at.size);
  const bool rows_are_records = format_.layout.law != Law::forced;
  std::vector<double> records;
  ids.reserve(expected);
  rows.reserve(expected * row_size);
  const auto take = [&](const auto& leaf) {
    if (rows_are_records) return append(leaf, record_size, ids, rows);
    records.clear();
    const std::size_t before = ids.size();
    std::vector<std::int64_t> leaf_ids;
    append(leaf, record_size, leaf_ids, records);
    ids.insert(ids.end(), leaf_ids.begin(), leaf_ids.end());
    rows.resize(ids.size() * row_size);
    for (std::size_t i = 0; i < leaf_ids.size(); ++i)
      row_from_record(format_.layout, records.data() + i * record_size,
                      rows.data() + (before + i) * row_size);
  };
  read_leaves(interrupt, take, take);
  expect_objects(ids.size());
}

void Store::expect_objects(std::size_t found) {
  totals_.change().count.note_all(found);
  if (cache_.has_unwritten()) return;
  const auto mapped = static_cast<std::size_t>(shadow_rows().map().count_ids());
  if (found != mapped)
    damaged("the leaves hold " + std::to_string(found) + " objects, the map " + std::to_string(mapped));
}

std::int64_t Store::next_leaf(std::int64_t after, std::vector<std::int64_t>& ids,
                              std::vector<double>& records) {
  if (after == 0) merge_pending();
  ids.clear();
  records.clear();
  const auto size = static_cast<std::size_t>(format_.at.size);
  for (;;) {
    std::int64_t number = no_number;
    bool is_leaf = false;
    shadow_rows().read_node_after(after, [&](std::int64_t stored, std::span<const std::byte> blob) {
      number = stored;
      if (cache_.next_dirty(after, stored) == 0 && !cache_.dirty_node(stored))
        is_leaf =
            read_stored_leaf(stored, blob, [&](const LeafView& leaf) { append(leaf, size, ids, records); });
    });
    if (const std::int64_t dirty = cache_.next_dirty(after, number)) number = dirty;
    if (number == no_number) return 0;
    if (const auto node = cache_.dirty_node(number); node && *node && (*node)->is_leaf()) {
      append(**node, size, ids, records);
      is_leaf = true;
    }
    if (is_leaf) return number;
    after = number;
  }
}

void Store::result_auxiliary(sqlite3_context* context, std::int64_t id, int column) {
  shadow_rows().result_auxiliary(context, id, column);
}

double Store::read_newest_t() {
  revalidate_cache();
  merge_pending();
  return with_sound_tree([&] { return foresee::read_newest_t(nodes()); });
}

std::shared_ptr<const Form> Store::form(std::int64_t number) {
  revalidate_cache();  // under another stamp the number may refer to another form
  return forms_->form(number);
}

std::shared_ptr<const Form> Store::form(std::int64_t number, StatementReadState& statement_state) {
  if (!version_.is_checked(&statement_state)) revalidate_cache();
  version_.note_checked(&statement_state);
  return forms_->form(number);
}

std::vector<std::string> Store::integrity_check(Interrupt& interrupt) {
  flush();
  cache_.forget_clean();
  std::vector<std::string> faults = with_sound_tree([&] {
    return check_integrity(shadow_rows(), cache_, format_, name_, has_auxiliaries(),
                           forms_ ? &forms_->rows() : nullptr, interrupt);
  });
  origin_.change() = {};
  try {
    frame();
  } catch (const StoreError& error) {
    if ((error.code & 0xff) != SQLITE_CORRUPT) throw;
    faults.push_back(std::string(error.what()).substr(name_.table.size() + 2));
  }
  return faults;
}

}  // namespace foresee
