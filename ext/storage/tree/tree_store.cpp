#include "storage/tree/tree_store.h"

#include <algorithm>
#include <limits>

#include "base/interrupt_steps.h"
#include "base/repeatable_choice.h"
#include "database/sqlite_api.h"
#include "format/leaf_node.h"

namespace foresee {
namespace {

// If a larger share of the objects has changed, the whole tree is loaded. Per object a load costs a twentieth of an
// insert, and it gives a better tree.
constexpr double always_loaded = 1.0 / 8;
// A table that exceeds the memory for sorting is in a file larger than caches: a merge reads its leaves from there.
constexpr double always_loaded_if_large = 1.0 / 16;
// Merges make the tree worse in time. So from this share on, the tree is loaded with the share as probability: about
// once when each object has been reported once. With a smaller share, a load takes several times as long as a merge.
constexpr double sometimes_loaded = 1.0 / 24;
// New objects alone are packed beside the others: then only half of the table is worth it.
constexpr double min_loaded_of_new = 0.5;

/// Objects that are looked up in their leaves when they are erased.
constexpr std::size_t few_erased = 32;

constexpr std::int64_t no_number = std::numeric_limits<std::int64_t>::max();

}  // namespace

TreeStore::TreeStore(sqlite3* db, const NodeFormat& format, const QualifiedName& name, double horizon,
                     Journal& journal, MemoryBudget& memory, std::function<void()> write_out)
    : db_(db),
      format_(format),
      name_(name),
      write_out_(std::move(write_out)),
      share_(memory, *this),
      cache_(format, name, share_, journal),
      tree_(make_tpr_tree(cache_, horizon)),
      pending_(journal, static_cast<std::size_t>(format.at.size)),
      has_runs_(journal),
      pending_updates_(journal) {}

void TreeStore::note_memory() noexcept {
  share_.hold_pending(pending_.memory());
  cache_.note_memory();
}

// --- changes

void TreeStore::insert(std::int64_t id, std::span<const double> record) {
  if (pending_.is_erased(id) && !pending_updates_.get()) pending_updates_.change() = true;
  pending_.add(id, record);
}

bool TreeStore::update(std::int64_t id, std::span<const double> record) {
  if (pending_.find(id)) {
    pending_.replace(id, record);
    return true;
  }
  const NodeNumber leaf = pending_.is_erased(id) ? 0 : cache_.find_sound_leaf(id);
  if (leaf == 0) return false;
  if (!pending_updates_.get()) pending_updates_.change() = true;
  pending_.add(id, record, leaf);
  return true;
}

bool TreeStore::erase(std::int64_t id) {
  if (pending_.is_erased(id)) return false;
  const bool is_pending = pending_.find(id) != nullptr;
  // If a leaf is damaged, this fails, and not the COMMIT. Of many objects reading the map takes long enough.
  const auto is_in_tree = [&] {
    return pending_.erased_count() < few_erased ? cache_.find_record(id) != nullptr
                                                : cache_.find_leaf(id).has_value();
  };
  const bool is_stored = (!is_pending || pending_updates_.get()) && is_in_tree();
  if (is_pending) pending_.erase(id);
  if (is_stored) pending_.erase_stored(id);
  return is_pending || is_stored;
}

bool TreeStore::replace(std::int64_t id, std::int64_t new_id, std::span<const double> record) {
  const bool waits = pending_.find(id) || pending_.is_erased(id) || pending_.is_erased(new_id);
  return !waits && tree_->replace(id, new_id, record);
}

template <class Use>
auto TreeStore::with_pending(Use use) const {
  if (!pending_.has_holes()) return use(pending_.all_ids(), pending_.all_records());
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  append_pending(ids, records);
  return use(std::span<const std::int64_t>(ids), std::span<const double>(records));
}

// A leaf that waits with an object is up to date here: the map is written only when nothing is pending, and replace()
// refuses ids that wait.
void TreeStore::merge_pending(Reason reason, Interrupt& interrupt) {
  if (!must_merge(reason)) return;
  reporting_damage([&] {
    const std::vector<std::int64_t> erased = pending_.erased_ids();
    cache_.trust_leaves_of(pending_);
    constexpr std::size_t many = 1 << 10;
    if (reason == Reason::commit && pending_.count() + erased.size() >= many) cache_.start_commit();
    const std::size_t max_leaves =
        share_.budget().max_waiting() / format_.node_size / 2;  // each as it was and as it becomes
    tree_->erase_all(erased, std::max<std::size_t>(max_leaves, 1), interrupt);
    changes_ += pending_.count() + erased.size();
    if (pending_.count() > 0 || (reason == Reason::commit && has_runs_.get()))
      merge_records(reason, interrupt);
    if (reason == Reason::commit) repack_dispersed(erased);
  });
  pending_.remove_all();
  if (pending_updates_.get()) pending_updates_.change() = false;
}

void TreeStore::repack_dispersed(std::span<const std::int64_t> erased) {
  std::uint64_t draw = erased.empty() ? 0 : hash_of(static_cast<std::uint64_t>(erased.front()));
  if (pending_.count() > 0) draw ^= hash_of(pending_.first_record());
  tree_->repack_dispersed(std::exchange(changes_, 0), draw);
}

double TreeStore::min_loaded(bool is_large) const {
  const double always = is_large ? always_loaded_if_large : always_loaded;
  if (pending_.count() == 0) return always;
  return std::clamp(fraction_of(hash_of(pending_.first_record())), sometimes_loaded, always);
}

TreeStore::Placement TreeStore::placement_of_pending(double stored, bool is_large, Reason reason,
                                                     Interrupt& interrupt) const {
  const double pending = static_cast<double>(pending_.count());
  const bool packs_new = !pending_updates_.get() && tree_->packs_new(pending_.count());
  const bool many = pending > stored * (packs_new ? min_loaded_of_new : min_loaded(is_large));
  const bool more_follow = reason == Reason::memory && (many || has_runs_.get());
  // Of a large load: the commit packs everything once.
  if (more_follow && !pending_updates_.get() && tree_->takes_run(pending_.count())) return Placement::run;
  const bool packs_runs = reason == Reason::commit && has_runs_.get();
  if (stored == 0 || packs_runs) return Placement::load;
  // A few objects, or many in few nodes.
  return !many || (is_large && arrive_in_place(interrupt)) ? Placement::merge : Placement::load;
}

void TreeStore::merge_records(Reason reason, Interrupt& interrupt) {
  const double pending = static_cast<double>(pending_.count()), stored = estimate_objects(cache_, pending);
  const double bytes = (pending + stored) * static_cast<double>(format_.record_size);
  const bool is_large = bytes > static_cast<double>(share_.budget().max_ordered());
  switch (placement_of_pending(stored, is_large, reason, interrupt)) {
    case Placement::run:
      return add_run(interrupt);
    case Placement::merge:
      return with_pending([&](auto ids, auto records) {
        if (pending_updates_.get())
          tree_->merge(ids, records, interrupt);
        else
          tree_->merge_new(ids, records, interrupt);
      });
    case Placement::load:
      if (stored > 0 && is_large)
        load_partitioned(interrupt);  // more than may be sorted together
      else
        reload(interrupt);
      note_packed();
  }
}

bool TreeStore::arrive_in_place(Interrupt& interrupt) const {
  return pending_updates_.get() && with_pending([&](auto ids, auto records) {
           return tree_->arrive_in_place(ids, records, interrupt);
         });
}

// Their places are written at once: in memory each would take five times as much until the transaction ends.
void TreeStore::add_run(Interrupt& interrupt) {
  const bool is_first = cache_.find_root() == 0;
  cache_.drop_nodes(true);
  with_pending([&](std::span<const std::int64_t> ids, std::span<const double> records) {
    cache_.start_placing_new(ids.size());
    tree_->add_run(ids, records, interrupt);
    cache_.write_places({}, interrupt);
  });
  if (!is_first) has_runs_.change() = true;
}

void TreeStore::write(Interrupt& interrupt) {
  reporting_damage([&] { cache_.write(interrupt); });
}

// --- reading

bool TreeStore::read_stored(std::int64_t id, std::vector<double>& record) {
  const std::optional<std::int64_t> number = rows_->map().find_leaf(id);
  if (!number) return false;
  const std::string where = "node " + std::to_string(*number);
  record.resize(static_cast<std::size_t>(format_.at.size));
  int slot = -1;
  const bool found = rows_->nodes().read_one(*number, [&](std::span<const std::byte> blob) {
    if (!is_sound_leaf(*number, blob)) return;
    const LeafView leaf(format_, blob);
    slot = leaf.find(id);
    if (slot >= 0) leaf.copy_record(slot, record.data());
  });
  if (!found) throw_damaged(name_, where + " of object " + std::to_string(id) + " is missing");
  if (slot < 0) throw_damaged(name_, where + " lacks object " + std::to_string(id));
  return true;
}

bool TreeStore::is_sound_leaf(std::int64_t number, std::span<const std::byte> blob) const {
  if (const char* fault = cache_.fault(number, blob))
    throw_damaged(name_, "node " + std::to_string(number) + " is damaged: " + fault);
  return blob[NodeFormat::level_at] == std::byte{0};
}

void TreeStore::read_leaves(Interrupt& interrupt, const UseLeaf& use) {
  std::int64_t done = 0;
  const auto dirty_up_to = [&](std::int64_t end) {
    for (std::int64_t next; (next = cache_.next_dirty(done, end)) != 0; done = next)
      if (const auto node = *cache_.dirty_node(next); node && node->is_leaf()) use(*node);
    done = std::max(done, end - 1);
  };
  Node leaf;
  unsigned leaves = 0;
  rows_->nodes().read_all([&](std::int64_t number, std::span<const std::byte> blob) {
    if (++leaves % 16 == 0) interrupt.check();
    const bool is_current = !cache_.dirty_node(number), is_leaf = is_current && is_sound_leaf(number, blob);
    dirty_up_to(number);
    if (!is_leaf) return;
    decode_leaf(format_, blob, leaf);
    use(leaf);
  });
  dirty_up_to(no_number);
}

void TreeStore::read_leaves(std::span<const NodeNumber> numbers, Interrupt& interrupt, const UseLeaf& use) {
  unsigned leaves = 0;
  for (const NodeNumber number : numbers) {
    if (++leaves % 16 == 0) interrupt.check();
    const std::shared_ptr<const Node> leaf = cache_.read(number);
    if (!leaf->is_leaf()) throw_damaged(name_, "node " + std::to_string(number) + " is no leaf");
    use(*leaf);
  }
}

NodeNumber TreeStore::next_leaf(NodeNumber after, Node& leaf) {
  for (;;) {
    NodeNumber number = no_number;
    bool is_leaf = false;
    rows_->nodes().read_after(after, [&](std::int64_t stored, std::span<const std::byte> blob) {
      number = stored;
      if (cache_.next_dirty(after, stored) != 0 || cache_.dirty_node(stored)) return;
      is_leaf = is_sound_leaf(stored, blob);
      if (is_leaf) decode_leaf(format_, blob, leaf);
    });
    if (const NodeNumber dirty = cache_.next_dirty(after, number)) number = dirty;
    if (number == no_number) return 0;
    if (const auto node = cache_.dirty_node(number);
        node && *node && (*node)->is_leaf() && (*node)->size() > 0) {
      leaf = **node;
      is_leaf = true;
    }
    if (is_leaf) return number;
    after = number;
  }
}

void TreeStore::require_as_many(std::size_t found) {
  if (cache_.has_unwritten()) return;
  const auto mapped = static_cast<std::size_t>(rows_->map().count_ids());
  if (found != mapped)
    throw_damaged(name_,
                  "the leaves hold " + std::to_string(found) + " objects, the map " + std::to_string(mapped));
}

}  // namespace foresee
