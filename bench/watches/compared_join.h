// Baseline without a watch: pairs and changes in ordinary tables, which are joined again and compared after
// every change.
//
//   ComparedJoin compared(db, "predictive_join(3, 'ships')");
//   db.run("BEGIN"); …reports…; compared.update(); db.run("COMMIT");
#pragma once

#include <memory>
#include <vector>

#include "sql.h"

namespace foresee::bench {

class ComparedJoin {
 public:
  /// Makes its tables in `db` and fills them. `join` has the columns a, b, t and dt.
  ComparedJoin(Database& db, const std::string& join);

  /// Within a transaction. A pair that touches already is not reported again as the clock advances.
  void update();

 private:
  Statement* add(const std::string& sql);

  Database& db_;
  std::vector<std::unique_ptr<Statement>> all_;
  Statement *clear_, *join_, *log_gone_, *log_others_, *position_, *erase_, *put_;
};

/// Throws Error unless its pairs are the rows of the watch "alerts" in the other database.
void require_same_pairs(Database& compared, Database& watched);

}  // namespace foresee::bench
