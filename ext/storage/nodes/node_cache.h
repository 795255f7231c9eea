// Write-back cache of TPR-tree nodes over the table <name>_node: nodes are decoded when they are read and
// written once per transaction, at commit.
//
//   cache.forget_all();                      // another connection has changed the table
//   auto tree = make_tpr_tree(cache, 60);    // index/pages.h says what a tree may do with its pages
//   cache.begin_change(); tree->insert(42, record); cache.end_change();    // or cancel_change(): undo it
//   cache.write(interrupt);                  // writes all dirty nodes, the map and the root
//
// Clean nodes stay in memory within the budget of the connection (memory_budget.h), as long as the stamp of
// the table does not change. Old states for savepoints, snapshots and the change in progress are in
// undo_log.h. A node is copied before it changes only while a snapshot or savepoint refers to its old state;
// a single changed record is kept alone.
//
// Stored rows may be damaged or hostile. A node that passes leaf_fault() or inner_fault() is sound alone;
// what nodes say about one another is checked by the tree.
#pragma once

#include <vector>

#include "storage/nodes/id_filter.h"
#include "storage/nodes/leaf_hints.h"
#include "storage/nodes/map_changes.h"
#include "storage/nodes/memory_budget.h"
#include "storage/nodes/packed_map.h"
#include "storage/nodes/undo_log.h"
#include "storage/rows/shadow_rows.h"

namespace foresee {

class NodeCache final : public Pages {
 public:
  /// `name` is the table name in messages; it, the share and the journal must outlive the cache.
  NodeCache(const NodeFormat& format, const QualifiedName& name, MemoryShare& share, Journal& journal)
      : format_(format), name_(name), share_(share), map_(journal) {}
  /// Reads and writes these rows from now on.
  void connect(ShadowRows& rows) { shadow_rows_ = &rows; }

  // --- Pages
  const Layout& layout() const override { return format_.layout; }
  NodeNumber find_root() override;
  std::shared_ptr<const Node> read(NodeNumber number) override { return fetch(number).state.node; }
  std::size_t leaf_capacity() const override { return format_.leaf_capacity; }
  std::size_t inner_capacity() const override { return format_.inner_capacity; }
  Node& modify(NodeNumber number) override;
  double* modify_record(NodeNumber leaf, std::size_t slot) override;
  NodeNumber allocate() override;
  NodeNumber reserve(std::size_t count) override;
  void put(NodeNumber number, Node node) override;
  void make_room() override;
  void free(NodeNumber number) override;
  void set_root(NodeNumber number) override;
  std::optional<NodeNumber> find_leaf(std::int64_t id) override;
  /// The record of an object; null: no such object. Valid until the next call of the cache.
  const double* find_record(std::int64_t id);
  /// The same without reading rows; null: not known in memory.
  const double* find_record_in_memory(std::int64_t id);
  /// Prefetches the memory that find_record_in_memory() reads for `many` ids from `first` on. Requires: none
  /// of these ids overflows.
  void fetch_ahead(std::int64_t first, std::int64_t many);
  void place(std::span<const std::int64_t> ids, NodeNumber leaf) override;
  void forget(std::int64_t id) override { map_.set(id, MapChanges::erased); }

  // --- stored and dirty state
  /// Empties the cache. Requires: no change is unwritten.
  void forget_all() noexcept;
  /// Drops clean nodes and the root, so that they are read again. Requires: no change is unwritten.
  void forget_clean();
  bool has_unwritten() const {
    return dirty_ > 0 || map_.has_unwritten() || head_.root_dirty || wrote_early_;
  }
  /// Reports the memory in use to the share.
  void note_memory() noexcept {
    const std::size_t gone = dirty_ - dirty_held_, held = slots_.size() - std::min(gone, slots_.size());
    share_.hold_nodes(dirty_held_ * format_.node_size, map_.memory(), held * format_.node_size);
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
  /// Until write_packed_map() or cancel_change(), place() records leaves in this map of all future objects.
  void place_into(PackedMap& map) noexcept { packed_map_ = &map; }
  /// Replaces the stored map by it. Requires: in a change.
  void write_packed_map(Interrupt& interrupt);
  /// Returns what is wrong with a node's bytes; null: nothing.
  const char* fault(NodeNumber number, std::span<const std::byte> blob) const;

  // --- one change of the tree: atomic
  /// Starts to keep the old state of nodes and root.
  void begin_change();
  /// The change is valid; the old state goes to the marks that may be restored, if any.
  void end_change();
  /// Restores nodes and root as of begin_change().
  void cancel_change() noexcept;
  /// True if rows were written during the change: then cancel_change() cannot undo everything.
  bool wrote_in_change() const { return wrote_in_change_; }

  // --- marks
  UndoLog::Handle set_mark(bool is_snapshot);
  bool has_snapshots() const { return undo_.snapshots() > 0; }
  void give_up(UndoLog::Handle mark) noexcept { undo_.give_up(mark); }
  /// The node as of the mark.
  std::shared_ptr<const Node> read_at(UndoLog::Handle mark, NodeNumber number);
  /// Restores the nodes and the root of a savepoint. SQLite has restored the rows already.
  void restore(UndoLog::Handle mark);

  // --- transactions
  /// A transaction starts. Nodes in memory stay.
  void begin();
  /// The transaction is committed; nothing can be undone any more.
  void commit() noexcept;
  /// Drops the nodes that this transaction changed. Snapshots keep what they saw.
  void roll_back() noexcept;

 private:
  struct Slot {
    NodeState state;
    std::uint64_t kept_by = 0;  ///< newest mark or change that has its old state
    std::uint64_t changed = 0;  ///< last transaction that changed it
    std::uint64_t used = 0;
    bool learned = false;  ///< its objects are in hints_
    bool holds = false;    ///< dirty and not deleted: counted in dirty_held_
  };

  [[noreturn]] void damaged(const std::string& what) const;
  [[noreturn]] void other_objects() const;
  struct Place {
    NodeNumber leaf = 0;  ///< 0: not known
    Slot* slot = nullptr;
    std::size_t record = 0;
  };
  const double* record_at(const Place& place);
  Place find_by_hint(std::int64_t id);
  void read_block(std::int64_t id);

  /// Null if the node is not in memory.
  Slot* in_memory(NodeNumber number);
  Slot* fetch_if_stored(NodeNumber number);
  /// The node, which is read, checked and decoded if it is not in memory. SQLITE_CORRUPT_VTAB if it is
  /// damaged or missing.
  Slot& fetch(NodeNumber number);
  void learn(NodeNumber number, Slot& slot);
  /// The slot of a node, created if necessary.
  Slot& add_slot(NodeNumber number);
  void erase_slot(NodeNumber number) noexcept;
  /// The slot of a node that is replaced as a whole: its old state is read only if a snapshot may need it.
  Slot& slot_to_replace(NodeNumber number);
  /// Records that this transaction changes the node, so that a rollback drops it. Only the first call per
  /// transaction costs anything.
  void note_changed(NodeNumber number, Slot& slot);
  /// Call it before a node changes and before it is written. Keeps the old state for the change in progress,
  /// else for the newest mark; nothing is copied, both share the node. If it throws, nothing is lost.
  void keep_before_change(NodeNumber number, Slot& slot);
  void restore_record() noexcept;
  /// Marks the node as dirty or clean.
  void set_dirty(Slot& slot, bool dirty) noexcept;
  void restore_node(NodeNumber number, const NodeState& state) noexcept;
  /// Numbers of dirty nodes, ascending. Cost: after each change, a sort of the nodes changed in this
  /// transaction.
  const std::vector<NodeNumber>& dirty_numbers();
  /// Whether rows of deleted nodes are deleted too.
  enum class Deletions : std::uint8_t { write, defer };
  /// Writes dirty nodes, by number.
  void write_nodes(Deletions deletions);
  /// Prepares to write rows during a change.
  void prepare_early_write();
  void hand_change_to_undo_log();
  /// Call it before a node enters memory: evicts nodes if the connection holds too many.
  void evict_if_full();
  void drop_unused(std::uint64_t before);

  NodeFormat format_;
  const QualifiedName& name_;
  MemoryShare& share_;
  ShadowRows* shadow_rows_ = nullptr;

  std::unordered_map<NodeNumber, Slot> slots_;
  /// Direct-mapped cache of pointers into slots_, by the low bits of the number: a look-up in slots_ misses
  /// the processor's caches.
  std::vector<std::pair<NodeNumber, Slot*>> places_;
  TreeHead head_;
  MapChanges map_;
  LeafHints hints_;
  std::optional<IdBlock> last_block_;  ///< last block read from the rows
  PackedMap* packed_map_ = nullptr;    ///< in place of map_ while the whole table is reloaded
  std::optional<IdFilter> filter_;     ///< all ids; only after the load of a large table
  std::size_t dirty_ = 0, dirty_held_ = 0;
  std::uint64_t use_ = 1;  ///< advances whenever unused nodes are dropped

  UndoLog undo_;
  std::uint64_t newest_keeper_ = 1;  ///< number of the newest mark or change, from 1
  std::uint64_t transaction_ = 1;
  std::vector<NodeNumber> changed_;        ///< in this transaction, with repetitions
  bool dropped_changed_ = false;           ///< some of them were written and then dropped
  std::vector<NodeNumber> dirty_numbers_;  ///< dirty nodes, ascending, unless stale
  bool dirty_numbers_are_stale_ = false;

  bool in_change_ = false, wrote_in_change_ = false;
  bool wrote_early_ = false;  ///< some nodes were written during a change, the rest is still dirty
  std::vector<std::pair<NodeNumber, NodeState>> change_log_;
  /// Old state of a single record: most updates change one record and nothing else.
  struct {
    NodeNumber leaf = 0;  ///< 0: none
    std::size_t slot;
    bool dirty;
    std::vector<double> values;
  } record_before_;
  TreeHead head_before_change_;
  std::shared_ptr<Node> spare_;  ///< memory for the next copy of a node
};

}  // namespace foresee
