// What a watch keeps: the rows of its pairs, and the log of what was reported.
//
//   pairs.write_pair({.a = 1, .b = 2, .t = 95, .due = 105, .told = 95, .held = true}, PairWrite::adds, false);
//   log.append({.seq = 7, .op = '+', .a = 1, .b = 2, .t = 95, .now = 0});
//
// A settlement (settlement.h) reads and writes through these interfaces. Shadow tables of a database implement
// them (sqlite/watch/watch_rows.h), and so does memory in tests.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "query/watch/watched_pair.h"

namespace foresee {

/// What writing a pair does to its row.
enum class PairWrite : std::uint8_t {
  adds,     ///< a new row
  moves,    ///< only times change, and no index does
  changes,  ///< any other change
};

class WatchPairs {
 public:
  virtual ~WatchPairs() = default;

  /// In order of (a, b).
  virtual std::vector<WatchedPair> pairs() = 0;
  virtual std::vector<WatchedPair> pairs_of_a(std::int64_t id) = 0;
  virtual std::vector<WatchedPair> pairs_of_b(std::int64_t id) = 0;
  /// Those of this state whose `due` is at most `until`, in any order.
  virtual std::vector<WatchedPair> due_pairs(bool held, double until) = 0;
  virtual std::optional<WatchedPair> pair(std::int64_t a, std::int64_t b) = 0;

  /// `with_told`: otherwise `told` is t and needs no room.
  virtual void write_pair(const WatchedPair& pair, PairWrite how, bool with_told) = 0;
  virtual void erase_pair(std::int64_t a, std::int64_t b) = 0;
  virtual void erase_all_pairs() = 0;
};

struct LoggedChange {
  std::int64_t seq;
  char op;  ///< '+', '~' or '-'
  std::int64_t a, b;
  double t;  ///< not kept for a removed pair
  double now;
};

class WatchLog {
 public:
  virtual ~WatchLog() = default;

  virtual void append(const LoggedChange& change) = 0;
  /// Removes the changes up to this number.
  virtual void trim(std::int64_t up_to) = 0;
};

}  // namespace foresee
