// The modes of bench_sql_watch, one file each; sql_watch.cpp describes what they measure.
#pragma once

#include <cstdio>
#include <string>

#include "program.h"

namespace foresee::bench {

enum class Bound { at_least, at_most };

/// A line of the table: a ratio measured in this run, beside its goal.
inline void print_figure(const std::string& what, double ratio, Bound bound, double goal) {
  const bool reached = bound == Bound::at_least ? ratio >= goal : ratio <= goal;
  std::printf("%-76s %8.2f   goal %s %g%s\n", what.c_str(), ratio,
              bound == Bound::at_least ? ">=" : "<=", goal, reached ? "" : "   NOT REACHED");
  std::fflush(stdout);
}

/// The same without a goal: beside a method that does not do all that the watch does.
inline void print_figure(const std::string& what, double ratio) {
  std::printf("%-76s %8.2f\n", what.c_str(), ratio);
  std::fflush(stdout);
}

/// Every mode prints as it goes and throws Error where two sides that must agree do not.
void measure_watched_reports(const Options& options);
void measure_watch_growth(const Options& options);
void measure_watched_ships(const Options& options);

}  // namespace foresee::bench
