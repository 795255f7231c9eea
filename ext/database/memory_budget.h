// Memory budget of a connection, shared by all its tables: limits, what each table holds, and when tables
// write or evict.
//
//   auto budget = std::make_shared<MemoryBudget>(limits);       // one per connection: memory_budget_of(db)
//   MemoryShare share(*budget, table);                          // one per table
//   share.hold_pending(bytes), share.hold_nodes(waiting, map, kept);    // current figures
//   if (budget->too_much_waits()) budget->write_out();          // every table writes its changes
//   budget->evict();                                            // every table drops clean nodes
//
// Guarantee: each limit holds for all tables of the connection together, so a transaction that fills many tables needs
// no more memory than one that fills a single table. Not counted: the states of nodes that an open query still reads
// while others change them (nodes/node_history.h), the filter of ids (id_filter.h), and the hints of leaves
// (nodes/leaf_hints.h). Cost: an addition per change of a table's figures.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foresee {

struct MemoryLimits {
  std::size_t pending = 128 << 20;  ///< bytes of objects that are not in the tree yet
  std::size_t memory = 128 << 20;   ///< approximate bytes of nodes in memory, or of unwritten changes
  /// Bytes of unwritten nodes while one change adds many. Unwritten nodes can be rolled back, so an
  /// interrupted query loses nothing. The limit covers as many new objects as may be pending, but not a large
  /// old tree besides.
  std::size_t waiting = 128 << 20;
  /// Bytes of objects that are sorted together for new leaves. A larger table is divided into partitions, and
  /// the others wait in a temporary file.
  std::size_t ordered = 64 << 20;
};

/// A table as a user of memory.
class MemoryHolder {
 public:
  /// Writes all changes, unless the table is in the middle of one.
  virtual void write_out() = 0;
  /// Drops clean nodes: those not used since the last call, or all.
  virtual void drop_nodes(bool all) = 0;

 protected:
  ~MemoryHolder() = default;
};

class MemoryBudget {
 public:
  explicit MemoryBudget(const MemoryLimits& limits = {}) : limits_(limits) {}

  std::size_t max_kept() const { return limits_.memory; }
  std::size_t max_waiting() const { return limits_.waiting; }
  std::size_t max_ordered() const { return limits_.ordered; }
  bool too_much_waits() const { return pending_ > limits_.pending || waiting_ + map_ > limits_.memory; }
  /// True if a table that holds `own` bytes of unwritten nodes should write them during a change. Then the
  /// limit is exceeded, and its own share is worth writing.
  bool too_many_nodes_wait(std::size_t own) const {
    return waiting_ > limits_.waiting && own > limits_.waiting / 8;
  }
  /// True if so many bytes of changes should be written during a change, not at its end.
  bool too_much_would_wait(std::size_t bytes) const { return bytes > limits_.waiting; }
  void write_out();
  /// Does nothing within the limit.
  void evict();

 private:
  friend class MemoryShare;

  MemoryLimits limits_;
  std::size_t pending_ = 0, waiting_ = 0, map_ = 0, kept_ = 0;
  std::size_t evict_at_ = 0;  ///< raised if the last eviction could not drop enough
  std::vector<MemoryHolder*> holders_;
};

/// One table's share of the budget. The budget must outlive it.
class MemoryShare {
 public:
  MemoryShare(MemoryBudget& budget, MemoryHolder& holder);
  ~MemoryShare();
  MemoryShare(const MemoryShare&) = delete;
  MemoryShare& operator=(const MemoryShare&) = delete;

  MemoryBudget& budget() const { return budget_; }
  void hold_pending(std::size_t bytes) noexcept { replace(budget_.pending_, pending_, bytes); }
  /// Unwritten nodes, changes of the map, and all nodes in memory including the unwritten ones.
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

inline void MemoryBudget::write_out() {
  // By index: a trigger on a shadow table may open more tables meanwhile.
  for (std::size_t i = 0; i < holders_.size(); ++i) holders_[i]->write_out();
}

inline void MemoryBudget::evict() {
  const std::size_t limit = limits_.memory;
  if (kept_ < limit) evict_at_ = 0;
  if (kept_ < std::max(limit, evict_at_)) return;
  for (MemoryHolder* holder : holders_) holder->drop_nodes(false);
  if (kept_ > limit / 2)
    for (MemoryHolder* holder : holders_) holder->drop_nodes(true);
  evict_at_ = kept_ + limit / 8;
}

inline MemoryShare::MemoryShare(MemoryBudget& budget, MemoryHolder& holder)
    : budget_(budget), holder_(holder) {
  budget_.holders_.push_back(&holder);
}

inline MemoryShare::~MemoryShare() {
  hold_pending(0);
  hold_nodes(0, 0, 0);
  std::erase(budget_.holders_, &holder_);
}

}  // namespace foresee
