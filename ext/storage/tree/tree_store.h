// One TPR-tree of a table: changes of objects that wait, the tree over nodes in memory, and their rows.
//
//   TreeStore tree(db, format, name, 60, journal, memory, [] {});
//   tree.connect(rows);
//   tree.insert(42, record);                    // within a change: a mark of the journal
//   tree.merge_pending(TreeStore::Reason::commit, interrupt);    // the same
//   tree.write(interrupt);
//
// A table may have several, each over its own TreeRows, all under the journal of the table. So a rollback restores
// them together, and this class has no undo of its own.
//
//   write       ─► PendingObjects ─► tree over NodeCache (nodes, IdMap) ─► rows, once per transaction
//   read        ─► pending objects, else the cache, else the rows
//
// Errors: SQLITE_CORRUPT_VTAB for rows that are damaged or contradict one another. Blobs are checked when read.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <unordered_set>

#include "base/float_environment.h"
#include "index/tpr_tree/tpr_tree.h"
#include "storage/nodes/node_cache.h"
#include "storage/nodes/pending_objects.h"

namespace foresee {

class ObjectSpill;

class TreeStore final : private MemoryHolder {
 public:
  /// `name` is the table name in messages; it, the journal and the budget must outlive the tree. `write_out`
  /// writes everything that waits, if the budget wants it.
  TreeStore(sqlite3* db, const NodeFormat& format, const QualifiedName& name, double horizon,
            Journal& journal, MemoryBudget& memory, std::function<void()> write_out);
  /// Reads and writes these rows from now on.
  void connect(TreeRows& rows) {
    rows_ = &rows;
    cache_.connect(rows);
  }

  const NodeFormat& format() const { return format_; }
  NodeCache& nodes() { return cache_; }
  const PendingObjects& pending() const { return pending_; }
  bool has_unwritten() const { return !pending_.is_empty() || cache_.has_unwritten(); }
  void note_memory() noexcept;

  // --- changes; requires: in a change
  /// Requires: no object has this id. Atomic, so that it may be outside a change.
  void insert(std::int64_t id, std::span<const double> record);
  /// False if there is no such object.
  bool update(std::int64_t id, std::span<const double> record);
  /// False if there is no such object.
  bool erase(std::int64_t id);
  /// Puts a new object in the place of another one in the tree (TprTree::replace()). False: nothing has changed.
  bool replace(std::int64_t id, std::int64_t new_id, std::span<const double> record);
  /// Why pending objects go into the tree: a query or command needs it, memory is full, or the transaction ends.
  enum class Reason : std::uint8_t { query, memory, commit };
  /// Moves all pending changes into the tree: in memory, as far as the budget allows. If memory is full in the
  /// middle of a large load, they become a run beside the other objects (TprTree::add_run()); the commit packs
  /// everything once. Does nothing unless must_merge().
  void merge_pending(Reason reason, Interrupt& interrupt);
  /// True if merge_pending() has something to do.
  bool must_merge(Reason reason) const {
    return !pending_.is_empty() || (reason == Reason::commit && has_runs_.get());
  }
  /// Writes all nodes, the map and the root. Requires: nothing is pending. If it fails half-way the rest stays
  /// unwritten; writing the same again is harmless.
  void write(Interrupt& interrupt);

  // --- reading
  /// The record of a stored object, read without the cache; false: no such object.
  bool read_stored(std::int64_t id, std::vector<double>& record);
  using UseLeaf = std::function<void(const Node& leaf)>;
  /// Reads every leaf once, by ascending number, without pending objects: from memory if it is dirty, else
  /// from its row, checked.
  void read_leaves(Interrupt& interrupt, const UseLeaf& use);
  /// Reads only the leaves of these numbers, through the cache.
  void read_leaves(std::span<const NodeNumber> numbers, Interrupt& interrupt, const UseLeaf& use);
  /// Reads the next leaf with objects after leaf `after` (0: the first one). Returns its number, or 0 at the end.
  NodeNumber next_leaf(NodeNumber after, Node& leaf);
  /// Throws if the map, when written, has another count of objects.
  void require_as_many(std::size_t found);
  /// Returns body(), an operation of the tree. Where it finds that nodes contradict each other, this throws
  /// SQLITE_CORRUPT_VTAB. The operation runs under FloatEnvironment, because it rounds bounds outward.
  template <class Body>
  auto reporting_damage(Body body) const {
    const FloatEnvironment environment;
    try {
      return body();
    } catch (const BrokenTree& error) {
      throw_damaged(name_, error.what());
    }
  }

  using UseObject = std::function<bool(std::int64_t id, const double* record)>;
  using EachObject = std::function<void(const UseObject&)>;
  class Replacement;
  /// Builds the tree again from its stored leaves alone.
  class Rebuild;

 private:
  /// How pending objects enter the tree: as a run beside the others, by a merge into its leaves, or with all others
  /// in a tree that is built again.
  enum class Placement : std::uint8_t { run, merge, load };

  void write_out() override { write_out_(); }
  void drop_nodes(bool all) override { cache_.drop_nodes(all); }
  void merge_records(Reason reason, Interrupt& interrupt);
  Placement placement_of_pending(double stored, bool is_large, Reason reason, Interrupt& interrupt) const;
  /// The tree is loaded if a larger share of its objects has changed, unless arrive_in_place(). It differs between
  /// transactions: a hash of a record decides.
  double min_loaded(bool is_large) const;
  /// TprTree::arrive_in_place() of the pending objects; false if all are new.
  bool arrive_in_place(Interrupt& interrupt) const;
  /// In a commit: queries of a transaction should not wait for it.
  void repack_dispersed(std::span<const std::int64_t> erased);
  void add_run(Interrupt& interrupt);
  void note_packed() {
    changes_ = 0;
    if (has_runs_.get()) has_runs_.change() = false;
  }
  void reload(Interrupt& interrupt);
  /// As reload(), for more objects than may be sorted together.
  void load_partitioned(Interrupt& interrupt);
  void append_pending(std::vector<std::int64_t>& ids, std::vector<double>& records) const;
  /// The pending objects as arrays, without a copy if they have no holes.
  template <class Use>
  auto with_pending(Use use) const;
  /// False for an inner node. Throws if the node is not sound.
  bool is_sound_leaf(std::int64_t number, std::span<const std::byte> blob) const;
  /// Sorts the ids; throws if one is repeated.
  void require_unique(std::vector<std::int64_t>& ids, Interrupt& interrupt) const;

  sqlite3* db_;
  NodeFormat format_;
  const QualifiedName& name_;
  std::function<void()> write_out_;
  MemoryShare share_;
  TreeRows* rows_ = nullptr;
  NodeCache cache_;
  std::unique_ptr<TprTree> tree_;
  PendingObjects pending_;
  Journaled<bool> has_runs_;         ///< added by this transaction
  Journaled<bool> pending_updates_;  ///< some of the pending objects may be in the tree already
  std::size_t changes_ = 0;          ///< merged since the last commit that merged any
};

/// All objects again, from a source that can be read again. If they exceed the memory for sorting, it is read twice
/// more: for the ids and a sample, and into a temporary file. Nothing is written to the table before write().
class TreeStore::Replacement {
 public:
  Replacement(TreeStore& tree, Interrupt& interrupt);
  ~Replacement();

  /// Throws if an id is there twice. `for_each`: calls its argument for every object, until it returns false.
  void read(const EachObject& for_each);
  /// read() of objects that exceed that memory. `newest`: as in TprTree::divide().
  void partition(const EachObject& for_each, std::span<const double> newest);

  std::size_t objects() const { return objects_; }
  /// Replaces all objects, whatever is stored. Requires: in a change.
  void write();

 private:
  bool read_into_memory(const EachObject& for_each);

  TreeStore& tree_;
  Interrupt& interrupt_;
  std::size_t objects_ = 0;
  std::vector<std::int64_t> ids_;
  std::vector<double> records_;
  // Of more objects than may be sorted together:
  IdSum seen_;
  std::unique_ptr<ObjectSpill> spill_;
};

/// Reads and checks every leaf when it is made, whether or not the tree refers to it; the contents of inner nodes
/// are ignored, damaged ones too. Nothing is written before write().
class TreeStore::Rebuild {
 public:
  Rebuild(TreeStore& tree, Interrupt& interrupt);

  std::size_t objects() const { return replacement_.objects(); }
  /// The outlines or meshes in use, in a layout with them.
  const std::unordered_set<std::int64_t>& forms() const { return forms_; }
  /// Replaces the tree. Requires: in a change.
  void write() { replacement_.write(); }

 private:
  void read_leaves(const UseObject& use);
  void require_leaves_of_map();

  TreeStore& tree_;
  Interrupt& interrupt_;
  std::unordered_set<std::int64_t> forms_;
  std::map<NodeNumber, std::string> damaged_nodes_;  ///< with what is wrong
  Replacement replacement_;                          ///< which reads the leaves when it is made
};

}  // namespace foresee
