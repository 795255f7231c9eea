// How much memory do all tables of one connection hold together, and who gives some back?
//
//   auto budget = std::make_shared<MemoryBudget>(limits);       // one a connection: memory_budget_of(db)
//   MemoryShare share(*budget, table);                          // one a table
//   share.hold_pending(bytes), share.hold_nodes(waiting, map, kept);    // as it is now
//   if (budget->too_much_waits()) budget->write_out();          // every table writes what waits
//   budget->evict();                                            // every table drops what it can read again
//
// Guarantee: a limit is one for all tables of the connection, so a transaction that fills many of them needs
// no more memory than one that fills a single one. Cost: an addition where a table's part changes.
#pragma once

#include <cstddef>
#include <vector>

namespace foresee {

struct MemoryLimits {
  std::size_t pending = 128 << 20;  ///< bytes of objects that wait for the tree
  std::size_t memory = 128 << 20;   ///< bytes of nodes that are kept, or of changes that wait, roughly
  /// … of nodes that wait while one change puts many. What waits can be taken back, so that whoever
  /// interrupts a question loses nothing: room for as many new objects as may be pending, not for a large old
  /// tree beside.
  std::size_t waiting = 128 << 20;
  /// … of objects that are put in order together for new leaves; of more a part is, and the others wait in a
  /// temporary file.
  std::size_t ordered = 64 << 20;
};

/// A table, as far as its memory goes.
class MemoryHolder {
 public:
  /// Writes what waits, unless the table is in the middle of a change.
  virtual void write_out() = 0;
  /// Drops nodes that can be read again: those that were not used since the last time, or all.
  virtual void drop_nodes(bool all) = 0;

 protected:
  ~MemoryHolder() = default;
};

class MemoryBudget {
 public:
  explicit MemoryBudget(const MemoryLimits& limits = {}) : limits_(limits) {}

  std::size_t max_kept() const { return limits_.memory; }
  std::size_t max_ordered() const { return limits_.ordered; }
  bool too_much_waits() const { return pending_ > limits_.pending || waiting_ + map_ > limits_.memory; }
  /// … to put more of them in the middle of a change, of a table that holds `own` bytes of them: enough to be
  /// worth writing.
  bool too_many_nodes_wait(std::size_t own) const {
    return waiting_ > limits_.waiting && own > limits_.waiting / 8;
  }
  void write_out();
  /// Does nothing while there is room.
  void evict();

 private:
  friend class MemoryShare;

  MemoryLimits limits_;
  std::size_t pending_ = 0, waiting_ = 0, map_ = 0, kept_ = 0;
  std::size_t evict_at_ = 0;  ///< where most of what is kept could not be dropped the last time
  std::vector<MemoryHolder*> holders_;
};

/// What one table holds. The budget must outlive it.
class MemoryShare {
 public:
  MemoryShare(MemoryBudget& budget, MemoryHolder& holder);
  ~MemoryShare();
  MemoryShare(const MemoryShare&) = delete;
  MemoryShare& operator=(const MemoryShare&) = delete;

  MemoryBudget& budget() { return budget_; }
  void hold_pending(std::size_t bytes) noexcept { replace(budget_.pending_, pending_, bytes); }
  /// Nodes that wait, changes of the map, and all nodes in memory, those that wait among them.
  void hold_nodes(std::size_t waiting, std::size_t map, std::size_t kept) noexcept {
    replace(budget_.waiting_, waiting_, waiting);
    replace(budget_.map_, map_, map);
    replace(budget_.kept_, kept_, kept);
  }

 private:
  static void replace(std::size_t& total, std::size_t& own, std::size_t now) noexcept {
    total += now - own;
    own = now;
  }

  MemoryBudget& budget_;
  MemoryHolder& holder_;
  std::size_t pending_ = 0, waiting_ = 0, map_ = 0, kept_ = 0;
};

}  // namespace foresee
