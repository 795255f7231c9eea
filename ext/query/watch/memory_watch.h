// A watch in memory: the pairs that will touch and the log of their changes, for applications that embed the core.
//
//   MemoryWatch watch;
//   WatchState state;
//   static_cast<WatchDeclaration&>(state) = {.tbl = "units", .horizon = 10, .within = 1};
//   PairUpdate update({units}, state, watch, {interrupt});            // after each tick
//   if (const auto after = update.run()) state = *after;
//   units->commit();
//   for (const LoggedChange& change : watch.take_log()) use(change.op, change.a, change.b, change.t);
//
// Pairs are indexed by a, by b and by the time at which they are due. Cost: less than a microsecond per pair that is
// read or written. docs/examples/game.cpp is a program. A failed update may have written some of its changes: set
// `must_rebuild` of the state then.
#pragma once

#include <deque>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "query/watch/watch_state.h"

namespace foresee {

class MemoryWatch : public WatchStorage {
 public:
  using Ids = std::pair<std::int64_t, std::int64_t>;  ///< a, b

  std::vector<WatchedPair> pairs() override;
  std::vector<WatchedPair> stored_pairs_of(std::span<const std::int64_t> a,
                                           std::span<const std::int64_t> b) override;
  std::vector<WatchedPair> due_pairs(PairState state, double until) override;
  std::optional<WatchedPair> pair(std::int64_t a, std::int64_t b) override;
  void write_pair(const WatchedPair* before, const WatchedPair& pair, bool with_reported_t) override;
  void erase_pair(const WatchedPair& pair) override;
  void erase_all_pairs() override;
  void append(const LoggedChange& change) override { log_.push_back(change); }
  void trim(std::int64_t up_to) override;

  /// All pairs, in order of (a, b). Only those that are reported (WatchedPair::is_reported) start within the horizon.
  const std::map<Ids, WatchedPair>& rows() const { return rows_; }
  /// The changes that were not taken yet, oldest first, at most WatchDeclaration::keep.
  const std::deque<LoggedChange>& log() const { return log_; }
  /// log(), which is then empty.
  std::deque<LoggedChange> take_log() { return std::exchange(log_, {}); }

 private:
  using Due = std::tuple<PairState, double, Ids>;
  static Due due_of(const WatchedPair& pair) { return {pair.state, pair.due, {pair.a, pair.b}}; }

  std::map<Ids, WatchedPair> rows_;
  std::set<Ids> by_b_;  ///< (b, a)
  std::set<Due> by_due_;
  std::deque<LoggedChange> log_;
};

}  // namespace foresee
