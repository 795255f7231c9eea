// Write-back cache of TPR-tree nodes over the table <name>_node: nodes are decoded when they are read and
// written once per transaction, at commit.
//
//   cache.forget_all();                      // another connection has changed the table
//   auto tree = make_tpr_tree(cache, 60);    // index/pages.h says what a tree may do with its pages
//   const Journal::Mark change = journal.set_mark(); tree->insert(42, record); journal.forget(change);  // or rewind
//   cache.write(interrupt);                  // writes all dirty nodes, the map and the root
//
// Clean nodes stay in memory within the budget of the connection (memory_budget.h), as long as the stamp of
// the table does not change. A node is copied before it changes only while a mark of the journal or a snapshot
// refers to its old state (node_history.h).
//
// Stored rows may be damaged or hostile. A node that passes leaf_fault() or inner_fault() is sound alone;
// what nodes say about one another is checked by the tree.
#pragma once

#include <optional>
#include <vector>

#include "database/memory_budget.h"
#include "format/node_format.h"
#include "storage/nodes/id_map.h"
#include "storage/nodes/leaf_hints.h"
#include "storage/nodes/node_slots.h"
#include "storage/nodes/pending_objects.h"

namespace foresee {

class NodeCache final : public Pages, public Journal::Participant {
 public:
  /// `name` is the table name in messages; it, the share and the journal must outlive the cache.
  NodeCache(const NodeFormat& format, const QualifiedName& name, MemoryShare& share, Journal& journal)
      : Participant(journal, Scope::marks),
        format_(format),
        name_(name),
        share_(share),
        head_(journal),
        ids_(journal, name) {}
  /// Reads and writes these rows from now on.
  void connect(TreeRows& rows) {
    rows_ = &rows;
    ids_.connect(rows);
  }

  // --- Pages
  const Layout& layout() const override { return format_.layout; }
  NodeNumber find_root() override;
  std::shared_ptr<const Node> read(NodeNumber number) override { return fetch(number).state.node; }
  std::size_t leaf_capacity() const override { return format_.leaf_capacity; }
  std::size_t inner_capacity() const override { return format_.inner_capacity; }
  Node& modify(NodeNumber number) override;
  NodeNumber allocate() override;
  NodeNumber reserve(std::size_t count) override;
  void put(NodeNumber number, Node node) override;
  void make_room() override;
  void free(NodeNumber number) override;
  void set_root(NodeNumber number) override;
  std::optional<NodeNumber> find_leaf(std::int64_t id) override;
  /// Cost: those of unknown leaves are looked up in the order of ids, so that each row of the map is read once.
  std::vector<NodeNumber> leaves_of(std::span<const std::int64_t> ids, Interrupt& interrupt) override;
  void place(std::span<const std::int64_t> ids, NodeNumber leaf) override { ids_.place(ids, leaf); }
  void forget(std::int64_t id) override { ids_.erase(id); }
  void start_placing(std::span<const std::int64_t> new_ids) override { ids_.start_list(new_ids); }
  void finish_placing(Interrupt& interrupt) override;

  // --- objects
  /// The record of an object; null: no such object. Valid until the next call of the cache.
  const double* find_record(std::int64_t id) { return record_at(find_place(id)); }
  /// The leaf of an object, read and checked as by find_record(); 0: no such object.
  NodeNumber find_sound_leaf(std::int64_t id) {
    const Place place = find_place(id);
    return record_at(place) ? place.leaf : 0;
  }
  /// From now until the map is written, the leaves that wait with these objects are up to date, but for objects that
  /// have been placed or forgotten since. They must outlive all look-ups.
  void trust_leaves_of(const PendingObjects& pending) { trusted_ = {&pending, ids_.writes()}; }
  /// find_record() without reading rows; null: not known in memory.
  const double* find_record_in_memory(std::int64_t id) { return record_at(find_in_memory(id)); }
  /// As IdMap::extent(), and the ids of a range, both without pending objects.
  std::optional<IdRange> id_extent() { return ids_.extent(); }
  IdWalk walk_ids(const IdRange& range, IdOrder order) { return IdWalk(ids_, range, order); }
  /// Prefetches the memory that find_record_in_memory() reads for `many` ids from `first` on. Requires: none
  /// of these ids overflows.
  void fetch_ahead(std::int64_t first, std::int64_t many);

  // --- stored and dirty state
  /// Empties the cache. Requires: no change is unwritten.
  void forget_all();
  /// Drops clean nodes and the root, so that they are read again. Requires: no change is unwritten.
  void forget_clean();
  bool has_unwritten() const {
    return slots_.dirty() > 0 || ids_.has_unwritten() || head_->root_dirty || head_->wrote_early;
  }
  /// Reports the memory in use to the share.
  void note_memory() noexcept {
    share_.hold_nodes(slots_.dirty_held() * format_.node_size, ids_.memory(),
                      slots_.held() * format_.node_size);
  }
  /// Drops clean nodes: those not used since the last call, or all.
  void drop_nodes(bool all);
  /// Writes all dirty state: nodes by number, then the map by id, then the root.
  void write(Interrupt& interrupt);
  /// The state of a dirty node: the node, or null if it is deleted. Nothing: the node is clean.
  std::optional<std::shared_ptr<const Node>> dirty_node(NodeNumber number) const;
  /// The first dirty node between `after` and `before` (both excluded); 0: none.
  NodeNumber next_dirty(NodeNumber after, NodeNumber before);
  /// Frees every node, whether or not the tree refers to it, and voids the map.
  void erase_everything();
  /// As start_placing() and finish_placing(), but all objects are new, and all places are written at once.
  void start_placing_new(std::size_t count) { ids_.start_list_of_new(count); }
  void write_places(const std::optional<IdSum>& expected, Interrupt& interrupt);
  /// Call it before a large change that a COMMIT needs. If that fails, SQLite rolls the whole transaction back, so no
  /// old state is kept for the newest mark. (If it only were busy, it would not; but the transaction has its lock.)
  void start_commit() { prepare_early_write(); }
  /// Returns what is wrong with a node's bytes; null: nothing.
  const char* fault(NodeNumber number, std::span<const std::byte> blob) const;

  // --- snapshots
  NodeHistory::Snapshot take_snapshot();
  void give_up(NodeHistory::Snapshot snapshot) noexcept;
  bool has_snapshots() const { return history_.has_snapshots(); }
  /// The node as of the snapshot.
  std::shared_ptr<const Node> read_at(NodeHistory::Snapshot snapshot, NodeNumber number);

 private:
  using Slot = NodeSlots::Slot;
  struct Place {
    NodeNumber leaf = 0;  ///< 0: not known
    Slot* slot = nullptr;
    std::size_t record = 0;
  };
  /// The tree besides its nodes.
  struct Head {
    static constexpr NodeNumber unknown = -1;
    NodeNumber root = unknown;
    NodeNumber last = unknown;  ///< no node has a larger number
    bool root_dirty = false;
    bool wrote_early = false;  ///< some nodes were written during a change, the rest is still dirty
  };
  /// See trust_leaves_of().
  struct TrustedLeaves {
    const PendingObjects* pending = nullptr;
    std::uint64_t writes = 0;  ///< of the map, when it was called
  };
  /// Whether rows of deleted nodes are deleted too.
  enum class Deletions : std::uint8_t { write, defer };

  // --- Participant
  std::size_t keep() override {
    ++keeper_;
    return history_.end();
  }
  void rewind(std::size_t position) override;
  void merge(std::size_t newer) noexcept override { compact(newer); }
  void forget() noexcept override;
  void end(Journal::Ended how) noexcept override;

  /// Null if the place is not known. The node counts as used.
  const double* record_at(const Place& place);
  /// Not known: no such object.
  Place find_place(std::int64_t id);
  Place find_by_hint(std::int64_t id);
  Place find_in_memory(std::int64_t id);
  /// The leaf of an object that has not been placed by this transaction, without reading rows; 0: not known.
  NodeNumber known_leaf(std::int64_t id);
  void learn(NodeNumber number, Slot& slot);
  Slot* fetch_if_stored(NodeNumber number);
  /// The node, which is read, checked and decoded if it is not in memory. SQLITE_CORRUPT_VTAB if it is
  /// damaged or missing.
  Slot& fetch(NodeNumber number);
  Slot& add_slot(NodeNumber number) {
    return slots_.add(number, share_.budget().max_kept() / format_.node_size);
  }
  /// The slot of a node that is replaced as a whole: its old state is read only if a snapshot may need it.
  Slot& slot_to_replace(NodeNumber number);
  /// Call it before a node changes and before it is written. Keeps the old state for the newest mark; nothing is
  /// copied, both share the node. If it throws, nothing is lost.
  void keep_before_change(NodeNumber number, Slot& slot);
  void replace(NodeNumber number, Slot& slot, std::shared_ptr<Node> node);
  void restore_node(NodeNumber number, const NodeState& state) noexcept;
  void compact(std::size_t position) noexcept;
  void write_nodes(Deletions deletions);
  /// Call it before rows are written during a change: from here on only an older mark can undo it.
  void prepare_early_write();
  /// Call it before a node enters memory: evicts nodes if the connection holds too many.
  void evict_if_full();
  void drop_unused(std::uint64_t before);

  NodeFormat format_;
  const QualifiedName& name_;
  MemoryShare& share_;
  TreeRows* rows_ = nullptr;
  Journaled<Head> head_;
  IdMap ids_;
  NodeSlots slots_;
  ChangedNodes changed_;
  LeafHints hints_;
  TrustedLeaves trusted_;
  NodeHistory history_;
  std::uint64_t keeper_ = 1;  ///< advances with every mark and snapshot that may keep a node
};

}  // namespace foresee
