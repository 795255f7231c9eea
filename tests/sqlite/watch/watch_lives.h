// Random sequences of transactions on watched tables: scenes of every shape, law of motion and option.
//
//   LifeScript script(watch_lives()[0], seed);
//   db.exec(script.tables());
//   db.exec(script.next());               // one transaction, or one that is rolled back
#pragma once

#include <random>
#include <string>
#include <vector>

namespace foresee::testing {

struct WatchLife {
  const char* name;
  const char* columns;  ///< of a table, after the id
  /// Values of an object: N is a whole number of the scene, V a speed, S a size or a choice, T the time.
  const char* values;
  const char* options;
  const char* join;  ///< the inputs of the equivalent predictive_join, after now
  const char* other_columns = nullptr;
  const char* other_values = nullptr;
  double tolerance = 0;
};

/// Numbers are whole, so that some contacts start at the end of the horizon and end at the clock.
const std::vector<WatchLife>& watch_lives();

class LifeScript {
 public:
  LifeScript(const WatchLife& life, unsigned seed) : life_(life), random_(seed) {}

  /// Statements that create the tables and the watch.
  std::string tables() const;
  /// The next transaction, mostly short: changes, advances, savepoints, rollbacks, a merge.
  std::string next();
  /// Changes of a transaction, without its BEGIN and COMMIT.
  std::string changes(int max_count);
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

 private:
  std::string values(const char* pattern);
  std::string change();
  std::string advance();

  const WatchLife& life_;
  std::mt19937 random_;
  int time_ = 0;
};

}  // namespace foresee::testing
