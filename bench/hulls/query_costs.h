// Cost of the same query on several tables, one after another in each repetition.
#pragma once

#include "measure.h"
#include "sql.h"

namespace foresee::bench {

/// A prepared query; its first column is a number of rows.
struct TimedQuery {
  TimedQuery(Database& db, const std::string& sql) : statement(db, sql) {}

  Statement statement;
  std::vector<double> seconds = {};
  std::int64_t rows = 0;
};

/// `predicate` steps through the query once, or once for each value that it binds.
template <class Predicate>
void query_in_turns(const std::vector<TimedQuery*>& questions, int repetitions, Predicate&& predicate) {
  for (int i = 0; i <= repetitions; ++i)
    for (TimedQuery* question : questions) {
      question->rows = 0;
      const double seconds = seconds_of([&] { predicate(*question); });
      if (i > 0) question->seconds.push_back(seconds);
    }
}

/// Steps through all rows, whose numbers are added up.
inline void step_through(TimedQuery& question) {
  while (question.statement.step()) question.rows += question.statement.integer(0);
}

}  // namespace foresee::bench
