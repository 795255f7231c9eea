// Baseline without foresee: base table and R*Tree of swept boxes (sql_rival.h), and a trigger. The trigger
// finds the pairs of each object that is updated, compares them with those in a table, and logs the
// difference.
//
// Its boxes are swept, and its contacts computed, during the horizon from 0 on: such a trigger cannot move
// its clock.
#pragma once

#include "reports/table.h"
#include "sql_rival.h"

namespace foresee::bench {

class TriggeredPairs {
 public:
  /// Tables, pairs and trigger in `db`, which has no such table yet. `objects`: of a feed, two axes; outlives
  /// this.
  TriggeredPairs(Database& db, const Workload& objects);

  /// All of `writes` from `first` on, `count` of them, in one transaction.
  void update_all(const Writes& writes, std::size_t first, std::size_t count);

 private:
  Database& db_;
  int columns_;
  Rival rival_;
  std::unique_ptr<Statement> box_, object_;
};

}  // namespace foresee::bench
