// A reader of the watch "alerts" that remembers its position and folds the changes, and checks that compare
// the watch with the join.
//
//   WatchReader reader(tolerance);
//   reader.read(db);                        // also after its position has been trimmed
//   reader.expect_rows(db);                 // what it has folded is the watch
//   reader.expect_whole(db);                // and what a new reader is given, number for number
//   expect_joined(db, "h = 10 AND within = 2");
#pragma once

#include <algorithm>
#include <map>
#include <sstream>

#include "sqlite/database.h"

namespace foresee::testing {

/// All nine columns are those of the join at the watch's clock, bit for bit.
inline void expect_joined(Database& db, const std::string& join, const std::string& after = "") {
  const std::string columns = "SELECT a, b, t, t_end, dt, dt_end, t_cpa, dt_cpa, d_cpa FROM ";
  const std::string now = db.rows("SELECT now FROM predictive_watches WHERE name = 'alerts'");
  ASSERT_EQ(db.rows(columns + "alerts ORDER BY a, b"),
            db.rows(columns + "predictive_join WHERE tbl = 'ships' AND now = " + now + " AND " + join +
                    " ORDER BY a, b"))
      << after;
}

/// Between transactions: no fault, and the stored rows are those of the join.
inline void expect_up_to_date(Database& db, const std::string& after = "") {
  ASSERT_EQ(db.rows("SELECT fault FROM predictive_watches WHERE name = 'alerts'"), "NULL") << after;
  ASSERT_EQ(db.error_of("INSERT INTO alerts(alerts) VALUES('integrity-check')"), "") << after;
}

class WatchReader {
 public:
  explicit WatchReader(double tolerance = 0) : tolerance_(tolerance) {}

  void read(Database& db, const std::string& after = "") {
    std::string told = changes(db);
    if (told.find("are no longer kept; read the whole watch") != std::string::npos) {
      position_ = 0;
      told = changes(db);
    }
    if (position_ == 0) folded_.clear();  // the reader gets the whole watch
    std::istringstream lines(told);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(with_spaces(line));
      char op;
      Pair pair;
      double t;
      ASSERT_TRUE(words >> op >> pair.first >> pair.second >> t) << line << after;
      ASSERT_EQ(folded_.contains(pair), op != '+') << line << after;
      if (op == '-')
        folded_.erase(pair);
      else
        folded_[pair] = t;
    }
    position_ = std::stoll(db.rows("SELECT seq FROM predictive_watches WHERE name = 'alerts'"));
  }

  void expect_rows(Database& db, const std::string& after = "") const {
    const double now = std::stod(db.rows("SELECT now FROM predictive_watches WHERE name = 'alerts'"));
    std::istringstream kept(db.rows("SELECT a, b, t FROM alerts"));
    std::size_t pairs = 0;
    for (std::string line; std::getline(kept, line); ++pairs) {
      std::istringstream words(with_spaces(line));
      Pair pair;
      double t;
      words >> pair.first >> pair.second >> t;
      ASSERT_TRUE(folded_.contains(pair)) << line << after;
      ASSERT_NEAR(std::max(folded_.at(pair), now), t, tolerance_) << line << after;
    }
    ASSERT_EQ(pairs, folded_.size()) << after;
  }

  void expect_whole(Database& db, const std::string& after = "") const {
    WatchReader whole;
    whole.read(db, after);
    ASSERT_EQ(folded_, whole.folded_) << after;
  }

 private:
  using Pair = std::pair<std::int64_t, std::int64_t>;

  static std::string with_spaces(std::string row) {
    std::replace(row.begin(), row.end(), '|', ' ');
    return row;
  }

  std::string changes(Database& db) const {
    return db.rows("SELECT op, a, b, ifnull(t, 0) FROM predictive_changes('alerts', " +
                   std::to_string(position_) + ")");
  }

  double tolerance_;
  std::int64_t position_ = 0;
  std::map<Pair, double> folded_;
};

}  // namespace foresee::testing
