// The tree's nodes between the tree and the table <name>_node: decoded when they are read, written once when
// a transaction commits.
//
//   cache.forget_all();                      // another connection has changed the table
//   auto tree = make_tpr_tree(cache, 60);    // index/pages.h says what a tree may do with its pages
//   cache.begin_change(); tree->insert(42, record); cache.end_change();    // or cancel_change(): as if nothing was
//   cache.write(interrupt);                  // everything that waits
//
// Nodes that were read stay, within the connection's memory_budget.h, for as long as the stamp says that
// nothing changed. Old states live in undo_log.h: savepoints, snapshots, and the change in progress. A node
// is copied before it changes only while somebody holds it as it was; for the change alone one record is
// enough.
//
// Rows are hostile: a node without fault by leaf_fault() or inner_fault() is believed by itself, what nodes
// say about one another is not.
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
  /// `name` is what messages call the table; it and the share must outlive the cache.
  NodeCache(const NodeFormat& format, const QualifiedName& name, MemoryShare& share)
      : format_(format), name_(name), share_(share) {}
  /// Where the rows are from now on.
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
  /// The record of an object; null: there is none. Good until the cache is called again.
  const double* find_record(std::int64_t id);
  /// The same, where memory alone can tell; null: it cannot.
  const double* find_record_in_memory(std::int64_t id);
  /// Asks the processor for what it will need to find these ids in memory. Requires: no id is too large.
  void fetch_ahead(std::int64_t first, std::int64_t many);
  void place(std::span<const std::int64_t> ids, NodeNumber leaf) override;
  void forget(std::int64_t id) override { map_.set(id, MapChanges::erased); }

  // --- what is stored, and what waits
  /// Requires: nothing waits.
  void forget_all() noexcept;
  /// Nodes and root will be read from the rows again. Requires: nothing waits.
  void forget_clean();
  bool waits() const { return dirty_ > 0 || map_.waits() || head_.root_dirty || wrote_early_; }
  /// Tells the share what is held.
  void note_memory() noexcept {
    const std::size_t gone = dirty_ - dirty_held_, held = slots_.size() - std::min(gone, slots_.size());
    share_.hold_nodes(dirty_held_ * format_.node_size, map_.memory(), held * format_.node_size);
  }
  /// Nodes that can be read again go: those not used since the last time, or all.
  void drop_nodes(bool all);
  /// Writes all that waits: nodes by number, then the map by id, then the root.
  void write(Interrupt& interrupt);
  /// A node that is not as its row says: the node, or null if it is gone. Nothing: the row is right.
  std::optional<std::shared_ptr<const Node>> waiting(NodeNumber number) const;
  /// The first node between `after` and `before` (both excluded) that waits; 0: there is none.
  NodeNumber next_waiting(NodeNumber after, NodeNumber before);
  /// Frees every node, whatever the tree says, and voids the map.
  void erase_everything();
  /// place() tells this map of all objects that there will be, until write_packed_map() or cancel_change().
  void place_into(PackedMap& map) noexcept { packed_map_ = &map; }
  /// Writes it in place of the stored one. Requires: in a change.
  void write_packed_map(Interrupt& interrupt);
  /// What is wrong with a node's bytes; null: nothing.
  const char* fault(NodeNumber number, std::span<const std::byte> blob) const;

  // --- one change of the tree: all or nothing
  /// From now on what nodes, map and root were before they change is kept.
  void begin_change();
  /// The change holds; what was kept goes to the marks that can still go back, or nowhere.
  void end_change();
  /// Nodes, map and root are as they were at begin_change().
  void cancel_change() noexcept;
  /// Cancelling no longer helps: rows were written during the change.
  bool wrote_in_change() const { return wrote_in_change_; }

  // --- marks
  UndoLog::Handle set_mark(bool is_snapshot);
  bool has_snapshots() const { return undo_.snapshots() > 0; }
  void give_up(UndoLog::Handle mark) noexcept { undo_.give_up(mark); }
  /// The node as it was at the mark.
  std::shared_ptr<const Node> read_at(UndoLog::Handle mark, NodeNumber number);
  std::size_t map_position() const { return map_.position(); }
  /// Back to a savepoint. SQLite has taken the rows back already.
  void restore(UndoLog::Handle mark, std::size_t map_position);

  // --- transactions
  /// Nothing has changed yet. Nodes in memory stay.
  void begin();
  /// What was written holds; nothing can be taken back any more.
  void commit() noexcept;
  /// Nodes that this transaction changed are forgotten. Snapshots keep what they saw.
  void roll_back() noexcept;

 private:
  struct Slot {
    NodeState state;
    std::uint64_t kept_by = 0;  ///< the newest mark or change that knows what it was
    std::uint64_t changed = 0;  ///< the transaction that changed it last
    std::uint64_t used = 0;
    bool learned = false;  ///< where its objects are
    bool holds = false;    ///< it waits, and is not gone: counted in dirty_held_
  };

  [[noreturn]] void damaged(const std::string& what) const;
  [[noreturn]] void other_objects() const;
  struct Place {
    NodeNumber leaf = 0;  ///< 0: nobody knows
    Slot* slot = nullptr;
    std::size_t record = 0;
  };
  const double* record_at(const Place& place);
  Place find_by_hint(std::int64_t id);
  void read_block(std::int64_t id);

  /// Null if its node would have to be read.
  Slot* in_memory(NodeNumber number);
  Slot* fetch_if_stored(NodeNumber number);
  /// The node in memory; read, checked and decoded if it was not. SQLITE_CORRUPT_VTAB if it is damaged or
  /// gone.
  Slot& fetch(NodeNumber number);
  void learn(NodeNumber number, Slot& slot);
  /// The slot of a node, new if there is none.
  Slot& add_slot(NodeNumber number);
  void erase_slot(NodeNumber number) noexcept;
  /// The slot of a node that is replaced as a whole: read only for those who hold a snapshot.
  Slot& overwritten(NodeNumber number);
  /// This transaction changes the node: a rollback forgets it. Once a transaction; later calls cost nothing.
  void note_changed(NodeNumber number, Slot& slot);
  /// Call it before a node changes and before it is written. Keeps what it was for the
  /// change in progress, else for the newest mark; nothing is copied, both share the node. Nothing is lost if
  /// it throws.
  void about_to_change(NodeNumber number, Slot& slot);
  void take_back_record() noexcept;
  /// The node waits to be written, or no longer.
  void set_dirty(Slot& slot, bool dirty) noexcept;
  void back_to(NodeNumber number, const NodeState& state) noexcept;
  /// Nodes that wait, ascending. Cost: a sort of what this transaction has changed, once after each change.
  const std::vector<NodeNumber>& waiting_numbers();
  /// Those that are gone: their rows go, or wait on.
  enum class Gone : std::uint8_t { go, wait };
  /// Nodes that wait, by number.
  void write_nodes(Gone gone);
  /// In the middle of a change.
  void about_to_write_early();
  void hand_change_to_undo_log();
  /// Before memory takes one more node: where the connection holds too many, some go.
  void evict_if_full();
  void drop_unused(std::uint64_t before);

  NodeFormat format_;
  const QualifiedName& name_;
  MemoryShare& share_;
  ShadowRows* shadow_rows_ = nullptr;

  std::unordered_map<NodeNumber, Slot> slots_;
  /// Where slots are, by the last digits of their numbers: a look-up in slots_ misses the processor's caches.
  std::vector<std::pair<NodeNumber, Slot*>> places_;
  TreeHead head_;
  MapChanges map_;
  LeafHints hints_;
  std::optional<IdBlock> last_block_;  ///< that was read, as the rows say
  PackedMap* packed_map_ = nullptr;    ///< in place of map_, while all is loaded anew
  std::optional<IdFilter> filter_;  ///< of all that is stored or waits: of large tables that were just loaded
  std::size_t dirty_ = 0, dirty_held_ = 0;
  std::uint64_t use_ = 1;  ///< moves whenever nodes that were not used are dropped

  UndoLog undo_;
  std::uint64_t newest_keeper_ = 1;  ///< number of the newest mark or change, from 1
  std::uint64_t transaction_ = 1;
  std::vector<NodeNumber> changed_;  ///< in this transaction, some of them repeatedly
  bool dropped_changed_ = false;     ///< … and dropped from memory, once written
  std::vector<NodeNumber> waiting_;  ///< dirty ones, ascending, unless stale
  bool waiting_is_stale_ = false;

  bool in_change_ = false, wrote_in_change_ = false;
  bool wrote_early_ = false;  ///< nodes, in the middle of a change; the others have not followed
  std::vector<std::pair<NodeNumber, NodeState>> change_log_;
  /// Most updates change one record and nothing else: it is kept alone.
  struct {
    NodeNumber leaf = 0;  ///< 0: there is none
    std::size_t slot;
    bool dirty;
    std::vector<double> values;
  } record_before_;
  TreeHead head_before_change_;
  std::size_t map_before_change_ = 0;
  std::shared_ptr<Node> spare_;  ///< room for the next copy of a node
};

}  // namespace foresee
