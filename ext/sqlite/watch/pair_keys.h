// Keys of a watch's pairs beside (a, b): by b, and by the time at which they are due, in tables of their own.
//
//   <name>_back(b, a, PRIMARY KEY(b, a)) WITHOUT ROWID
//   <name>_due(state, due, a, b, PRIMARY KEY(state, due, a, b)) WITHOUT ROWID    without pairs that are never due
//
//   keys.add(pair);  keys.erase(other);                // waits
//   keys.write();                                      // in key order, once per update
//
// SQLite writes an index row by row, in the order of the table. A commit of many pairs then touches its pages at
// random, and each may be read and written many times. A watch of format 1 or 2 has such indexes; this class only
// reads them.
//
// Guarantee: after write() the tables hold the keys of exactly the pairs added and not erased. Cost: a row each.
#pragma once

#include <vector>

#include "database/shadow_tables.h"
#include "query/watch/pair_contacts.h"
#include "query/watch/watch_state.h"

namespace foresee {

class PairKeys {
 public:
  static std::vector<ShadowTable> tables();

  /// Uses the tables of a watch from now on. `in_tables`: else indexes of the table of pairs have the keys.
  void connect(const ShadowTables& tables, bool in_tables);

  // --- reading; requires: nothing waits
  /// The pairs with this b, in order of a.
  void append_of_b(std::int64_t b, std::vector<PairIds>& pairs);
  /// The pairs of this state whose `due` is at most `until`, in order of `due`.
  std::vector<PairIds> due(PairState state, double until);
  /// Whether the keys are those of exactly these pairs.
  bool agree(std::vector<WatchedPair> pairs);

  // --- writing: keys wait in memory until write()
  void add(const WatchedPair& pair);
  void erase(const WatchedPair& pair);
  /// The keys of a row that changes. Requires: the same a and b.
  void change(const WatchedPair& before, const WatchedPair& after);
  /// Erases the keys of all pairs at once, also those that no pair has.
  void erase_all();
  /// Writes what waits. Throws StoreError SQLITE_CONSTRAINT for a key that is there already.
  void write();
  /// Forgets what waits, of an update that failed.
  void forget() {
    back_waits_.clear();
    due_waits_.clear();
  }

 private:
  struct BackKey {
    std::int64_t b, a;
    bool adds;
    auto operator<=>(const BackKey&) const = default;
  };
  struct DueKey {
    PairState state;
    double due;
    std::int64_t a, b;
    bool adds;
    auto operator<=>(const DueKey&) const = default;
  };

  /// Of one table of keys. `found`: those of one b, or the due ones.
  struct KeyStatements {
    Statement found, all, add, erase, erase_all;
  };

  void note_due(const WatchedPair& pair, bool adds);
  static bool holds(Statement& keys, const std::vector<WatchedPair>& pairs, bool with_due);

  bool in_tables_ = false;
  KeyStatements back_, due_;
  std::vector<BackKey> back_waits_;
  std::vector<DueKey> due_waits_;
};

}  // namespace foresee
